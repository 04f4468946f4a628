// Every call of the disk on one set of arrays, so that tests of the contract can say "all outputs" and mean it.
#pragma once

#include "support/workloads.h"

#include <hatbox/disk.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace hatbox::test {

struct NamedColumn {
  std::string name;
  std::vector<float> values;
};

/// What a test asks: n points, and k·n variates, directions and places.
struct DiskQueries {
  PointArrays points;
  VariateArrays variates;
  std::vector<float> x, y, z, s, t;

  std::size_t size() const { return variates.size(); }
  std::size_t per_point() const { return points.size() ? size() / points.size() : 1; }
  Directions directions() const { return {x, y, z}; }
  Places places() const { return {s, t}; }
};

/// Workload points, k random variates each, and the directions and places that `map` samples there.
DiskQueries make_queries(const Disk& light, DiskMap map, const PointArrays& points, std::size_t k);

/// The queries of the points `indices`, in that order.
DiskQueries pick(const DiskQueries& from, const std::vector<std::size_t>& indices);

/// Sample j of each point.
DiskQueries nth_samples(const DiskQueries& from, std::size_t j);

/// All outputs of all calls: sequential, or parallel with a grain.
std::vector<NamedColumn> call_everything(const Disk& light, DiskMap map, const DiskQueries& queries,
                                         std::optional<std::size_t> grain = {});

}  // namespace hatbox::test
