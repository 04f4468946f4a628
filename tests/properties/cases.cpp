#include "properties/cases.h"

#include "support/disks.h"
#include "support/ellipses.h"
#include "support/rectangles.h"
#include "support/samplable.h"
#include "support/stand.h"
#include "support/triangle_lights.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>

namespace hatbox::test {
namespace {

using Vector = reference::Vector<double>;
using rc::gen::inRange;

constexpr float odd_numbers[] = {0.0f,
                                 -0.0f,
                                 1.0f,
                                 0.5f,
                                 1e-45f,
                                 -1e-39f,
                                 1e-30f,
                                 1e30f,
                                 std::numeric_limits<float>::max(),
                                 std::numeric_limits<float>::infinity(),
                                 std::numeric_limits<float>::quiet_NaN()};
constexpr float odd_variates[] = {
    0.0f, -0.0f, 0x1.fffffep-1f, 0.5f, 1e-45f, 1.0f, 2.0f, -1.0f, std::numeric_limits<float>::quiet_NaN()};

template <std::size_t n>
float one_of(const float (&values)[n]) {
  return values[*inRange<std::size_t>(0, n)];
}

/// A multiple of 2^-10.
double between(int low, int high) { return *inRange(1024 * low, 1024 * high + 1) / 1024.0; }

double power_of_two(int low, int high) {
  // From the middle, so that shrinking ends at 1.
  const int middle = low > 0 ? low : high < 0 ? high : 0;
  return std::ldexp(1, middle + *inRange(low - middle, high - middle + 1));
}

double either_sign(double x) { return *inRange(0, 2) ? -x : x; }

/// One of the world's frames, or any.
Frame any_frame() {
  const int kind = *inRange(0, 5);
  const Vector x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  if (kind == 1) return {y, z, x};
  if (kind == 2) return {z, x, y};
  if (kind == 3) return {x, -1.0 * y, -1.0 * z};
  if (kind < 4) return {x, y, z};
  Random random(*inRange<std::uint32_t>(0, 1u << 16));
  return random_frame(random);
}

Stand any_stand(bool gentle) {
  Stand stand;
  stand.axes = any_frame();
  stand.size = gentle ? power_of_two(-20, 20) : power_of_two(-100, 100);  // 1e-30 to 1e30
  stand.aspect = 1 - *inRange(0, 768) / 1024.0;
  if (!gentle && *inRange(0, 3) == 2) stand.aspect = power_of_two(-18, 0);
  if (*inRange(0, 2)) {
    const double away = stand.size * (gentle ? 1 : power_of_two(-10, 10));
    stand.origin = {away * between(-2, 2), away * between(-2, 2), away * between(-2, 2)};
  }
  return stand;
}

AnyLight light_at(const Stand& stand, std::size_t kind) {
  switch (kind) {
    case 0: return stand.disk();
    case 1: return stand.ellipse();
    case 2: return stand.rectangle();
    default: return stand.triangle(between(-1, 1));
  }
}

/// Any numbers: hardly ever a light of the other kinds.
Disk odd_disk() {
  const auto vector = [] { return Vec3{one_of(odd_numbers), one_of(odd_numbers), one_of(odd_numbers)}; };
  return {vector(), vector(), one_of(odd_numbers)};
}

std::string_view complaint(const AnyLight& light) {
  return std::visit([](const auto& one) { return check(one); }, light);
}

/// The vectors of a light that are in world units.
std::vector<Vec3*> lengths(AnyLight& light) {
  if (auto* disk = std::get_if<Disk>(&light)) return {&disk->center};
  if (auto* ellipse = std::get_if<Ellipse>(&light)) {
    return {&ellipse->center, &ellipse->semi_axis_u, &ellipse->semi_axis_v};
  }
  if (auto* rectangle = std::get_if<Rectangle>(&light)) {
    return {&rectangle->corner, &rectangle->edge_u, &rectangle->edge_v};
  }
  auto& triangle = std::get<Triangle>(light);
  return {&triangle.a, &triangle.b, &triangle.c};
}

Vec3 any_point(const Stand& stand) {
  const double angle = std::numbers::pi / 8 * *inRange(0, 16), c = std::cos(angle), s = std::sin(angle);
  const auto low = [] { return either_sign(power_of_two(-120, 0)); };
  const auto aside = [] { return 1 + either_sign(power_of_two(-30, -3)); };
  switch (*inRange(0, 10)) {
    case 0: return rounded(stand.at(between(-3, 3), between(-3, 3), between(-3, 3)));
    case 1: return rounded(stand.at(between(-3, 3), between(-3, 3), 0));                        // in the plane
    case 2: return rounded(stand.at(aside() * c, stand.aspect * aside() * s, low()));           // at the rim
    case 3: return rounded(stand.at(0, 0, low()));                                              // centre, corner
    case 4: return rounded(stand.at(*inRange(0, 2), stand.aspect * *inRange(0, 2), low()));     // corners
    case 5: return rounded(stand.at(between(-1, 1), stand.aspect * between(-1, 1), low()));     // a hair above
    case 6: return rounded(stand.at(power_of_two(0, 30) * c, power_of_two(0, 30) * s, low()));  // grazing
    case 7: return rounded(stand.at(between(-3, 3), between(-3, 3), either_sign(power_of_two(0, 60))));
    case 8: return {one_of(odd_numbers), one_of(odd_numbers), one_of(odd_numbers)};
    default: break;
  }
  const auto bits = [] { return std::bit_cast<float>(*rc::gen::arbitrary<std::uint32_t>()); };
  return {bits(), bits(), bits()};
}

/// In front of the light at half its size or more, not grazing it.
Vec3 gentle_point(const Stand& stand) {
  return rounded(stand.at(between(-2, 2), between(-2, 2), either_sign(0.5 + between(0, 3))));
}

float any_variate(bool gentle) {
  if (!gentle && *inRange(0, 3) == 2) return one_of(odd_variates);
  return static_cast<float>(*inRange(1, 1024)) / 1024;
}

Case draw(bool gentle) {
  const Stand stand = any_stand(gentle);
  Case result;
  result.light = light_at(stand, *inRange<std::size_t>(0, 4));
  if (!gentle && *inRange(0, 16) == 15) result.light = odd_disk();
  if (!complaint(result.light).empty()) result.light = Disk{{0, 0, 0}, {0, 0, 1}, 1};
  constexpr std::size_t maps[] = {all_disk_maps.size(), all_ellipse_maps.size(), all_rectangle_maps.size(),
                                  all_triangle_maps.size()};
  result.map = *inRange<std::size_t>(0, maps[result.light.index()]);
  const auto lanes = *inRange<std::size_t>(1, 20);
  for (std::size_t i = 0; i < lanes; ++i) {
    result.points.push_back(gentle ? gentle_point(stand) : any_point(stand));
    result.u.push_back(any_variate(gentle));
    result.v.push_back(any_variate(gentle));
  }
  return result;
}

/// Calls visit(light, map).
template <class Visit>
auto with(const Case& c, const Visit& visit) {
  if (const auto* disk = std::get_if<Disk>(&c.light)) return visit(*disk, all_disk_maps[c.map]);
  if (const auto* ellipse = std::get_if<Ellipse>(&c.light)) return visit(*ellipse, all_ellipse_maps[c.map]);
  if (const auto* rectangle = std::get_if<Rectangle>(&c.light)) return visit(*rectangle, all_rectangle_maps[c.map]);
  return visit(std::get<Triangle>(c.light), all_triangle_maps[c.map]);
}

std::ostream& operator<<(std::ostream& out, const Vec3& p) {
  return out << "{" << p.x << ", " << p.y << ", " << p.z << "}";
}
std::ostream& operator<<(std::ostream& out, const Disk& l) {
  return out << "disk " << l.center << l.normal << l.radius;
}
std::ostream& operator<<(std::ostream& out, const Ellipse& l) {
  return out << "ellipse " << l.center << l.semi_axis_u << l.semi_axis_v;
}
std::ostream& operator<<(std::ostream& out, const Rectangle& l) {
  return out << "rectangle " << l.corner << l.edge_u << l.edge_v;
}
std::ostream& operator<<(std::ostream& out, const Triangle& l) { return out << "triangle " << l.a << l.b << l.c; }

}  // namespace

std::string Case::map_name() const {
  return with(*this, [](const auto&, auto of) { return std::string(name(of)); });
}

PointArrays Case::point_arrays() const {
  PointArrays result;
  for (const Vec3& p : points) result.push_back(p);
  return result;
}

Sampler Case::sampler() const {
  return with(*this, [](const auto& one, auto of) { return Sampler(name(of), one, of); });
}

Outline Case::outline() const {
  return std::visit([](const auto& one) { return outline_of(one); }, light);
}

bool Case::samplable(std::size_t i) const {
  const double least = with(*this, [](const auto&, auto of) { return least_height(of); });
  return Samplable::by(u[i], v[i]) && Samplable(outline()).from(points[i], least);
}

bool Case::is_light() const { return complaint(light).empty(); }

Case Case::scaled(float factor) const {
  Case result = *this;
  const auto scale = [&](Vec3& p) { p = {factor * p.x, factor * p.y, factor * p.z}; };
  for (Vec3* p : lengths(result.light)) scale(*p);
  if (auto* disk = std::get_if<Disk>(&result.light)) disk->radius *= factor;
  std::ranges::for_each(result.points, scale);
  return result;
}

bool Case::same_lane(const Case& other, std::size_t i) const {
  const auto same = [](const Vec3& p, const Vec3& q) { return p.x == q.x && p.y == q.y && p.z == q.z; };
  AnyLight here = light, there = other.light;
  const auto a = lengths(here), b = lengths(there);
  bool result = same(points[i], other.points[i]);
  for (std::size_t l = 0; l < a.size(); ++l) result = result && same(*a[l], *b[l]);
  if (const auto* disk = std::get_if<Disk>(&here)) result = result && disk->radius == std::get<Disk>(there).radius;
  return result;
}

Case Case::turned() const {
  Case result = *this;
  const auto turn = [](Vec3& p) { p = {p.y, -p.z, -p.x}; };
  for (Vec3* p : lengths(result.light)) turn(*p);
  if (auto* disk = std::get_if<Disk>(&result.light)) turn(disk->normal);
  std::ranges::for_each(result.points, turn);
  return result;
}

bool Case::continuous_at(std::size_t i) const {
  constexpr float margin = 1e-3f;
  const bool inside = u[i] > margin && u[i] < 1 - margin && v[i] > margin && v[i] < 1 - margin;
  if (map_name() == "two_triangles") return false;  // where it is torn depends on the point
  const bool winds = map_name().starts_with("radial") || std::holds_alternative<Triangle>(light);
  return inside && !(winds && (v[i] < 0.05f || v[i] > 0.95f));
}

double Case::uniformity() const {
  if (std::holds_alternative<Rectangle>(light) || std::holds_alternative<Triangle>(light)) return 4e-6;
  return map_name().ends_with("carlson") || map_name() == "rejection" ? 4e-6 : 1e-4;
}

std::ostream& operator<<(std::ostream& out, const Case& c) {
  out << std::hexfloat;
  std::visit([&](const auto& light) { out << light; }, c.light);
  out << " by " << c.map_name();
  for (std::size_t i = 0; i < c.size(); ++i) out << "\n  " << c.points[i] << " u " << c.u[i] << " v " << c.v[i];
  return out << std::defaultfloat;
}

rc::Gen<Case> any_case() {
  return rc::gen::exec([] { return draw(false); });
}

rc::Gen<Case> gentle_case() {
  return rc::gen::exec([] { return draw(true); });
}

}  // namespace hatbox::test
