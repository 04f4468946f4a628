// An ellipse made ready for the kernels: its frame, worked out once a call in double.
#pragma once

#include "kernel_table.h"

#include <hatbox/lights.h>

namespace hatbox {

/// The light must be valid (see `check`). T is float or double.
template <class T>
EllipseConstantsOf<T> ellipse_constants(const Ellipse& light);

}  // namespace hatbox
