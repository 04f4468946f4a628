// The vector vocabulary of the kernels: one small set of free functions over a value type V, which is
// xsimd::batch<float, Arch> in the kernels of an instruction set, float in those of Isa::scalar, and double in tests.
// Kernels are written in these alone, so one text serves all. Every operation here is correctly rounded (IEEE 754)
// on every instruction set, which is why they all return the same bits; see fma.h for the one exception.
#pragma once

#ifndef HATBOX_ISA
#error "define HATBOX_ISA, the name of the instruction set this is compiled for"
#endif

#ifdef HATBOX_ISA_ARCH
#define XSIMD_DEFAULT_ARCH xsimd::unsupported  // a bare batch<float> must not compile (from xsimd 11.1 on)
#include <xsimd/xsimd.hpp>
#endif

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

#ifdef HATBOX_ISA_ARCH
#if defined(__aarch64__)
// xsimd (8.1 to 14.3 at least) divides floats on NEON by Newton's method from an estimate, as 32-bit ARM must: not
// correctly rounded, and NaN for divisors near the ends of the range. Its operator/ is written with this member.
template <>
inline xsimd::batch<float, xsimd::neon64>& xsimd::batch<float, xsimd::neon64>::operator/=(const batch& other) noexcept {
  return *this = vdivq_f32(*this, other);
}
#elif defined(__AVX512F__)
// Its negative on AVX-512 is 0 − x, which is 0 for 0 where all others' is −0.
template <>
inline xsimd::batch<float, HATBOX_ISA_ARCH> xsimd::batch<float, HATBOX_ISA_ARCH>::operator-() const noexcept {
  return -static_cast<__m512>(*this);
}
#endif
#endif

// A kernel is one loop, in registers from load to store. Compilers think its larger parts too large to inline; under
// g++'s sanitizers, which make them ten times as large, they are right.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define HATBOX_INLINE
#else
#define HATBOX_INLINE __attribute__((always_inline))
#endif

namespace hatbox::HATBOX_ISA {
namespace {

// What a vector type is made of: its scalar, its mask and its number of lanes.
template <class V>
struct Lanes {
  using Scalar = V;
  using Mask = bool;
  static constexpr std::size_t count = 1;
};

template <class V>
using Mask = typename Lanes<V>::Mask;
template <class V>
using Scalar = typename Lanes<V>::Scalar;

template <class V>
inline V constant(double value) {
  return V(static_cast<Scalar<V>>(value));
}

template <class V>
inline constexpr double infinity = std::numeric_limits<Scalar<V>>::infinity();
template <class V>
inline constexpr double smallest_normal = std::numeric_limits<Scalar<V>>::min();
/// Of smaller sums of products some that count may have underflowed.
template <class V>
inline constexpr double least_sum_of_products = 0x1p26 * smallest_normal<V>;
template <class V>
inline constexpr double last_below_one = 1.0 - 0.5 * std::numeric_limits<Scalar<V>>::epsilon();

// Scalars: float for Isa::scalar, double for the tests.
template <class T>
using IfScalar = std::enable_if_t<std::is_floating_point_v<T>, T>;

template <class T>
inline IfScalar<T> select(bool mask, T yes, T no) {
  return mask ? yes : no;
}
template <class T>
inline IfScalar<T> sqrt(T x) {
  return std::sqrt(x);
}
template <class T>
inline IfScalar<T> abs(T x) {
  return std::fabs(x);
}
template <class T>
inline IfScalar<T> min(T x, T y) {  // y where either is NaN
  return x < y ? x : y;
}
template <class T>
inline IfScalar<T> max(T x, T y) {
  return x > y ? x : y;
}
template <class T>
inline IfScalar<T> copysign(T magnitude, T sign) {  // of a magnitude >= 0
  return std::copysign(magnitude, sign);
}
inline float power_of_two(float x) {  // at or next below |x|; 0 for a subnormal x
  return std::bit_cast<float>(std::bit_cast<std::uint32_t>(x) & 0x7f800000u);
}
inline double power_of_two(double x) {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) & 0x7ff0000000000000u);
}
inline float inverse_power_of_two(float x) {  // 1/power_of_two(x)
  return 0.5f * std::bit_cast<float>(~std::bit_cast<std::uint32_t>(x) & 0x7f800000u);
}
inline double inverse_power_of_two(double x) {
  return 0.5 * std::bit_cast<double>(~std::bit_cast<std::uint64_t>(x) & 0x7ff0000000000000u);
}
template <class T>
inline IfScalar<T> load(const T* from, T) {
  return *from;
}
template <class T, class = IfScalar<T>>
inline void store(T* to, T x) {
  *to = x;
}
template <class T>
inline IfScalar<T> truncate(T x) {  // of 0 <= x < 2^31
  return static_cast<T>(static_cast<int>(x));
}
template <class T>
inline IfScalar<T> gather(const float* from, T index) {  // of a table; the index is a whole number >= 0
  return static_cast<T>(from[static_cast<int>(index)]);
}
inline bool any(bool mask) { return mask; }

