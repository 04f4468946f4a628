#include "carlson_bench.h"

#include "arrays.h"

#include <hatbox/hatbox.h>

#include <benchmark/benchmark.h>
#include <boost/math/special_functions/ellint_3.hpp>
#include <boost/math/special_functions/ellint_rc.hpp>
#include <boost/math/special_functions/ellint_rd.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>
#include <boost/math/special_functions/ellint_rj.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace hatbox::bench {
namespace {

using Policy = boost::math::policies::policy<boost::math::policies::promote_double<false>>;

/// Π(n; ϕ|m) of Guillén et al. 2017, eq. 19-20, for the unit disk seen from the points of W1 and ϕ uniform in a quarter
/// turn, and the arguments x, y, z, p of the R_J in it.
struct Arguments {
  std::vector<float> n, phi, m, x, y, z, p, out;

  Arguments() : out(count) {
    const Arrays arrays(count, 1);
    const Points points = arrays.points();
    for (std::size_t i = 0; i < count; ++i) {
      const auto height = static_cast<double>(points.z[i]);
      const double d = std::hypot(static_cast<double>(points.x[i]), static_cast<double>(points.y[i]));
      const double near = std::hypot(d - 1, height), far = std::hypot(d + 1, height);
      const double a2 = 4 / ((near + far) * (near + far));
      const double b2 = (near * far - (d * d + height * height - 1)) / (2 * near * far);
      const double angle = std::numbers::pi / 2 * static_cast<double>(arrays.variates().u[i]);
      add((a2 - b2) / (a2 * (1 - b2)), angle, (a2 - b2) / (1 - b2));
    }
  }

  static constexpr std::size_t count = 4096;

 private:
  void add(double characteristic, double angle, double parameter) {
    const double sin2 = std::sin(angle) * std::sin(angle), cos2 = std::cos(angle) * std::cos(angle);
    const auto append = [](std::vector<float>& to, double value) { to.push_back(static_cast<float>(value)); };
    append(n, characteristic);
    append(phi, angle);
    append(m, parameter);
    append(x, cos2);
    append(y, 1 - parameter * sin2);
    append(z, 1);
    append(p, 1 - characteristic * sin2);
  }
};

Arguments& arguments() {
  static Arguments all;
  return all;
}

/// An integral in batches, and one element of it by Boost.Math in double.
struct Integral {
  const char* name;
  void (*batch)(Arguments&);
  double (*scalar)(const Arguments&, std::size_t);
};

double at(const std::vector<float>& values, std::size_t i) { return static_cast<double>(values[i]); }

const Integral integrals[] = {
    {"rf", [](Arguments& a) { carlson_rf(a.x, a.y, a.z, a.out); },
     [](const Arguments& a, std::size_t i) {
       return boost::math::ellint_rf(at(a.x, i), at(a.y, i), at(a.z, i), Policy());
     }},
    {"rc", [](Arguments& a) { carlson_rc(a.x, a.y, a.out); },
     [](const Arguments& a, std::size_t i) { return boost::math::ellint_rc(at(a.x, i), at(a.y, i), Policy()); }},
    {"rd", [](Arguments& a) { carlson_rd(a.x, a.y, a.z, a.out); },
     [](const Arguments& a, std::size_t i) {
       return boost::math::ellint_rd(at(a.x, i), at(a.y, i), at(a.z, i), Policy());
     }},
    {"rj", [](Arguments& a) { carlson_rj(a.x, a.y, a.z, a.p, a.out); },
     [](const Arguments& a, std::size_t i) {
       return boost::math::ellint_rj(at(a.x, i), at(a.y, i), at(a.z, i), at(a.p, i), Policy());
     }},
    {"pi", [](Arguments& a) { ellint_pi(a.n, a.phi, a.m, a.out); },
     [](const Arguments& a, std::size_t i) {
       return boost::math::ellint_3(std::sqrt(at(a.m, i)), at(a.n, i), at(a.phi, i), Policy());
     }},
};

template <class Work>
Case add_case(const char* map, const char* isa, const Work& work) {
  Case c{.light = "carlson", .map = map, .isa = isa, .workload = "W1", .points = Arguments::count};
  benchmark::RegisterBenchmark(c.name().c_str(), [work](benchmark::State& state) { work(state); })->UseRealTime();
  return c;
}

}  // namespace

std::vector<Case> register_carlson_cases() {
  std::vector<Case> cases;
  for (const Integral& integral : integrals) {
    for (const Isa isa : available_isas()) {
      cases.push_back(add_case(integral.name, name(isa), [&integral, isa](benchmark::State& state) {
        force_isa(isa);
        for ([[maybe_unused]] auto _ : state) {
          integral.batch(arguments());
          benchmark::ClobberMemory();
        }
      }));
    }
    cases.push_back(add_case(integral.name, "reference", [&integral](benchmark::State& state) {
      for ([[maybe_unused]] auto _ : state) {
        for (std::size_t i = 0; i < Arguments::count; ++i) {
          benchmark::DoNotOptimize(integral.scalar(arguments(), i));
        }
      }
    }));
  }
  return cases;
}

}  // namespace hatbox::bench
