// The public calls for disks with a DiskTable.
#include "calls.h"
#include "dispatch.h"
#include "eta_rows.h"

#include <hatbox/disk_table.h>

#include <stdexcept>
#include <string>

namespace hatbox {
namespace {

DiskMap checked_base(DiskMap base) {
  if (base == DiskMap::ld_radial || base == DiskMap::radial) return base;
  throw std::invalid_argument("base: must be ld_radial or radial, not DiskMap " +
                              std::to_string(static_cast<std::size_t>(base)));
}

std::size_t checked_resolution(std::size_t resolution) {
  if (resolution >= DiskTable::least_resolution && resolution <= DiskTable::greatest_resolution) return resolution;
  throw std::invalid_argument("resolution: must be from " + std::to_string(DiskTable::least_resolution) + " to " +
                              std::to_string(DiskTable::greatest_resolution) + ", not " + std::to_string(resolution));
}

}  // namespace

/// What the kernels need of a table.
struct DiskTableKernels {
  static const MapKernels<TabulatedDisk>& of(const DiskTable& table) {
    return active_kernels().disk_table[table.base_ == DiskMap::ld_radial ? 0 : 1];
  }
  static TabulatedDisk ready(const DiskTable& table, const Disk& light) {
    return {hatbox::ready(light), table.coefficients_.get(), table.resolution_};
  }
};

DiskTable::DiskTable(DiskMap base, std::size_t resolution)
    : base_(checked_base(base)),
      resolution_(checked_resolution(resolution)),
      coefficients_(make_eta_rows(resolution)) {}

void sample(const Disk& light, const DiskTable& table, Points points, Variates variates, Samples out) {
  call_sample({}, DiskTableKernels::of(table), DiskTableKernels::ready(table, light), points, variates, out);
}

void pdf(const Disk& light, const DiskTable& table, Points points, Directions directions, std::span<float> out) {
  call_pdf({}, DiskTableKernels::of(table), DiskTableKernels::ready(table, light), points, directions, out);
}

void pdf(const Disk& light, const DiskTable& table, Points points, Places places, std::span<float> out) {
  call_pdf({}, DiskTableKernels::of(table), DiskTableKernels::ready(table, light), points, places, out);
}

void invert(const Disk& light, const DiskTable& table, Points points, Directions directions, std::span<float> u,
            std::span<float> v) {
  call_invert({}, DiskTableKernels::of(table), DiskTableKernels::ready(table, light), points, directions, u, v);
}

namespace parallel {

void sample(const Disk& light, const DiskTable& table, Points points, Variates variates, Samples out,
            std::size_t grain) {
  call_sample(parallel_with(grain), DiskTableKernels::of(table), DiskTableKernels::ready(table, light), points,
              variates, out);
}

void pdf(const Disk& light, const DiskTable& table, Points points, Directions directions, std::span<float> out,
         std::size_t grain) {
  call_pdf(parallel_with(grain), DiskTableKernels::of(table), DiskTableKernels::ready(table, light), points, directions,
           out);
}

void pdf(const Disk& light, const DiskTable& table, Points points, Places places, std::span<float> out,
         std::size_t grain) {
  call_pdf(parallel_with(grain), DiskTableKernels::of(table), DiskTableKernels::ready(table, light), points, places,
           out);
}

void invert(const Disk& light, const DiskTable& table, Points points, Directions directions, std::span<float> u,
            std::span<float> v, std::size_t grain) {
  call_invert(parallel_with(grain), DiskTableKernels::of(table), DiskTableKernels::ready(table, light), points,
              directions, u, v);
}

}  // namespace parallel
}  // namespace hatbox
