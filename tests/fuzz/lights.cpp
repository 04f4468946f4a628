// Lights of every kind, valid ones and others, points around them, sets of them.
#include "fuzz/targets.h"
#include "support/disks.h"
#include "support/ellipses.h"
#include "support/frames.h"
#include "support/light_sets.h"
#include "support/rectangles.h"
#include "support/samplable.h"
#include "support/triangle_lights.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace hatbox::fuzz {
namespace {

using test::Outline;
using test::Samplable;
using test::Sampler;

/// A vector along one of the world's axes, so that others at right angles to it are found at once.
Vec3 along(std::size_t axis, float length) {
  float c[3] = {0, 0, 0};
  c[axis % 3] = length;
  return {c[0], c[1], c[2]};
}

struct Pair {
  Vec3 u, v;
};

/// Edges or semi-axes: at right angles more often than not.
Pair pair_of_edges(Input& input) {
  if (input.one_in(4)) return {input.vector(), input.vector()};
  const std::size_t axis = input.below(3);
  const float a = input.number(), b = input.number();
  if (input.one_in(2)) return {along(axis, a), along(axis + 1, b)};
  const Vec3 in_plane = along(axis, a), across = along(axis + 1, b);
  return {{in_plane.x + across.x, in_plane.y + across.y, in_plane.z + across.z},
          {in_plane.x * (b / a) - across.x * (a / b), in_plane.y * (b / a) - across.y * (a / b),
           in_plane.z * (b / a) - across.z * (a / b)}};
}

Disk disk(Input& input) { return {input.vector(), input.vector(), input.number()}; }
Ellipse ellipse(Input& input) {
  const auto [u, v] = pair_of_edges(input);
  return {input.vector(), u, v};
}
Rectangle rectangle(Input& input) {
  const auto [u, v] = pair_of_edges(input);
  return {input.vector(), u, v};
}
Triangle triangle(Input& input) { return {input.vector(), input.vector(), input.vector()}; }

/// Any, or one of the light's plane or next to it: in the middle, on the rim, at a corner.
std::function<Vec3(Input&)> points_around(const Outline& light) {
  return [light](Input& input) {
    if (input.one_in(2)) return input.vector();
    const double s = static_cast<double>(input.number()), t = static_cast<double>(input.number());
    const double height = static_cast<double>(input.number());
    const auto across = cross(light.along_s, light.along_t);
    const auto p = light.at(s, t) + (height / std::sqrt(length(across))) * across;
    return test::rounded(p);
  };
}

/// Every number there is of an enumeration's type, the maps themselves most often.
template <class Maps>
typename Maps::value_type any_map(Input& input, const Maps& maps) {
  if (!input.one_in(16)) return maps[input.below(maps.size())];
  return static_cast<typename Maps::value_type>(static_cast<int>(input.bits()));
}

template <class Maps>
bool exists(const Maps& maps, typename Maps::value_type map) {
  return std::ranges::find(maps, map) != maps.end();
}

/// What a fault is to be reported of.
std::vector<float> numbers_of(const Disk& l) {
  return {l.center.x, l.center.y, l.center.z, l.normal.x, l.normal.y, l.normal.z, l.radius};
}
std::vector<float> numbers_of(const Vec3& a, const Vec3& b, const Vec3& c) {
  return {a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z};
}
std::vector<float> numbers_of(const Ellipse& l) { return numbers_of(l.center, l.semi_axis_u, l.semi_axis_v); }
std::vector<float> numbers_of(const Rectangle& l) { return numbers_of(l.corner, l.edge_u, l.edge_v); }
std::vector<float> numbers_of(const Triangle& l) { return numbers_of(l.a, l.b, l.c); }

template <class Light, class Map>
void exercise_light(Input& input, const Manner& manner, const std::string& kind, const Light& light, const Map& map,
                    bool refused_map) {
  const bool valid = check(light).empty();
  const Sampler sampler(kind + told(numbers_of(light)), light, map);
  const Samplable judgement(sampler.outline);
  exercise(
      input, manner, sampler, input.count(), {!valid, refused_map},
      valid ? points_around(sampler.outline) : [](Input& from) { return from.vector(); },
      [&](std::size_t, const Vec3& point) { return judgement.from(point, test::least_height(map)); });
}

template <class Light, class Maps>
void exercise_kind(Input& input, const Manner& manner, const std::string& kind, const Light& light, const Maps& maps) {
  const auto map = any_map(input, maps);
  const bool known = exists(maps, map);
  exercise_light(input, manner, kind + (known ? std::string(" ") + test::name(map) : " by no map"), light, map, !known);
}

/// Some lights of a kind; a bad one among them now and then.
template <class Make>
auto some(Input& input, bool& refused, const Make& make) {
  std::vector<decltype(make(input))> lights;
  for (std::size_t left = input.below(4); left > 0; --left) {
    const auto light = make(input);
    const bool valid = check(light).empty();
    if (!valid && !input.one_in(32)) continue;
    refused = refused || !valid;
    lights.push_back(light);
  }
  return lights;
}

/// Calls visit(light) for the lights of several arrays.
template <class Visit, class... Lights>
void for_each_light(const Visit& visit, const Lights&... lights) {
  (std::ranges::for_each(lights, visit), ...);
}

/// A light for each point; sometimes one that is not there, or too few or many of them.
std::vector<std::uint32_t> choices(Input& input, std::size_t points, std::size_t lights) {
  std::vector<std::uint32_t> chosen;
  for (std::size_t i = 0; i < points; ++i) {
    const bool wild = lights == 0 || input.one_in(512);
    chosen.push_back(wild ? input.bits() : static_cast<std::uint32_t>(input.below(lights)));
  }
  if (input.one_in(16)) chosen.resize(input.below(2 * points + 2), 0);
  return chosen;
}

}  // namespace

