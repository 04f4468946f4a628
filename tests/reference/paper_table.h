// The tabulated radial map of [GUK*17], §4.1, as it is printed, in scalar double: what DiskTable is measured against.
// It is biased; tests/paper_table_test.cpp says by how much.
#pragma once

#include "reference/disk_reference.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace hatbox::reference {

/// The share Ω_r(φ)/Ω_r(π/2) over φ, for rows of β/α. One α serves all ellipses, since the share hardly varies with it
/// (the paper's claim; it does not say which α).
class PaperTable {
 public:
  explicit PaperTable(std::size_t resolution);

  /// ε₁ picks a quadrant and, by a binary search in the row below β/α, an entry: the spherical triangle between the
  /// centre and the rim at the entry's first φ, which Arvo 1995 samples. None if the sample is outside the ellipse.
  /// The density told is 1/Ω, as in the paper, though the true one differs.
  std::optional<DiskSample> sample(const PaperDisk& disk, float u, float v) const;

 private:
  std::vector<std::vector<double>> rows_;
};

}  // namespace hatbox::reference
