#include "support/carlson_calls.h"

#include <hatbox/carlson.h>

namespace hatbox::test {

const char* name(Integral integral) {
  constexpr std::array names{"rf", "rc", "rd", "rj", "f", "e", "pi"};
  return names[static_cast<std::size_t>(integral)];
}

std::vector<const char*> argument_names(Integral integral) {
  switch (integral) {
    case Integral::rf: return {"x", "y", "z"};
    case Integral::rc: return {"x", "y"};
    case Integral::rd: return {"x", "y", "z"};
    case Integral::rj: return {"x", "y", "z", "p"};
    case Integral::f: return {"phi", "m"};
    case Integral::e: return {"phi", "m"};
    case Integral::pi: return {"n", "phi", "m"};
  }
  return {};
}

namespace {

void call_parallel(Integral integral, const Columns& a, std::span<float> out, std::size_t grain) {
  switch (integral) {
    case Integral::rf: return parallel::carlson_rf(a[0], a[1], a[2], out, grain);
    case Integral::rc: return parallel::carlson_rc(a[0], a[1], out, grain);
    case Integral::rd: return parallel::carlson_rd(a[0], a[1], a[2], out, grain);
    case Integral::rj: return parallel::carlson_rj(a[0], a[1], a[2], a[3], out, grain);
    case Integral::f: return parallel::ellint_f(a[0], a[1], out, grain);
    case Integral::e: return parallel::ellint_e(a[0], a[1], out, grain);
    case Integral::pi: return parallel::ellint_pi(a[0], a[1], a[2], out, grain);
  }
}

}  // namespace

void call(Integral integral, const Columns& a, std::span<float> out, std::optional<std::size_t> grain) {
  if (grain) return call_parallel(integral, a, out, *grain);
  switch (integral) {
    case Integral::rf: return carlson_rf(a[0], a[1], a[2], out);
    case Integral::rc: return carlson_rc(a[0], a[1], out);
    case Integral::rd: return carlson_rd(a[0], a[1], a[2], out);
    case Integral::rj: return carlson_rj(a[0], a[1], a[2], a[3], out);
    case Integral::f: return ellint_f(a[0], a[1], out);
    case Integral::e: return ellint_e(a[0], a[1], out);
    case Integral::pi: return ellint_pi(a[0], a[1], a[2], out);
  }
}

float call(Integral integral, const std::array<float, 4>& arguments) {
  Columns columns;
  for (std::size_t c = 0; c < columns.size(); ++c) columns[c] = {arguments[c]};
  float result = -1;
  call(integral, columns, {&result, 1});
  return result;
}

}  // namespace hatbox::test
