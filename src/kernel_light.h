// A light as the kernels see it: the numbers that are kept of it (light_rows.h) and what follows from them, each in a
// vector. Either all lanes have the same light, or every lane has its own; the text that reads it is the same.
//
// What follows is worked out here, in the kernels' own arithmetic, so that a lane's bits do not depend on which of the
// two it was, and so that little needs to be kept of a light.
#pragma once

#include "simd.h"

namespace hatbox::HATBOX_ISA {
namespace {

/// The light that kernels make of constants; <light>_light.h says which.
template <class V, class Constants>
struct KernelLight;

}  // namespace
}  // namespace hatbox::HATBOX_ISA
