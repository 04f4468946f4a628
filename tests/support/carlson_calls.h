// The elliptic integrals as values to loop over: name, number of arguments, and the call, sequential or parallel.
#pragma once

#include "golden/carlson_golden.h"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace hatbox::test {

inline constexpr std::array all_integrals{Integral::rf, Integral::rc, Integral::rd, Integral::rj,
                                          Integral::f,  Integral::e,  Integral::pi};

const char* name(Integral integral);

/// The names of its spans, in the order of the call.
std::vector<const char*> argument_names(Integral integral);

using Columns = std::array<std::vector<float>, 4>;  // those past an integral's number of arguments are not looked at

/// With a grain: the parallel call.
void call(Integral integral, const Columns& arguments, std::span<float> out, std::optional<std::size_t> grain = {});

/// The call on one element.
float call(Integral integral, const std::array<float, 4>& arguments);

}  // namespace hatbox::test
