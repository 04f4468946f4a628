// A disk as the kernels see it.
#pragma once

#include "disk_constants.h"
#include "kernel_light.h"

namespace hatbox::HATBOX_ISA {
namespace {

template <class V>
struct DiskLight : DiskConstantsOf<V> {
  using Kept = DiskConstantsOf<V>;

  DiskLight() = default;
  explicit DiskLight(const Kept& kept) : Kept(kept) { derive(); }

  void derive() {}
};

/// With the table that its maps are read from (eta_table.h).
template <class V>
struct TabulatedDiskLight : DiskLight<V> {
  TabulatedDiskLight() = default;
  TabulatedDiskLight(const DiskConstantsOf<V>& disk, const float* table, std::size_t rows)
      : DiskLight<V>(disk), coefficients(table), resolution(rows) {}

  const float* coefficients;
  std::size_t resolution;
};

template <class V>
struct KernelLight<V, DiskConstants> {
  using type = DiskLight<V>;
};
template <class V>
struct KernelLight<V, TabulatedDisk> {
  using type = TabulatedDiskLight<V>;
};

}  // namespace
}  // namespace hatbox::HATBOX_ISA
