#include "support/sampler_calls.h"

#include "support/bits.h"

#include <gtest/gtest.h>

#include <numeric>

namespace hatbox::test {
namespace {

/// The samples [first, last) of the points `indices`.
Queries pick(const Queries& from, std::size_t first, std::size_t last, const std::vector<std::size_t>& indices) {
  const auto some = [&](const std::vector<float>& all) {
    std::vector<float> result;
    for (std::size_t j = first; j < last; ++j) {
      for (const std::size_t i : indices) result.push_back(all[j * from.points.size() + i]);
    }
    return result;
  };
  Queries result;
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

Queries make_queries(const Sampler& sampler, const PointArrays& points, std::size_t k) {
  Queries result;
  result.points = points;
  result.variates = make_variates(k * points.size());
  SampleArrays samples(result.size());
  sampler.sample(points.view(), result.variates.view(), samples.view(), {});
  result.x = samples.columns[SampleArrays::x];
  result.y = samples.columns[SampleArrays::y];
  result.z = samples.columns[SampleArrays::z];
  result.s = samples.columns[SampleArrays::s];
  result.t = samples.columns[SampleArrays::t];
  return result;
}

Queries pick(const Queries& from, const std::vector<std::size_t>& indices) {
  return pick(from, 0, from.per_point(), indices);
}

Queries nth_samples(const Queries& from, std::size_t j) {
  std::vector<std::size_t> all(from.points.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return pick(from, j, j + 1, all);
}

std::vector<NamedColumn> call_everything(const Sampler& sampler, const Queries& queries, Grain grain) {
  const std::size_t n = queries.size();
  const Points points = queries.points.view();
  SampleArrays samples(n);
  std::vector<float> of_direction(n), at_place(n), u(n), v(n), omega(queries.points.size());
  sampler.sample(points, queries.variates.view(), samples.view(), grain);
  sampler.pdf_of_direction(points, queries.directions(), of_direction, grain);
  sampler.pdf_of_place(points, queries.places(), at_place, grain);
  if (sampler.invert) sampler.invert(points, queries.directions(), u, v, grain);
  sampler.solid_angle(points, omega, grain);
  std::vector<NamedColumn> result;
  for (std::size_t c = 0; c < SampleArrays::column_count; ++c) {
    result.push_back({name(static_cast<SampleArrays::Column>(c)), samples.columns[c]});
  }
  result.push_back({"pdf_of_direction", of_direction});
  result.push_back({"pdf_at_place", at_place});
  if (sampler.invert) {
    result.push_back({"u", u});
    result.push_back({"v", v});
  }
  result.push_back({"solid_angle", omega});
  return result;
}

std::vector<NamedColumn> pick(const std::vector<NamedColumn>& all, std::size_t n,
                              const std::vector<std::size_t>& indices) {
  std::vector<NamedColumn> result;
  for (const auto& [what, values] : all) {
    std::vector<float> some;
    for (std::size_t j = 0; j < values.size() / n; ++j) {
      for (const std::size_t i : indices) some.push_back(values[j * n + i]);
    }
    result.push_back({what, some});
  }
  return result;
}

void expect_same(const std::vector<NamedColumn>& got, const std::vector<NamedColumn>& expected) {
  for (std::size_t c = 0; c < got.size(); ++c) {
    ASSERT_EQ(got[c].values.size(), expected[c].values.size());
    ASSERT_EQ(first_difference(got[c].values, expected[c].values), got[c].values.size()) << got[c].name;
  }
}

}  // namespace hatbox::test
