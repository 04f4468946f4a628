// The disk's maps by name, to loop over and to print.
#pragma once

#include <hatbox/disk.h>

#include <array>

namespace hatbox::test {

inline constexpr std::array all_disk_maps{
    DiskMap::area,      DiskMap::ld_radial,      DiskMap::radial,          DiskMap::parallel,
    DiskMap::rejection, DiskMap::radial_carlson, DiskMap::parallel_carlson};

/// Those that have an inverse.
inline constexpr std::array disk_bijections{DiskMap::area,     DiskMap::ld_radial,      DiskMap::radial,
                                            DiskMap::parallel, DiskMap::radial_carlson, DiskMap::parallel_carlson};

/// Without those that are there for comparison: these are as uniform and as fast as the library promises.
inline constexpr std::array recommended_disk_maps{DiskMap::area, DiskMap::ld_radial, DiskMap::radial,
                                                  DiskMap::parallel};

inline const char* name(DiskMap map) {
  constexpr std::array names{"area",      "ld_radial",      "radial",          "parallel",
                             "rejection", "radial_carlson", "parallel_carlson"};
  return names[static_cast<std::size_t>(map)];
}

}  // namespace hatbox::test
