// Calls that cannot be right: the exception names the argument, sequential and parallel alike, and nothing is written.
#include "support/workloads.h"

#include <hatbox/hatbox.h>

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <stdexcept>
#include <string>

namespace hatbox::test {
namespace {

constexpr std::size_t n = 6, k = 3;
constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

/// Arrays of the right length for every call. A test bends one and looks at who complains.
struct Arguments {
  Disk light = disk_in(Pose::general);
  PointArrays points = make_points(Workload::w1, Pose::general, n);
  VariateArrays variates = make_variates(k * n);
  std::vector<float> x = std::vector<float>(k * n, 0.6f), y = std::vector<float>(k * n, 0.0f),
                     z = std::vector<float>(k * n, -0.8f), s = x, t = y;
  SampleArrays samples{k * n};
  std::vector<float> u = std::vector<float>(k * n, SampleArrays::untouched), v = u, out = u,
                     omega = std::vector<float>(n, SampleArrays::untouched);

  Samples sample_view() {
    auto& c = samples.columns;
    return {c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7]};
  }

  bool all_untouched() const {
    bool result = true;
    const auto check = [&](const std::vector<float>& values) {
      for (const float value : values) result = result && value == SampleArrays::untouched;
    };
    for (const auto& column : samples.columns) check(column);
    for (const auto* values : {&u, &v, &out, &omega}) check(*values);
    return result;
  }
};

using Call = std::function<void(Arguments&)>;

constexpr DiskMap map = DiskMap::ld_radial;

struct Calls {
  Call sample = [](Arguments& a) { hatbox::sample(a.light, map, a.points.view(), a.variates.view(), a.sample_view()); };
  Call pdf_of_direction = [](Arguments& a) { pdf(a.light, map, a.points.view(), Directions{a.x, a.y, a.z}, a.out); };
  Call pdf_of_place = [](Arguments& a) { pdf(a.light, map, a.points.view(), Places{a.s, a.t}, a.out); };
  Call invert = [](Arguments& a) { hatbox::invert(a.light, map, a.points.view(), {a.x, a.y, a.z}, a.u, a.v); };
  Call solid_angle = [](Arguments& a) { hatbox::solid_angle(a.light, a.points.view(), a.omega); };

