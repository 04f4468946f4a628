// The maps of a rectangle, by the names of RectangleMap.
#pragma once

#include "rectangle_area_map.h"
#include "rectangle_map.h"
#include "two_triangles_map.h"

namespace hatbox::HATBOX_ISA {
namespace {

template <class V>
using RectangleArea = RectangleAreaMap<V>;
template <class V>
using RectangleTwoTriangles = TwoTriangles<V>;
template <class V>
using RectangleSpherical = SphericalRectangle<V>;

}  // namespace
}  // namespace hatbox::HATBOX_ISA