void exercise_disk(Input& input, const Manner& manner) {
  const Disk light = disk(input);
  exercise_kind(input, manner, "disk", light, test::all_disk_maps);
  std::vector<float> none;
  manner.run(true, {}, "invert by rejection",
             [&] { invert(light, DiskMap::rejection, Points{}, Directions{}, none, none); });
}

void exercise_ellipse(Input& input, const Manner& manner) {
  exercise_kind(input, manner, "ellipse", ellipse(input), test::all_ellipse_maps);
}

void exercise_rectangle(Input& input, const Manner& manner) {
  exercise_kind(input, manner, "rectangle", rectangle(input), test::all_rectangle_maps);
}

void exercise_triangle(Input& input, const Manner& manner) {
  exercise_kind(input, manner, "triangle", triangle(input), test::all_triangle_maps);
}

void exercise_table(Input& input, const Manner& manner) {
  const DiskMap base = any_map(input, test::all_disk_maps);
  const std::size_t resolution = input.one_in(16) ? input.bits() : input.below(20);
  const bool refused = (base != DiskMap::ld_radial && base != DiskMap::radial) ||
                       resolution < DiskTable::least_resolution || resolution > DiskTable::greatest_resolution;
  if (!refused && resolution > 64) return;  // slow, and no different
  std::optional<DiskTable> table;
  manner.run(refused, {}, "table", [&] { table.emplace(base, resolution); });
  if (table) exercise_light(input, manner, "disk by table", disk(input), *table, false);
}

void exercise_set(Input& input, const Manner& manner) {
  bool refused = false;
  const auto disks = some(input, refused, disk);
  const auto ellipses = some(input, refused, ellipse);
  const auto rectangles = some(input, refused, rectangle);
  const auto triangles = some(input, refused, triangle);
  const LightSet::Maps maps{any_map(input, test::all_disk_maps), any_map(input, test::all_ellipse_maps),
                            any_map(input, test::all_rectangle_maps), any_map(input, test::all_triangle_maps)};
  refused = refused || !exists(test::all_disk_maps, maps.disk) || !exists(test::all_ellipse_maps, maps.ellipse) ||
            !exists(test::all_rectangle_maps, maps.rectangle) || !exists(test::all_triangle_maps, maps.triangle);
  std::optional<LightSet> set;
  manner.run(refused, {}, "set", [&] { set.emplace(disks, ellipses, rectangles, triangles, maps); });
  if (!set) return;
  std::vector<Outline> outlines;
  for_each_light([&](const auto& light) { outlines.push_back(test::outline_of(light)); }, disks, ellipses, rectangles,
                 triangles);
  require(set->size() == outlines.size(), "the set has another size");
  const std::size_t points = input.count();
  const std::vector<std::uint32_t> chosen = choices(input, points, set->size());
  const bool refused_choice =
      chosen.size() != points || std::ranges::any_of(chosen, [&](std::uint32_t index) { return index >= set->size(); });
  Sampler sampler = test::sampler_of(*set, chosen);
  for_each_light([&](const auto& light) { sampler.name += told(numbers_of(light)) + ";"; }, disks, ellipses, rectangles,
                 triangles);
  if (!disks.empty() && maps.disk == DiskMap::rejection) sampler.invert = nullptr;
  std::size_t next = 0;
  exercise(
      input, manner, sampler, points, {refused_choice, false},
      [&](Input& from) {
        const std::size_t i = next++;
        return refused_choice ? from.vector() : points_around(outlines[chosen[i]])(from);
      },
      [&](std::size_t i, const Vec3& point) {
        const bool is_disk = chosen[i] < disks.size();  // disks come first
        return Samplable(outlines[chosen[i]]).from(point, is_disk ? test::least_height(maps.disk) : 0);
      });
}

}  // namespace hatbox::fuzz
