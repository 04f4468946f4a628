// fma(x, y, z): x·y + z with one rounding, on every instruction set. Ours, because xsimd 8.1's is not fused on SSE4.2,
// AVX2 without FMA3 and AVX-512. SSE4.2 has no such instruction: there the product is taken in double, where it is
// exact, and the sum is rounded to double first; that differs in the last place once in some 10^8 calls and leaves
// product residuals x·y − round(x·y) exact.
#pragma once

#include "simd.h"

#if defined(HATBOX_ISA_ARCH) && defined(__x86_64__)
#include <immintrin.h>
#elif defined(HATBOX_ISA_ARCH) && defined(__aarch64__)
#include <arm_neon.h>
#endif

namespace hatbox::HATBOX_ISA {
namespace {

template <class T>
inline IfScalar<T> fma(T x, T y, T z) {
  return std::fma(x, y, z);
}

#ifdef HATBOX_ISA_ARCH
#if defined(__AVX512F__)
inline Packet fma(const Packet& x, const Packet& y, const Packet& z) { return _mm512_fmadd_ps(x, y, z); }
#elif defined(__FMA__)
inline Packet fma(const Packet& x, const Packet& y, const Packet& z) { return _mm256_fmadd_ps(x, y, z); }
#elif defined(__SSE4_2__)
inline Packet fma(const Packet& x, const Packet& y, const Packet& z) {
  const auto half = [](__m128 a, __m128 b, __m128 c) {
    return _mm_cvtpd_ps(_mm_add_pd(_mm_mul_pd(_mm_cvtps_pd(a), _mm_cvtps_pd(b)), _mm_cvtps_pd(c)));
  };
  const __m128 a = x, b = y, c = z;
  const __m128 low = half(a, b, c);
  const __m128 high = half(_mm_movehl_ps(a, a), _mm_movehl_ps(b, b), _mm_movehl_ps(c, c));
  return _mm_movelh_ps(low, high);
}
#elif defined(__aarch64__)
inline Packet fma(const Packet& x, const Packet& y, const Packet& z) { return vfmaq_f32(z, x, y); }
#else
#error "no fused multiply-add is known for this instruction set"
#endif
#endif

}  // namespace
}  // namespace hatbox::HATBOX_ISA
