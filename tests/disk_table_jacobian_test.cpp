// The pdf that `sample` returns with a DiskTable is the true density of the table's own map, whatever its resolution.
#include "support/table_in_double.h"

#include "support/jacobian.h"
#include "support/statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <vector>

namespace hatbox::test {
namespace {

using in_double::ConcentricChart;
using in_double::PolarChart;

struct Site {
  double u, v, step_u, step_v;
};

/// A place and steps from there that stay inside one cell of the table, at whose borders the map's second derivative
/// jumps.
template <class Chart>
Site site_in_cell(double u, double v, double cells) {
  const auto stays = [&](double du, double dv) {
    const auto cell = [&](double sign) {
      const auto angle = Chart::forward(u + sign * du, v + sign * dv).angle;
      return std::floor(angle.cos * angle.cos * cells);  // x = cos 2θ = 2 cos² θ − 1
    };
    return cell(1) == cell(0) && cell(-1) == cell(0);
  };
  Site site{u, v, jacobian_step(u, v), jacobian_step(u, v)};
  while (!stays(site.step_u, 0)) site.step_u /= 2;
  while (!stays(0, site.step_v)) site.step_v /= 2;
  return site;
}

/// Near (u, v), where there is most room for steps: rounding asks for large ones.
template <class Chart>
Site roomiest(double u, double v, double cells) {
  Site best{};
  for (int i = 0; i < 16; ++i) {
    const Site site = site_in_cell<Chart>(u - 1e-4 * i, v, cells);  // away from the seams
    if (std::min(site.step_u, site.step_v) > std::min(best.step_u, best.step_v)) best = site;
  }
  return best;
}

template <class Chart>
std::vector<Site> make_sites(double cells) {
  constexpr int grid = 20;
  std::vector<Site> sites;
  for (int i = 0; i < grid; ++i) {
    for (int j = 0; j < grid; ++j) {
      // off the seams u = v and u = 1 − v
      sites.push_back(roomiest<Chart>((i + 0.37) / grid, (j + 0.59) / grid, cells));
    }
  }
  return sites;
}

template <template <class> class Map, class Chart>
std::vector<double> jacobian_errors(Pose pose, std::size_t resolution) {
  const TableInDouble table(pose, resolution);
  const auto light = table.light();
  const std::vector<Site> sites = make_sites<Chart>(static_cast<double>(resolution - 2));
  std::vector<double> errors;
  for (const Workload workload : all_workloads) {
    const PointArrays points = make_points(workload, pose, 60);
    for (std::size_t p = 0; p < points.size(); ++p) {
      const Map<double> map(light, points.x[p], points.y[p], points.z[p]);
      for (const Site& at : sites) errors.push_back(jacobian_error(map, at.u, at.v, at.step_u, at.step_v));
    }
  }
  return errors;
}

class DiskTableJacobianSlow : public testing::TestWithParam<std::tuple<Pose, std::size_t>> {};

void expect_honest(const std::vector<double>& errors) {
  report_quantiles("jacobian", errors);
  EXPECT_LE(quantile(errors, 0.999), 1e-6);
  EXPECT_LE(quantile(errors, 1), 1e-5);
}

TEST_P(DiskTableJacobianSlow, LdRadial) {
  const auto [pose, resolution] = GetParam();
  expect_honest(jacobian_errors<in_double::DiskTableLdRadial, ConcentricChart>(pose, resolution));
}

TEST_P(DiskTableJacobianSlow, Radial) {
  const auto [pose, resolution] = GetParam();
  expect_honest(jacobian_errors<in_double::DiskTableRadial, PolarChart>(pose, resolution));
}

INSTANTIATE_TEST_SUITE_P(Every, DiskTableJacobianSlow,
                         testing::Combine(testing::Values(Pose::canonical, Pose::general),
                                          testing::Values(std::size_t{8}, std::size_t{64}, std::size_t{1024})),
                         [](const auto& test) {
                           return std::string(name(std::get<Pose>(test.param))) + "_" +
                                  std::to_string(std::get<std::size_t>(test.param));
                         });

}  // namespace
}  // namespace hatbox::test