#ifdef HATBOX_ISA_ARCH
// For the one vector type of this object. No templates, so that they win over xsimd's functions of the same name; those
// of the kernels, which are templates, must have names of their own.
using Packet = xsimd::batch<float, HATBOX_ISA_ARCH>;
using PacketMask = Packet::batch_bool_type;

template <>
struct Lanes<Packet> {
  using Scalar = float;
  using Mask = PacketMask;
  static constexpr std::size_t count = Packet::size;
};

inline Packet select(const PacketMask& mask, const Packet& yes, const Packet& no) {
#if defined(__AVX512F__) || defined(__aarch64__)
  return xsimd::select(mask, yes, no);
#elif defined(__AVX__)  // g++ 12 makes four to five micro-operations of a blend with a computed mask; these are three
  return _mm256_or_ps(_mm256_and_ps(mask, yes), _mm256_andnot_ps(mask, no));
#else
  return _mm_or_ps(_mm_and_ps(mask, yes), _mm_andnot_ps(mask, no));
#endif
}
#if defined(__aarch64__)  // where xsimd's is an approximation
inline Packet sqrt(const Packet& x) { return vsqrtq_f32(x); }
#else
inline Packet sqrt(const Packet& x) { return xsimd::sqrt(x); }
#endif
inline Packet abs(const Packet& x) { return xsimd::abs(x); }
// minps and maxps are just that: the second operand unless the first is less, or greater. xsimd 14 swaps their
// operands.
#if defined(__AVX512F__)
inline Packet min(const Packet& x, const Packet& y) { return _mm512_min_ps(x, y); }
inline Packet max(const Packet& x, const Packet& y) { return _mm512_max_ps(x, y); }
#elif defined(__AVX__)
inline Packet min(const Packet& x, const Packet& y) { return _mm256_min_ps(x, y); }
inline Packet max(const Packet& x, const Packet& y) { return _mm256_max_ps(x, y); }
#elif defined(__x86_64__)
inline Packet min(const Packet& x, const Packet& y) { return _mm_min_ps(x, y); }
inline Packet max(const Packet& x, const Packet& y) { return _mm_max_ps(x, y); }
#else
inline Packet min(const Packet& x, const Packet& y) { return select(x < y, x, y); }
inline Packet max(const Packet& x, const Packet& y) { return select(x > y, x, y); }
#endif
inline Packet copysign(const Packet& magnitude, const Packet& sign) { return magnitude | (sign & Packet(-0.0f)); }
inline bool any(const PacketMask& mask) { return xsimd::any(mask); }
inline Packet power_of_two(const Packet& x) { return x & constant<Packet>(infinity<Packet>); }
inline Packet inverse_power_of_two(const Packet& x) {
  const Packet exponent(std::numeric_limits<float>::infinity());
  return Packet(0.5f) * ((x & exponent) ^ exponent);
}
inline Packet load(const float* from, const Packet&) { return Packet::load_unaligned(from); }
inline void store(float* to, const Packet& x) { x.store_unaligned(to); }
#if defined(__AVX512F__)
inline Packet truncate(const Packet& x) { return _mm512_cvtepi32_ps(_mm512_cvttps_epi32(x)); }
inline Packet gather(const float* from, const Packet& index) {
  return _mm512_i32gather_ps(_mm512_cvttps_epi32(index), from, sizeof(float));
}
#elif defined(__AVX2__)
inline Packet truncate(const Packet& x) { return _mm256_cvtepi32_ps(_mm256_cvttps_epi32(x)); }
inline Packet gather(const float* from, const Packet& index) {
  return _mm256_i32gather_ps(from, _mm256_cvttps_epi32(index), sizeof(float));
}
#else
#if defined(__aarch64__)
inline Packet truncate(const Packet& x) { return vrndq_f32(x); }
#else
inline Packet truncate(const Packet& x) { return _mm_cvtepi32_ps(_mm_cvttps_epi32(x)); }
#endif
inline Packet gather(const float* from, const Packet& index) {
  float lanes[Packet::size];
  index.store_unaligned(lanes);
  for (float& lane : lanes) lane = from[static_cast<int>(lane)];
  return Packet::load_unaligned(lanes);
}
#endif
#else
using Packet = float;
#endif

}  // namespace
}  // namespace hatbox::HATBOX_ISA
