// The maps of an elliptical disk, by the names of EllipseMap, made of the same parts.
#pragma once

#include "area_map.h"
#include "ellipse_cone.h"
#include "eta_hybrid.h"
#include "radial_map.h"

namespace hatbox::HATBOX_ISA {
namespace {

template <class V>
using EllipseArea = AreaMap<EllipseCone<V>>;
template <class V>
using EllipseLdRadial = RadialMap<EllipseCone<V>, EtaHybrid<V>, ConcentricChart>;
template <class V>
using EllipseRadial = RadialMap<EllipseCone<V>, EtaHybrid<V>, PolarChart>;

}  // namespace
}  // namespace hatbox::HATBOX_ISA
