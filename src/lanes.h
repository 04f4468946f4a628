// Lanes that lie apart in memory: what fma.h and simd.h are for arithmetic, this is for moving them.
#pragma once

#include "twin.h"

namespace hatbox::HATBOX_ISA {
namespace {

template <class V>
inline constexpr std::size_t lanes = Lanes<V>::count;

// Four neighbouring numbers of a row a lane, as four vectors: out[i] has in lane j the i-th of row[j]. Loading quarters
// of rows and transposing them takes a third of the time of four gathers.
HATBOX_INLINE inline void load_rows(const float* const* row, std::size_t at, float (&out)[4]) {
  for (std::size_t i = 0; i < 4; ++i) out[i] = row[0][at + i];
}

#if defined(HATBOX_ISA_ARCH) && defined(__AVX512F__)
HATBOX_INLINE inline void load_rows(const float* const* row, std::size_t at, Packet (&out)[4]) {
  __m512 r[4];
  for (std::size_t i = 0; i < 4; ++i) {
    r[i] = _mm512_castps128_ps512(_mm_loadu_ps(row[i] + at));
    r[i] = _mm512_insertf32x4(r[i], _mm_loadu_ps(row[i + 4] + at), 1);
    r[i] = _mm512_insertf32x4(r[i], _mm_loadu_ps(row[i + 8] + at), 2);
    r[i] = _mm512_insertf32x4(r[i], _mm_loadu_ps(row[i + 12] + at), 3);
  }
  const auto pairs = [](__m512 x, __m512 y, bool high) {
    const __m512d a = _mm512_castps_pd(x), b = _mm512_castps_pd(y);
    return Packet(_mm512_castpd_ps(high ? _mm512_unpackhi_pd(a, b) : _mm512_unpacklo_pd(a, b)));
  };
  const __m512 low01 = _mm512_unpacklo_ps(r[0], r[1]), low23 = _mm512_unpacklo_ps(r[2], r[3]);
  const __m512 high01 = _mm512_unpackhi_ps(r[0], r[1]), high23 = _mm512_unpackhi_ps(r[2], r[3]);
  out[0] = pairs(low01, low23, false);
  out[1] = pairs(low01, low23, true);
  out[2] = pairs(high01, high23, false);
  out[3] = pairs(high01, high23, true);
}
#elif defined(HATBOX_ISA_ARCH) && defined(__AVX2__)
HATBOX_INLINE inline void load_rows(const float* const* row, std::size_t at, Packet (&out)[4]) {
  __m256 r[4];
  for (std::size_t i = 0; i < 4; ++i) {
    r[i] = _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_loadu_ps(row[i] + at)), _mm_loadu_ps(row[i + 4] + at), 1);
  }
  const auto pairs = [](__m256 x, __m256 y, bool high) {
    const __m256d a = _mm256_castps_pd(x), b = _mm256_castps_pd(y);
    return Packet(_mm256_castpd_ps(high ? _mm256_unpackhi_pd(a, b) : _mm256_unpacklo_pd(a, b)));
  };
  const __m256 low01 = _mm256_unpacklo_ps(r[0], r[1]), low23 = _mm256_unpacklo_ps(r[2], r[3]);
  const __m256 high01 = _mm256_unpackhi_ps(r[0], r[1]), high23 = _mm256_unpackhi_ps(r[2], r[3]);
  out[0] = pairs(low01, low23, false);
  out[1] = pairs(low01, low23, true);
  out[2] = pairs(high01, high23, false);
  out[3] = pairs(high01, high23, true);
}
#elif defined(HATBOX_ISA_ARCH)
HATBOX_INLINE inline void load_rows(const float* const* row, std::size_t at, Packet (&out)[4]) {
  float columns[4][4];
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t lane = 0; lane < 4; ++lane) columns[i][lane] = row[lane][at + i];
    out[i] = Packet::load_unaligned(columns[i]);
  }
}
#endif

template <class V>
HATBOX_INLINE inline void load_rows(const float* const* row, std::size_t at, Twin<V> (&out)[4]) {
  V first[4], second[4];
  load_rows(row, at, first);
  load_rows(row + lanes<V>, at, second);
  for (std::size_t i = 0; i < 4; ++i) out[i] = Twin<V>(first[i], second[i]);
}

}  // namespace
}  // namespace hatbox::HATBOX_ISA
