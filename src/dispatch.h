// Which kernels run. An API function asks once a call and keeps the answer, so that a call in flight is not disturbed
// when another thread forces another instruction set.
#pragma once

#include "kernel_table.h"

namespace hatbox {

/// The kernels that calls starting now use. Throws std::invalid_argument as `active_isa` does.
const KernelTable& active_kernels();

}  // namespace hatbox
