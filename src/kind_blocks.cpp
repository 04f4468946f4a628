#include "kind_blocks.h"

#include <algorithm>
#include <array>
#include <utility>

namespace hatbox {
namespace {

/// Brings numbers of arrays into an order: to[i] = from[index[i]], for several arrays at a time, so that the index is
/// read once for all of them. By plain loads and stores, which are as fast as gathers where those are fast.
class Permutation {
 public:
  Permutation(const std::uint32_t* index, std::size_t size) : index_(index), size_(size) {}

  void add(const float* from, float* to) {
    moves_[count_++] = {from, to};
    if (count_ == most) finish();
  }

  /// To be called after the last.
  void finish() {
    static_assert(most == 4);
    if (count_ == 4) move(std::make_index_sequence<4>());
    if (count_ == 3) move(std::make_index_sequence<3>());
    if (count_ == 2) move(std::make_index_sequence<2>());
    if (count_ == 1) move(std::make_index_sequence<1>());
    count_ = 0;
  }

 private:
  static constexpr std::size_t most = 4;
  struct Move {
    const float* from;
    float* to;
  };

  template <std::size_t... array>
  void move(std::index_sequence<array...>) const {
    const Move moves[] = {moves_[array]...};  // our own, which no store can change
    for (std::size_t i = 0; i < size_; ++i) {
      const std::size_t at = index_[i];
      const float values[] = {moves[array].from[at]...};
      ((moves[array].to[i] = values[array]), ...);
    }
  }

  const std::uint32_t* index_;
  std::size_t size_;
  Move moves_[most];
  std::size_t count_ = 0;
};

}  // namespace

// A counting sort: how many there are of each kind tells where it begins.
std::optional<std::size_t> KindBlock::sort(const LightSet::Data& set, std::span<const std::uint32_t> lights) {
  for (std::size_t kind = 0; kind < light_kind_count; ++kind) {
    if (set.bounds[kind + 1] - set.bounds[kind] == set.size()) return kind;  // the set has no other
  }
  const std::uint32_t first = set.bounds[1], second = set.bounds[2], third = set.bounds[3];
  std::uint32_t from_first = 0, from_second = 0, from_third = 0;  // how many lights are not before these
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const std::uint32_t is_from_first = lights[i] >= first ? 1 : 0, is_from_second = lights[i] >= second ? 1 : 0,
                        is_from_third = lights[i] >= third ? 1 : 0;
    from_first += is_from_first;
    from_second += is_from_second;
    from_third += is_from_third;
    rank_[i] = is_from_first + is_from_second + is_from_third;  // the kind, for now
  }
  const auto size = static_cast<std::uint32_t>(lights.size());
  counts_ = {size - from_first, from_first - from_second, from_second - from_third, from_third};
  for (std::size_t kind = 0; kind < light_kind_count; ++kind) {
    if (counts_[kind] == size) return kind;
  }
  place(lights);
  return {};
}

// The next place of each kind is 16 bits of one number, so that none is read back from memory that has just been
// written.
void KindBlock::place(std::span<const std::uint32_t> lights) {
  constexpr std::size_t bits = 16;
  static_assert(most_points < 1u << bits && light_kind_count * bits <= 64);
  std::uint64_t next = 0, start = 0;
  for (std::size_t kind = 0; kind < light_kind_count; ++kind) {
    next |= start << (kind * bits);
    start += counts_[kind];
  }
  for (std::uint32_t i = 0; i < lights.size(); ++i) {
    const std::uint32_t shift = rank_[i] * bits, light = lights[i];
    const auto rank = static_cast<std::uint16_t>(next >> shift);
    next += std::uint64_t{1} << shift;
    rank_[i] = rank;
    order_[rank] = i;
    lights_[rank] = light;
  }
}

CallArrays KindBlock::points_of(const CallArrays& call, std::size_t begin, std::size_t size) {
  CallArrays block = {{stride_of(size), 0}, {}, {}, {}};
  Permutation to_order(order_.data(), size);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    to_order.add(call.point[axis] + begin, point_[axis].data());
    block.point[axis] = point_[axis].data();
  }
  to_order.finish();
  return block;
}

void KindBlock::take(const CallArrays& call, std::size_t begin, std::size_t size, std::size_t j, CallArrays& block) {
  const std::size_t stride = block.size.points;
  Permutation to_order(order_.data(), size);
  for (std::size_t which = 0; which < in_.size(); ++which) {
    if (call.in[which] == nullptr) continue;
    block.in[which] = in_[which].data();
    for (std::size_t i = 0; i < block.size.per_point; ++i) {
      to_order.add(call.in[which] + (j + i) * call.size.points + begin, &in_[which][i * stride]);
    }
  }
  to_order.finish();
  for (std::size_t which = 0; which < out_.size(); ++which) {
    block.out[which] = call.out[which] == nullptr ? nullptr : out_[which].data();
  }
}

void KindBlock::give(const CallArrays& call, std::size_t begin, std::size_t size, std::size_t j,
                     const CallArrays& block) const {
  const std::size_t stride = block.size.points;
  Permutation back(rank_.data(), size);
  for (std::size_t which = 0; which < out_.size(); ++which) {
    if (call.out[which] == nullptr) continue;
    for (std::size_t i = 0; i < block.size.per_point; ++i) {
      back.add(&out_[which][i * stride], call.out[which] + (j + i) * call.size.points + begin);
    }
  }
  back.finish();
}

}  // namespace hatbox
