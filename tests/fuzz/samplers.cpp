// The five calls of a sampler, the numbers of the arrays any, their lengths right or wrong.
#include "fuzz/arrays.h"
#include "fuzz/targets.h"
#include "support/bits.h"
#include "support/lane_faults.h"
#include "support/samplable.h"
#include "support/workloads.h"

#include <string>

namespace hatbox::fuzz {
namespace {

using test::SampleArrays;
using test::Sampler;

/// What all calls of an input share.
struct Scene {
  Input& input;
  const Manner& manner;
  const Sampler& sampler;
  test::PointArrays points;
  std::size_t numbers;  // samples or queries
  Refused refused;

  /// Any call that takes the numbers.
  bool refuses_all() const {
    const bool uneven = points.size() == 0 ? numbers != 0 : numbers % points.size() != 0;
    return refused.light || refused.map || uneven;
  }
  std::vector<float> any_numbers() const { return input.numbers(numbers); }
};

struct PointArrays {
  PointArrays(Arrays& arrays, const test::PointArrays& p) : x(arrays.in(p.x)), y(arrays.in(p.y)), z(arrays.in(p.z)) {}
  Points view() const { return {x, y, z}; }
  const std::vector<float>&x, &y, &z;
};

/// `numbers`: the lane's, to see what was asked.
void require_no_fault(const char* fault, const Scene& scene, const std::string& what, std::size_t lane,
                      const std::vector<float>& numbers) {
  if (fault == nullptr) return;
  const Vec3 p = scene.points[lane % scene.points.size()];
  require(false, scene.sampler.name + " " + what + ": " + fault + scene.manner.told() + told({p.x, p.y, p.z}) + "," +
                     told(numbers));
}

/// What was sampled, all outputs; nothing if the call was one that had to be refused.
std::vector<std::vector<float>> sample(const Scene& scene, const std::vector<float>& u, const std::vector<float>& v) {
  Arrays arrays;
  const PointArrays points(arrays, scene.points);
  const auto &in_u = arrays.in(u), &in_v = arrays.in(v);
  std::vector<std::vector<float>*> out;
  for (int c = 0; c < SampleArrays::column_count; ++c) out.push_back(&arrays.out(scene.numbers));
  arrays.bend(scene.input);
  const bool refused = scene.refuses_all() || arrays.refused(true);
  scene.manner.run(refused, arrays.outputs(), scene.sampler.name + " sample", [&] {
    scene.sampler.sample(points.view(), {in_u, in_v},
                         {*out[0], *out[1], *out[2], *out[3], *out[4], *out[5], *out[6], *out[7]}, scene.manner.grain);
  });
  if (refused) return {};
  std::vector<std::vector<float>> result;
  for (const auto* column : out) result.push_back(*column);
  return result;
}

void judge(const Scene& scene, const std::vector<float>& u, const std::vector<float>& v,
           const std::vector<std::vector<float>>& columns, const std::vector<bool>& expected) {
  SampleArrays samples(scene.numbers);
  for (std::size_t c = 0; c < columns.size(); ++c) {
    if (columns[c].size() != scene.numbers) return;  // not wanted: what is left cannot be judged by the same rules
    samples.columns[c] = columns[c];
  }
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const char* fault = test::fault_of(scene.sampler, scene.points[i % scene.points.size()], samples, i);
    if (fault == nullptr && expected[i] && !samples.valid(i)) fault = "nothing was sampled";
    require_no_fault(fault, scene, "sample", i, {u[i], v[i]});
  }
}

/// A query of k·n numbers a point: arrays `in`, and as many outputs as `out`. Makes call(points, in, out).
template <class Call, class Judge>
void query(const Scene& scene, const std::string& what, const std::vector<std::vector<float>>& in, std::size_t outputs,
           std::size_t size, bool refused_anyway, const Call& call, const Judge& judge_lane) {
  Arrays arrays;
  const PointArrays points(arrays, scene.points);
  std::vector<const std::vector<float>*> given;
  std::vector<std::vector<float>*> out;
  for (const auto& values : in) given.push_back(&arrays.in(values));
  for (std::size_t c = 0; c < outputs; ++c) out.push_back(&arrays.out(size));
  arrays.bend(scene.input);
  const bool refused = refused_anyway || arrays.refused();
  scene.manner.run(refused, arrays.outputs(), scene.sampler.name + " " + what,
                   [&] { call(points.view(), given, out); });
  if (refused) return;
  for (std::size_t i = 0; i < size; ++i) {
    std::vector<float> numbers;
    for (const auto* column : given) numbers.push_back((*column)[i]);
    for (const auto* column : out) numbers.push_back((*column)[i]);
    require_no_fault(judge_lane(out, i), scene, what, i, numbers);
  }
}

using In = std::vector<const std::vector<float>*>;
using Out = std::vector<std::vector<float>*>;

void ask(const Scene& scene, const std::vector<std::vector<float>>& directions,
         const std::vector<std::vector<float>>& places) {
  const Sampler& sampler = scene.sampler;
  const test::Grain grain = scene.manner.grain;
  const auto density = [](const Out& out, std::size_t i) { return test::fault_of_density((*out[0])[i]); };
  query(
      scene, "pdf of direction", directions, 1, scene.numbers, scene.refuses_all(),
      [&](const Points& points, const In& in, const Out& out) {
        sampler.pdf_of_direction(points, {*in[0], *in[1], *in[2]}, *out[0], grain);
      },
      density);
  query(
      scene, "pdf of place", places, 1, scene.numbers, scene.refuses_all(),
      [&](const Points& points, const In& in, const Out& out) {
        sampler.pdf_of_place(points, {*in[0], *in[1]}, *out[0], grain);
      },
      density);
  if (sampler.invert) {
    query(
        scene, "invert", directions, 2, scene.numbers, scene.refuses_all(),
        [&](const Points& points, const In& in, const Out& out) {
          sampler.invert(points, {*in[0], *in[1], *in[2]}, *out[0], *out[1], grain);
        },
        [](const Out& out, std::size_t i) { return test::fault_of_inverse((*out[0])[i], (*out[1])[i]); });
  }
  query(
      scene, "solid angle", {}, 1, scene.points.size(), scene.refused.light,
      [&](const Points& points, const In&, const Out& out) { sampler.solid_angle(points, *out[0], grain); },
      [](const Out& out, std::size_t i) { return test::fault_of_solid_angle((*out[0])[i]); });
}

}  // namespace

