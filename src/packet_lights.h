// The lights of a packet's points: one for all of them, made once a call of a kernel, or one a lane, gathered for each
// packet.
#pragma once

#include "disk_light.h"
#include "kernel_table.h"
#include "lanes.h"
#include "packets.h"

namespace hatbox::HATBOX_ISA {
namespace {

template <class V, class Constants>
class PacketLights {
 public:
  using Light = typename KernelLight<V, Constants>::type;

  HATBOX_INLINE explicit PacketLights(const LightRows<Constants>& rows) : rows_(rows) {
    if (rows.index != nullptr) return;
    const auto* number = reinterpret_cast<const float*>(rows.rows);
    for (std::size_t i = 0; i < kept; ++i) numbers()[i] = V(number[i]);
    complete();
  }

  /// The lights of the packet of `count` points that lies at i.
  HATBOX_INLINE const Light& of(std::size_t i, std::size_t count) {
    if (rows_.index != nullptr) gather(rows_.index + i, count);
    return light_;
  }

 private:
  using Kept = typename Light::Kept;
  static constexpr std::size_t kept = sizeof(Kept) / sizeof(V);

  V* numbers() { return reinterpret_cast<V*>(static_cast<Kept*>(&light_)); }

  HATBOX_INLINE void gather(const std::uint32_t* index, std::size_t count) {
    if (count == lanes<V>) return gather(index);
    std::uint32_t padded[lanes<V>];
    for (std::size_t lane = 0; lane < lanes<V>; ++lane) padded[lane] = index[lane < count ? lane : 0];
    gather(padded);
  }

  [[gnu::noinline]] void gather(const std::uint32_t* index) {
    const auto* rows = reinterpret_cast<const float*>(rows_.rows);
    const float* row[lanes<V>];
    for (std::size_t lane = 0; lane < lanes<V>; ++lane) {
      row[lane] = rows + (index[lane] - rows_.first) * (sizeof(Constants) / sizeof(float));
    }
    for (std::size_t i = 0; i < kept; i += 4) {
      const std::size_t at = i + 4 <= kept ? i : kept - 4;  // a row ends where it ends
      V columns[4];
      load_rows(row, at, columns);
      for (std::size_t j = 0; j < 4; ++j) numbers()[at + j] = columns[j];
    }
    complete();
  }

  HATBOX_INLINE void complete() {
    if constexpr (std::is_same_v<Constants, TabulatedDisk>) {
      light_.coefficients = rows_.rows->coefficients;
      light_.resolution = rows_.rows->resolution;
    }
    light_.derive();
  }

  LightRows<Constants> rows_;
  Light light_;
};

}  // namespace
}  // namespace hatbox::HATBOX_ISA
