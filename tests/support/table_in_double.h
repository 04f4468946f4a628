// The kernels' own text for tables, instantiated in double: what a table's map is, but for the rounding of floats.
#pragma once

#ifdef HATBOX_ISA
#error "include this before any kernel header"
#endif
#define HATBOX_ISA in_double
#include "maps.h"

#include "eta_rows.h"
#include "light_constants.h"
#include "support/workloads.h"

#include <memory>

namespace hatbox::test {

/// A light with a table, for the maps of namespace in_double.
class TableInDouble {
 public:
  TableInDouble(Pose pose, std::size_t resolution)
      : rows_(make_eta_rows(resolution)), light_{constants_of<double>(disk_in(pose)), rows_.get(), resolution} {}

  const TabulatedDiskOf<double>& light() const { return light_; }

 private:
  std::shared_ptr<const float[]> rows_;
  TabulatedDiskOf<double> light_;
};

}  // namespace hatbox::test