  std::vector<Call> all() const { return {sample, pdf_of_direction, pdf_of_place, invert, solid_angle}; }
};

const Calls sequential;

const Calls in_parallel{
    .sample = [](Arguments& a) { parallel::sample(a.light, map, a.points.view(), a.variates.view(), a.sample_view()); },
    .pdf_of_direction =
        [](Arguments& a) {
          parallel::pdf(a.light, map, a.points.view(), Directions{a.x, a.y, a.z}, a.out);
        },
    .pdf_of_place =
        [](Arguments& a) {
          parallel::pdf(a.light, map, a.points.view(), Places{a.s, a.t}, a.out);
        },
    .invert =
        [](Arguments& a) {
          parallel::invert(a.light, map, a.points.view(), {a.x, a.y, a.z}, a.u, a.v);
        },
    .solid_angle = [](Arguments& a) { parallel::solid_angle(a.light, a.points.view(), a.omega); }};

/// The message of the exception, or "" if the call went through.
std::string complaint(const Call& call, Arguments& arguments) {
  try {
    call(arguments);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

void expect_complaint(const Call& call, Arguments arguments, const std::string& named) {
  const std::string message = complaint(call, arguments);
  EXPECT_NE(message.find(named), std::string::npos) << "wanted " << named << " in: " << message;
  EXPECT_TRUE(arguments.all_untouched()) << named;
}

class DiskErrors : public testing::TestWithParam<const Calls*> {
 protected:
  const Calls& calls() const { return *GetParam(); }
};

TEST_P(DiskErrors, NoneWhenAllIsRight) {
  for (const Call& call : calls().all()) {
    Arguments arguments;
    EXPECT_EQ(complaint(call, arguments), "");
    EXPECT_FALSE(arguments.all_untouched());
  }
}

TEST_P(DiskErrors, BadLightIsNamed) {
  struct Case {
    const char* named;
    Disk light;
  };
  const Case cases[] = {
      {"light.radius", {{0, 0, 0}, {0, 0, 1}, 0}},   {"light.radius", {{0, 0, 0}, {0, 0, 1}, -2}},
      {"light.radius", {{0, 0, 0}, {0, 0, 1}, nan}}, {"light.radius", {{0, 0, 0}, {0, 0, 1}, infinity}},
      {"light.normal", {{0, 0, 0}, {0, 0, 0}, 1}},   {"light.normal", {{0, 0, 0}, {0, -0.0f, -0.0f}, 1}},
      {"light.normal", {{0, 0, 0}, {nan, 0, 1}, 1}}, {"light.normal", {{0, 0, 0}, {0, infinity, 1}, 1}},
      {"light.center", {{0, nan, 0}, {0, 0, 1}, 1}}, {"light.center", {{0, 0, -infinity}, {0, 0, 1}, 1}},
  };
  for (const auto& [named, light] : cases) {
    Arguments arguments;
    arguments.light = light;
    for (const Call& call : calls().all()) expect_complaint(call, arguments, named);
    EXPECT_THROW(axes(light), std::invalid_argument) << named;
    EXPECT_FALSE(check(light).empty()) << named;
  }
  EXPECT_EQ(check(disk_in(Pose::general)), "");
}

/// The value stands in the message, so that a log tells what went wrong.
TEST_P(DiskErrors, TheValueIsGiven) {
  Arguments arguments;
  arguments.light.radius = -2.5f;
  expect_complaint(calls().sample, arguments, "-2.5");
  arguments = {};
  arguments.variates.v.resize(5);
  expect_complaint(calls().sample, arguments, "5");
}

/// Shortens and lengthens one array; empty is an error as well unless `optional`.
void expect_length_checked(const Call& call, const std::string& named, bool optional,
                           const std::function<std::vector<float>&(Arguments&)>& array) {
  for (const int change : {-1, 1, 0}) {
    Arguments arguments;
    auto& values = array(arguments);
    const std::size_t size = change ? values.size() + static_cast<std::size_t>(change) : 0;
    values.resize(size, SampleArrays::untouched);
    if (optional && size == 0) continue;
    expect_complaint(call, arguments, named);
  }
}

TEST_P(DiskErrors, WrongPointsAreNamed) {
  for (const Call& call : calls().all()) {
    expect_length_checked(
        call, "points.y", false, [](Arguments & a) -> auto& { return a.points.y; });
    expect_length_checked(
        call, "points.z", false, [](Arguments & a) -> auto& { return a.points.z; });
  }
}

TEST_P(DiskErrors, WrongInputsAreNamed) {
  const auto& all = calls();
  expect_length_checked(
      all.sample, "variates.v", false, [](Arguments & a) -> auto& { return a.variates.v; });
  for (const Call& call : {all.pdf_of_direction, all.invert}) {
    expect_length_checked(
        call, "directions.y", false, [](Arguments & a) -> auto& { return a.y; });
    expect_length_checked(
        call, "directions.z", false, [](Arguments & a) -> auto& { return a.z; });
  }
  expect_length_checked(
      all.pdf_of_place, "places.t", false, [](Arguments & a) -> auto& { return a.t; });
}

TEST_P(DiskErrors, WrongOutputsAreNamed) {
  const auto& all = calls();
  for (std::size_t c = 0; c < SampleArrays::column_count; ++c) {
    const std::string named = std::string("samples.") + name(static_cast<SampleArrays::Column>(c));
    expect_length_checked(
        all.sample, named, true, [c](Arguments & a) -> auto& { return a.samples.columns[c]; });
  }
  expect_length_checked(
      all.pdf_of_direction, "out", false, [](Arguments & a) -> auto& { return a.out; });
  expect_length_checked(
      all.pdf_of_place, "out", false, [](Arguments & a) -> auto& { return a.out; });
  expect_length_checked(
      all.invert, "u", false, [](Arguments & a) -> auto& { return a.u; });
  expect_length_checked(
      all.invert, "v", false, [](Arguments & a) -> auto& { return a.v; });
  expect_length_checked(
      all.solid_angle, "out", false, [](Arguments & a) -> auto& { return a.omega; });
}

/// k·n numbers for n points: the length must be a multiple, and 0 points take 0 numbers.
TEST_P(DiskErrors, NoMultipleOfThePointsIsNamed) {
  const auto bent = [](std::size_t points, std::size_t numbers) {
    Arguments a;
    for (auto* p : {&a.points.x, &a.points.y, &a.points.z}) p->resize(points);
    for (auto* p : {&a.variates.u, &a.variates.v, &a.x, &a.y, &a.z, &a.s, &a.t}) p->resize(numbers);
    for (auto* p : {&a.u, &a.v, &a.out}) p->resize(numbers, SampleArrays::untouched);
    for (auto& column : a.samples.columns) column.resize(numbers, SampleArrays::untouched);
    return a;
  };
  for (const Arguments& arguments : {bent(n, k * n + 1), bent(n, n - 1), bent(0, n)}) {
    expect_complaint(calls().sample, arguments, "variates.u");
    expect_complaint(calls().pdf_of_direction, arguments, "directions.x");
    expect_complaint(calls().invert, arguments, "directions.x");
    expect_complaint(calls().pdf_of_place, arguments, "places.s");
  }
}

TEST_P(DiskErrors, NothingToDoIsNoError) {
  Arguments a;
  a.points = {};
  a.variates = {};
  for (auto* values : {&a.x, &a.y, &a.z, &a.s, &a.t, &a.u, &a.v, &a.out, &a.omega}) values->clear();
  for (auto& column : a.samples.columns) column.clear();
  for (const Call& call : calls().all()) EXPECT_EQ(complaint(call, a), "");
}

std::string calls_name(const testing::TestParamInfo<const Calls*>& info) {
  return info.param == &sequential ? "sequential" : "parallel";
}

INSTANTIATE_TEST_SUITE_P(Every, DiskErrors, testing::Values(&sequential, &in_parallel), calls_name);

}  // namespace
}  // namespace hatbox::test
