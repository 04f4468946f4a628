// Every call of a sampler on one set of arrays, so that tests of the contract can say "all outputs" and mean it.
#pragma once

#include "support/sampler.h"
#include "support/workloads.h"

#include <cstddef>
#include <string>
#include <vector>

namespace hatbox::test {

struct NamedColumn {
  std::string name;
  std::vector<float> values;
};

/// What a test asks: n points, and k·n variates, directions and places.
struct Queries {
  PointArrays points;
  VariateArrays variates;
  std::vector<float> x, y, z, s, t;

  std::size_t size() const { return variates.size(); }
  std::size_t per_point() const { return points.size() ? size() / points.size() : 1; }
  Directions directions() const { return {x, y, z}; }
  Places places() const { return {s, t}; }
};

/// The points, k random variates each, and the directions and places that are sampled there.
Queries make_queries(const Sampler& sampler, const PointArrays& points, std::size_t k);

/// The queries of the points `indices`, in that order.
Queries pick(const Queries& from, const std::vector<std::size_t>& indices);

/// Sample j of each point.
Queries nth_samples(const Queries& from, std::size_t j);

/// All outputs of all calls: sequential, or parallel with a grain.
std::vector<NamedColumn> call_everything(const Sampler& sampler, const Queries& queries, Grain grain = {});

/// The outputs of the points `indices` out of those of all n.
std::vector<NamedColumn> pick(const std::vector<NamedColumn>& all, std::size_t n,
                              const std::vector<std::size_t>& indices);

/// Expects the same bits in all columns.
void expect_same(const std::vector<NamedColumn>& got, const std::vector<NamedColumn>& expected);

}  // namespace hatbox::test
