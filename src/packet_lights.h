// The lights of a packet's points: one for all of them, made once a job, or one a lane, gathered for each packet.
#pragma once

#include "kernel_lights.h"
#include "packets.h"

namespace hatbox::HATBOX_ISA {
namespace {

template <class Constants>
class PacketLights {
 public:
  using Light = typename KernelLight<Packet, Constants>::type;

  HATBOX_INLINE explicit PacketLights(const LightRows<Constants>& rows) : rows_(rows) {
    if (rows.index != nullptr) return;
    const auto* number = reinterpret_cast<const float*>(rows.rows);
    for (std::size_t i = 0; i < count; ++i) numbers()[i] = Packet(number[i]);
    complete();
  }

  /// Whether all points have one light.
  bool alike() const { return rows_.index == nullptr; }

  /// That light.
  const Light& one() const { return light_; }

  /// The light of each lane of the packet that lies at i.
  HATBOX_INLINE const Light& of(const AnyPacket<Packet>& packet, std::size_t i) {
    if (!alike()) gather(packet, rows_.index + i);
    return light_;
  }

 private:
  using Kept = typename Light::Kept;
  static constexpr std::size_t count = sizeof(Kept) / sizeof(Packet);

  Packet* numbers() { return reinterpret_cast<Packet*>(static_cast<Kept*>(&light_)); }

  [[gnu::noinline]] void gather(const AnyPacket<Packet>& packet, const std::uint32_t* index) {
    const float* row[lanes<Packet>];
    for (std::size_t lane = 0; lane < lanes<Packet>; ++lane) {
      const std::size_t place = packet.place(lane < packet.count ? lane : 0);
      row[lane] = reinterpret_cast<const float*>(rows_.rows + (index[place] - rows_.first));
    }
    for (std::size_t i = 0; i < count; i += 4) {
      const std::size_t at = i + 4 <= count ? i : count - 4;  // a row ends where it ends
      Packet columns[4];
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
