// What stands in the table of eta_table.h: its coefficients, worked out in double.
#pragma once

#include <cstddef>
#include <memory>

namespace hatbox {

/// resolution² coefficients, a row for each σ from 0 to 1. Uses TBB. The resolution is at least 4.
std::shared_ptr<const float[]> make_eta_rows(std::size_t resolution);

}  // namespace hatbox
