// A disk made ready for the kernels: its frame, worked out once a call in double.
#pragma once

#include "kernel_table.h"

#include <hatbox/lights.h>

namespace hatbox {

/// The light must be valid (see `check`). T is float or double.
template <class T>
DiskConstantsOf<T> disk_constants(const Disk& light);

/// The constants of a light that passes `check`; throws std::invalid_argument otherwise.
DiskConstants ready(const Disk& light);

}  // namespace hatbox
