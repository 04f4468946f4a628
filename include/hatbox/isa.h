/// \file
/// Which instruction set the kernels use. The best one of this CPU is picked at the first call; the environment
/// variable HATBOX_ISA (scalar, sse4_2, avx2, avx512, neon) or `force_isa` overrides that. Where HATBOX_ISA names none
/// that there is, every call of the library throws as `active_isa` does, until `force_isa` has been called, which hosts
/// without exceptions may do first. All of them give the same bits, but for rare last-place differences of sse4_2,
/// which has no fused multiply-add.
#pragma once

#include <hatbox/export.h>

#include <span>

namespace hatbox {

/// What kernels are compiled for.
enum class Isa {
  scalar,  ///< plain float, any CPU
  sse4_2,  ///< slow: its fused multiply-add goes through double
  avx2,    ///< with FMA
  avx512,  ///< F, CD, DQ, BW and VL
  neon,    ///< of 64-bit Arm
};

/// The instruction set that calls starting now will use. Throws std::invalid_argument if HATBOX_ISA names one that is
/// unknown or that this CPU or build does not have; the message lists those there are. Thread-safe.
HATBOX_API Isa active_isa();

/// Those this CPU and this build have, slowest first. Thread-safe.
HATBOX_API std::span<const Isa> available_isas();

/// Uses `isa` from now on. Throws std::invalid_argument if it is not available. Thread-safe at any time: a call in
/// flight keeps the kernels it began with.
HATBOX_API void force_isa(Isa isa);

/// Of an instruction set: "scalar", "sse4_2", "avx2", "avx512" or "neon"; "unknown" for anything else.
HATBOX_API const char* name(Isa isa) noexcept;

}  // namespace hatbox
