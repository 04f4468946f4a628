#include "kind_blocks.h"

namespace hatbox {

std::optional<std::size_t> KindBlock::sort(const LightSet::Data& set, const KernelTable& table,
                                           std::span<const std::uint32_t> lights) {
  std::size_t listed = 0;
  for (std::size_t kind = 0; kind < light_kind_count; ++kind) {
    const std::uint32_t low = set.bounds[kind], high = set.bounds[kind + 1];
    if (high - low == set.size()) return kind;  // the set has no other
    counts_[kind] =
        low == high ? 0
                    : table.list_between(lights.data(), lights.size(), low, high, &order_[listed], &lights_[listed]);
    if (counts_[kind] == lights.size()) return kind;
    listed += counts_[kind];
  }
  for (std::uint32_t i = 0; i < listed; ++i) rank_[order_[i]] = i;
  return {};
}

CallArrays KindBlock::points_of(const CallArrays& call, const KernelTable& table, std::size_t begin, std::size_t size) {
  CallArrays block = {{stride_of(size), 0}, {}, {}, {}};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    table.permute(call.point[axis] + begin, order_.data(), point_[axis].data(), size);
    block.point[axis] = point_[axis].data();
  }
  return block;
}

void KindBlock::take(const CallArrays& call, const KernelTable& table, std::size_t begin, std::size_t size,
                     std::size_t j, CallArrays& block) {
  const std::size_t stride = block.size.points;
  for (std::size_t which = 0; which < in_.size(); ++which) {
    if (call.in[which] == nullptr) continue;
    block.in[which] = in_[which].data();
    for (std::size_t i = 0; i < block.size.per_point; ++i) {
      table.permute(call.in[which] + (j + i) * call.size.points + begin, order_.data(), &in_[which][i * stride], size);
    }
  }
  for (std::size_t which = 0; which < out_.size(); ++which) {
    block.out[which] = call.out[which] == nullptr ? nullptr : out_[which].data();
  }
}

void KindBlock::give(const CallArrays& call, const KernelTable& table, std::size_t begin, std::size_t size,
                     std::size_t j, const CallArrays& block) const {
  const std::size_t stride = block.size.points;
  for (std::size_t which = 0; which < out_.size(); ++which) {
    if (call.out[which] == nullptr) continue;
    for (std::size_t i = 0; i < block.size.per_point; ++i) {
      table.permute(&out_[which][i * stride], rank_.data(), call.out[which] + (j + i) * call.size.points + begin, size);
    }
  }
}

}  // namespace hatbox
