// The kernels' own text for tables, instantiated in double: what a table's map is, but for the rounding of floats.
#pragma once

#ifdef HATBOX_ISA
#error "include this before any kernel header"
#endif
#define HATBOX_ISA in_double
#include "disk_maps.h"

#include "disk_constants.h"
#include "eta_rows.h"
#include "support/workloads.h"

#include <memory>

namespace hatbox::test {

/// A light with a table, for the maps of namespace in_double.
class TableInDouble {
 public:
  TableInDouble(Pose pose, std::size_t resolution)
      : rows_(make_eta_rows(resolution)), disk_(constants_of<double>(disk_in(pose))), resolution_(resolution) {}

  in_double::TabulatedDiskLight<double> light() const { return {disk_, rows_.get(), resolution_}; }

 private:
  std::shared_ptr<const float[]> rows_;
  DiskConstantsOf<double> disk_;
  std::size_t resolution_;
};

}  // namespace hatbox::test
