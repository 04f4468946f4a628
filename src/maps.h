// The maps of every light, by the names of the public enums.
#pragma once

#include "area_map.h"
#include "ellipse_cone.h"
#include "eta_hybrid.h"
#include "eta_table.h"
#include "parallel_carlson_map.h"
#include "parallel_map.h"
#include "radial_carlson_map.h"
#include "radial_map.h"
#include "rectangle_area_map.h"
#include "rectangle_map.h"
#include "rejection_map.h"
#include "triangle_area_map.h"
#include "triangle_map.h"
#include "two_triangles_map.h"

namespace hatbox::HATBOX_ISA {
namespace {

template <class V>
using DiskArea = AreaMap<DiskCone<V>>;
template <class V>
using DiskLdRadial = RadialMap<DiskCone<V>, EtaSeries<V>, ConcentricChart>;
template <class V>
using DiskRadial = RadialMap<DiskCone<V>, EtaSeries<V>, PolarChart>;
template <class V>
using DiskParallel = ParallelMap<DiskCone<V>>;
template <class V>
using DiskRejection = RejectionMap<V>;
template <class V>
using DiskRadialCarlson = RadialCarlsonMap<V>;
template <class V>
using DiskParallelCarlson = ParallelCarlsonMap<V>;
template <class V>
using DiskTableLdRadial = RadialMap<DiskCone<V>, EtaTable<V>, ConcentricChart>;
template <class V>
using DiskTableRadial = RadialMap<DiskCone<V>, EtaTable<V>, PolarChart>;

template <class V>
using EllipseArea = AreaMap<EllipseCone<V>>;
template <class V>
using EllipseLdRadial = RadialMap<EllipseCone<V>, EtaHybrid<V>, ConcentricChart>;
template <class V>
using EllipseRadial = RadialMap<EllipseCone<V>, EtaHybrid<V>, PolarChart>;

template <class V>
using RectangleArea = RectangleAreaMap<V>;
template <class V>
using RectangleTwoTriangles = TwoTriangles<V>;
template <class V>
using RectangleSpherical = SphericalRectangle<V>;

template <class V>
using TriangleArea = TriangleAreaMap<V>;
template <class V>
using TriangleSpherical = TriangleMapOf<V>;

}  // namespace
}  // namespace hatbox::HATBOX_ISA
