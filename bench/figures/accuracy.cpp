// How right the maps are from everywhere: over distance and elevation of the point, for hatbox's kernels and for the
// papers' formulas in scalar float, both against the references in more digits. Writes accuracy.csv.
//
//   cells        how far the solid angles of the images of 16² cells of the square are off, the largest, relative
//   density      how far the density told is off one over the true solid angle, the largest, relative
//   solid_angle  how far the solid angle told is off, relative
//   direction    how far samples are off those of the reference, the largest, over the light's diameter as it is seen
#include "paper_disk_float.h"
#include "reference/disk_eta_reference.h"
#include "reference/rectangle_reference.h"

#include <hatbox/hatbox.h>

#include <tbb/parallel_for.h>

#include <array>
#include <cstdio>
#include <exception>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace hatbox;
using reference::convert;
using reference::cross;
using reference::dot;
using Vector = reference::Vector<double>;

constexpr Disk disk{{0, 0, 0}, {0, 0, 1}, 1};
constexpr Rectangle rectangle{{-1, -0.6f, 0}, {2, 0, 0}, {0, 1.2f, 0}};
constexpr std::size_t cells = 16, corners = cells + 1;

/// What a map makes of the corners of the cells, seen from a point. hatbox is taken at its directions next to the light
/// and at its places further away, as disk.h advises; the papers at their vectors from the point to the place.
struct Told {
  std::vector<Vector> directions = {};
  std::vector<double> pdf = {};
  double solid_angle = 0;
};

struct Square {
  Square() {
    for (std::size_t i = 0; i < corners * corners; ++i) {
      u.push_back(coordinate(i % corners));
      v.push_back(coordinate(i / corners));
    }
  }
  /// The outermost a little inwards: 1 is no variate, and polar maps have a seam.
  static float coordinate(std::size_t i) { return 0x1p-8f + static_cast<float>(i) * (1 - 0x1p-7f) / cells; }
  std::vector<float> u, v;
};
const Square square;

Vector place_on(const Disk&, double s, double t) { return {s, t, 0}; }
Vector place_on(const Rectangle&, double s, double t) { return {-1 + 2 * s, -0.6f + 1.2f * t, 0}; }

template <class Light>
Vector direction_to(const Light& light, const Vec3& point, double s, double t) {
  return reference::normalize(place_on(light, s, t) - convert<double>(point));
}

template <class Light, class Map>
Told by_hatbox(const Light& light, Map map, const Vec3& p) {
  const std::size_t n = square.u.size();
  std::vector<float> x(n), y(n), z(n), distance(n), pdf(n), s(n), t(n);
  const Points at{{&p.x, 1}, {&p.y, 1}, {&p.z, 1}};
  sample(light, map, at, {square.u, square.v}, {x, y, z, distance, pdf, s, t});
  Told told;
  float omega;
  solid_angle(light, at, {&omega, 1});
  told.solid_angle = double{omega};
  const bool near = std::hypot(p.x, p.y, p.z) < 2;
  for (std::size_t i = 0; i < n; ++i) {
    told.directions.push_back(near ? reference::normalize(Vector{double{x[i]}, double{y[i]}, double{z[i]}})
                                   : direction_to(light, p, double{s[i]}, double{t[i]}));
    told.pdf.push_back(double{pdf[i]});
  }
  return told;
}

Told by_paper(const Disk&, const Vec3& p) {
  const float offset = std::hypot(p.x, p.y);
  const figures::PaperDiskFloat paper(offset, p.z);
  Told told{.solid_angle = double{paper.solid_angle()}};
  const double cosine = -double{p.x} / double{offset},
               sine = -double{p.y} / double{offset};  // of the way to the centre
  for (std::size_t i = 0; i < square.u.size(); ++i) {
    const figures::ToPlace q = paper.sample(square.u[i], square.v[i]);
    const double x = double{q.x}, y = double{q.y};
    told.directions.push_back(reference::normalize(Vector{y * cosine - x * sine, y * sine + x * cosine, -double{q.z}}));
  }
  told.pdf.assign(square.u.size(), 1 / told.solid_angle);
  return told;
}

Told by_paper(const Rectangle&, const Vec3& p) {
  const reference::SphQuad<float> paper({-1, -0.6f, 0}, {2, 0, 0}, {0, 1.2f, 0}, convert<float>(p));
  Told told{.solid_angle = double{paper.S}};
  for (std::size_t i = 0; i < square.u.size(); ++i)
    told.directions.push_back(reference::normalize(convert<double>(paper.local(square.u[i], square.v[i]))));
  told.pdf.assign(square.u.size(), 1 / told.solid_angle);
  return told;
}

Told exactly(const Disk& light, DiskMap map, const Vec3& p, double& diameter) {
  const reference::EtaDisk exact(reference::DiskFrame<long double>(light), p);
  Told told{.solid_angle = exact.solid_angle()};
  for (std::size_t i = 0; i < square.u.size(); ++i) {
    const auto sample = exact.sample(map, square.u[i], square.v[i]);
    told.directions.push_back(direction_to(light, p, sample.s, sample.t));
  }
  diameter = 2 * std::atan2(exact.semi_axes().a, exact.semi_axes().cos_alpha);
  return told;
}

