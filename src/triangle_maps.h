// The maps of a triangle, by the names of TriangleMap.
#pragma once

#include "triangle_area_map.h"
#include "triangle_map.h"

namespace hatbox::HATBOX_ISA {
namespace {

template <class V>
using TriangleArea = TriangleAreaMap<V>;
template <class V>
using TriangleSpherical = TriangleMapOf<V>;

}  // namespace
}  // namespace hatbox::HATBOX_ISA