void exercise(Input& input, const Manner& manner, const Sampler& sampler, std::size_t points, Refused refused,
              const std::function<Vec3(Input&)>& make_point, const std::function<bool(std::size_t, Vec3)>& samplable) {
  constexpr std::size_t per_point[] = {0, 1, 1, 2, 3, 9}, many = 37;  // for a set in several goes
  const std::size_t k = input.one_in(32) ? many : per_point[input.below(std::size(per_point))];
  Scene scene{input, manner, sampler, {}, points * k, refused};
  if (input.one_in(16)) scene.numbers += input.below(points + 2);
  for (std::size_t i = 0; i < points; ++i) scene.points.push_back(make_point(input));
  std::vector<float> u, v;
  std::vector<bool> expected;
  for (std::size_t i = 0; i < scene.numbers; ++i) {
    u.push_back(input.variate());
    v.push_back(input.variate());
    expected.push_back(!scene.refuses_all() && test::Samplable::by(u[i], v[i]) &&
                       samplable(i % points, scene.points[i % points]));
  }
  const auto columns = sample(scene, u, v);
  if (!columns.empty()) judge(scene, u, v, columns, expected);
  const bool sampled = !columns.empty() && !input.one_in(3);
  const auto column = [&](std::size_t c) {
    return sampled && columns[c].size() == scene.numbers ? columns[c] : scene.any_numbers();
  };
  ask(scene, {column(0), column(1), column(2)}, {column(SampleArrays::s), column(SampleArrays::t)});
}

}  // namespace hatbox::fuzz