Told exactly(const Rectangle& light, RectangleMap, const Vec3& p, double& diameter) {
  const reference::RectangleReference exact(light, p);
  Told told{.solid_angle = static_cast<double>(exact.solid_angle())};
  for (std::size_t i = 0; i < square.u.size(); ++i)
    told.directions.push_back(convert<double>(exact.sample(square.u[i], square.v[i]).direction));
  diameter = static_cast<double>(exact.diameter());
  return told;
}

/// Of a spherical triangle (van Oosterom and Strackee 1983), with differences, which keep it right for small ones.
double triangle(const Vector& a, const Vector& b, const Vector& c) {
  return 2 * std::atan2(dot(a, cross(b - a, c - a)), 1 + dot(a, b) + dot(b, c) + dot(c, a));
}

double cell(const std::vector<Vector>& at, std::size_t i) {
  return triangle(at[i], at[i + 1], at[i + corners + 1]) + triangle(at[i], at[i + corners + 1], at[i + corners]);
}

/// The greater one, or NaN if either is: the papers' formulas in float may come to nothing.
void raise(double& largest, double error) {
  if (!(error <= largest)) largest = std::isnan(largest) ? largest : error;
}

std::array<double, 4> errors(const Told& told, const Told& exact, double diameter) {
  double of_cells = 0, of_density = 0, of_direction = 0;
  for (std::size_t i = 0; i < corners * corners; ++i) {
    raise(of_density, std::abs(told.pdf[i] * exact.solid_angle - 1));
    raise(of_direction, angle_between(told.directions[i], exact.directions[i]) / diameter);
    if (i % corners < cells && i / corners < cells)
      raise(of_cells, std::abs(cell(told.directions, i) / cell(exact.directions, i) - 1));
  }
  return {of_cells, of_density, std::abs(told.solid_angle / exact.solid_angle - 1), of_direction};
}

using Rows = std::string;

template <class Light, class Map>
Rows rows_at(const char* light_name, const Light& light, const char* map_name, Map map, bool paper, const Vec3& p,
             double distance, double elevation) {
  double diameter = 0;
  const Told exact = exactly(light, map, p, diameter);
  Rows rows;
  const auto add = [&](const std::string& name, const Told& told) {
    const auto e = errors(told, exact, diameter);
    char row[256];
    std::snprintf(row, sizeof row, "%s,%s,%.6g,%.6g,%.4g,%.4g,%.4g,%.4g\n", light_name, name.c_str(), distance,
                  elevation, e[0], e[1], e[2], e[3]);
    rows += row;
  };
  add(map_name, by_hatbox(light, map, p));
  if (paper) add("paper_float", by_paper(light, p));
  return rows;
}

/// 7 · steps + 1 distances from 0.01 to 10^5, one of them 1, where the rim is; half as many elevations, down to 0.01°.
void write(const std::string& path, std::size_t steps) {
  const std::size_t distances = 7 * steps + 1, elevations = distances / 2;
  std::vector<Rows> rows(distances * elevations);
  tbb::parallel_for(std::size_t{0}, rows.size(), [&](std::size_t i) {
    const std::size_t row = i % elevations, column = i / elevations;
    const double lower = static_cast<double>(row) + 0.5, further = static_cast<double>(column);
    const double elevation = 90 * std::pow(10, -4 * lower / static_cast<double>(elevations));
    const double distance = std::pow(10, further / static_cast<double>(steps) - 2);
    const double angle = elevation * std::numbers::pi / 180, along = distance * std::cos(angle);
    const Vec3 p{static_cast<float>(0.8 * along), static_cast<float>(0.6 * along),
                 static_cast<float>(distance * std::sin(angle))};
    rows[i] = rows_at("disk", disk, "ld_radial", DiskMap::ld_radial, false, p, distance, elevation) +
              rows_at("disk", disk, "radial", DiskMap::radial, true, p, distance, elevation) +
              rows_at("rectangle", rectangle, "spherical", RectangleMap::spherical, true, p, distance, elevation);
  });
  std::ofstream file(path);
  file << "light,map,distance,elevation,cells,density,solid_angle,direction\n";
  for (const Rows& row : rows) file << row;
  if (!file.flush()) throw std::runtime_error("cannot write " + path);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc != 3) throw std::invalid_argument("usage: figure_accuracy FILE STEPS_PER_DECADE");
    const int steps = std::stoi(argv[2]);
    if (steps < 1) throw std::invalid_argument("STEPS_PER_DECADE must be at least 1, not " + std::string(argv[2]));
    write(argv[1], static_cast<std::size_t>(steps));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "figure_accuracy: %s\n", error.what());
    return 1;
  }
}
