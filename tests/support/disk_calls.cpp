#include "support/disk_calls.h"

#include <numeric>

namespace hatbox::test {
namespace {

/// The samples [first, last) of the points `indices`.
DiskQueries pick(const DiskQueries& from, std::size_t first, std::size_t last,
                 const std::vector<std::size_t>& indices) {
  const auto some = [&](const std::vector<float>& all) {
    std::vector<float> result;
    for (std::size_t j = first; j < last; ++j) {
      for (const std::size_t i : indices) result.push_back(all[j * from.points.size() + i]);
    }
    return result;
  };
  DiskQueries result;
  for (const std::size_t i : indices) result.points.push_back(from.points[i]);
  result.variates = {some(from.variates.u), some(from.variates.v)};
  result.x = some(from.x);
  result.y = some(from.y);
  result.z = some(from.z);
  result.s = some(from.s);
  result.t = some(from.t);
  return result;
}

}  // namespace

DiskQueries make_queries(const Disk& light, DiskMap map, const PointArrays& points, std::size_t k) {
  DiskQueries result;
  result.points = points;
  result.variates = make_variates(k * points.size());
  SampleArrays samples(result.size());
  sample(light, map, points.view(), result.variates.view(), samples.view());
  result.x = samples.columns[SampleArrays::x];
  result.y = samples.columns[SampleArrays::y];
  result.z = samples.columns[SampleArrays::z];
  result.s = samples.columns[SampleArrays::s];
  result.t = samples.columns[SampleArrays::t];
  return result;
}

DiskQueries pick(const DiskQueries& from, const std::vector<std::size_t>& indices) {
  return pick(from, 0, from.per_point(), indices);
}

DiskQueries nth_samples(const DiskQueries& from, std::size_t j) {
  std::vector<std::size_t> all(from.points.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return pick(from, j, j + 1, all);
}

std::vector<NamedColumn> call_everything(const Disk& light, DiskMap map, const DiskQueries& queries,
                                         std::optional<std::size_t> grain) {
  const std::size_t n = queries.size();
  const Points points = queries.points.view();
  SampleArrays samples(n);
  std::vector<float> of_direction(n), at_place(n), u(n), v(n), omega(queries.points.size());
  if (grain) {
    parallel::sample(light, map, points, queries.variates.view(), samples.view(), *grain);
    parallel::pdf(light, map, points, queries.directions(), of_direction, *grain);
    parallel::pdf(light, map, points, queries.places(), at_place, *grain);
    parallel::invert(light, map, points, queries.directions(), u, v, *grain);
    parallel::solid_angle(light, points, omega, *grain);
  } else {
    sample(light, map, points, queries.variates.view(), samples.view());
    pdf(light, map, points, queries.directions(), of_direction);
    pdf(light, map, points, queries.places(), at_place);
    invert(light, map, points, queries.directions(), u, v);
    solid_angle(light, points, omega);
  }
  std::vector<NamedColumn> result;
  for (std::size_t c = 0; c < SampleArrays::column_count; ++c) {
    result.push_back({name(static_cast<SampleArrays::Column>(c)), samples.columns[c]});
  }
  result.push_back({"pdf_of_direction", of_direction});
  result.push_back({"pdf_at_place", at_place});
  result.push_back({"u", u});
  result.push_back({"v", v});
  result.push_back({"solid_angle", omega});
  return result;
}

}  // namespace hatbox::test
