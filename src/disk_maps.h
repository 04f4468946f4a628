// The maps of a disk, by the names of DiskMap: those that are made of parts.
#pragma once

#include "area_map.h"
#include "disk_cone.h"
#include "eta_series.h"
#include "eta_table.h"
#include "parallel_carlson_map.h"
#include "parallel_map.h"
#include "radial_carlson_map.h"
#include "radial_map.h"
#include "rejection_map.h"

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
using DiskTableLdRadial = RadialMap<DiskCone<V>, EtaTable<V>, ConcentricChart>;
template <class V>
using DiskTableRadial = RadialMap<DiskCone<V>, EtaTable<V>, PolarChart>;

}  // namespace
}  // namespace hatbox::HATBOX_ISA
