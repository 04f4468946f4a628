/// \file
/// The solid-angle maps of disks with their inversion read from a table: a table is made once and serves every disk.
///
/// What disk.h says of these calls holds here too, but for how far `pdf` of a sample strays from 1/Ω over one light.
/// With 64² coefficients or more that is 5e-4 at 99 % of points with x, y within ±3 radii and height 0.05 to 3.05, 1e-6
/// from 10 radii on, and 2e-2 at 99 % of points hugging the light (height 1e-5 to 1e-1).
#pragma once

#include <hatbox/disk.h>
#include <hatbox/export.h>

#include <cstddef>
#include <memory>
#include <span>

namespace hatbox {

/// DiskMap::ld_radial or DiskMap::radial with the angle of a direction interpolated in a table of resolution²
/// coefficients instead of a series found at every point (the idea is that of Guillén et al. 2017, §4.1). A map of its
/// own: nothing is rejected, and the densities are exactly those of its samples. They only vary more over the light
/// than those of the map it is based on.
///
/// Immutable; all calls may share one from any number of threads. Copies share the memory, which is 4·resolution²
/// bytes.
class DiskTable {
 public:
  /// @{
  /// What `resolution` may be.
  static constexpr std::size_t least_resolution = 4;
  static constexpr std::size_t greatest_resolution = 4096;
  /// @}

  /// Computes the table, with TBB in the caller's task arena. Throws std::invalid_argument unless `base` is ld_radial
  /// or radial and `resolution` between the two above.
  ///
  /// Cost: 25 ms at 1024² on two cores, 5 ms at 256².
  HATBOX_API explicit DiskTable(DiskMap base, std::size_t resolution = 1024);

  // No moves: they copy, so that no table is ever without its memory.
  /// @{
  /// Shares the memory.
  DiskTable(const DiskTable&) = default;
  DiskTable& operator=(const DiskTable&) = default;
  /// @}

  /// The map it is based on.
  DiskMap base() const noexcept { return base_; }

  /// Coefficients a side.
  std::size_t resolution() const noexcept { return resolution_; }

 private:
  friend struct DiskTableKernels;

  DiskMap base_;
  std::size_t resolution_;
  std::shared_ptr<const float[]> coefficients_;
};

/// As `sample` of disk.h, by the table.
///
/// Cost: five to eight times area sampling at one sample a point, three to four at 16. The README's tables have all.
///
/// Source: Guillén et al. 2017, §4.1, in the form that src/eta_table.h explains.
HATBOX_API void sample(const Disk& light, const DiskTable& table, Points points, Variates variates, Samples out);

/// The density, per steradian, with which that `sample` picks each of the k·n `directions`, as `pdf` of disk.h.
///
/// Cost of this and of what follows: about that of the call of disk.h.
HATBOX_API void pdf(const Disk& light, const DiskTable& table, Points points, Directions directions,
                    std::span<float> out);

/// The density, per steradian, with which that `sample` picks each of the k·n `places`, as `pdf` of disk.h.
HATBOX_API void pdf(const Disk& light, const DiskTable& table, Points points, Places places, std::span<float> out);

/// The (u, v) that `sample` turns into each of the k·n `directions`, as `invert` of disk.h.
HATBOX_API void invert(const Disk& light, const DiskTable& table, Points points, Directions directions,
                       std::span<float> u, std::span<float> v);

namespace parallel {

/// @{
/// The same calls, split into blocks of points by TBB; see disk.h.
HATBOX_API void sample(const Disk& light, const DiskTable& table, Points points, Variates variates, Samples out,
                       std::size_t grain = 0);
HATBOX_API void pdf(const Disk& light, const DiskTable& table, Points points, Directions directions,
                    std::span<float> out, std::size_t grain = 0);
HATBOX_API void pdf(const Disk& light, const DiskTable& table, Points points, Places places, std::span<float> out,
                    std::size_t grain = 0);
HATBOX_API void invert(const Disk& light, const DiskTable& table, Points points, Directions directions,
                       std::span<float> u, std::span<float> v, std::size_t grain = 0);
/// @}

}  // namespace parallel

}  // namespace hatbox
