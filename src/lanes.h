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

// The values at from[index[0]], from[index[1]] and so on.
inline float gather_at(const float* from, const std::uint32_t* index, float) { return from[*index]; }

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
inline Packet gather_at(const float* from, const std::uint32_t* index, const Packet&) {
  return _mm512_i32gather_ps(_mm512_loadu_si512(index), from, sizeof(float));
}
#elif defined(HATBOX_ISA_ARCH)
#if defined(__AVX2__)
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
inline Packet gather_at(const float* from, const std::uint32_t* index, const Packet&) {
  __m256i where;
  std::memcpy(&where, index, sizeof where);
  return _mm256_i32gather_ps(from, where, sizeof(float));
}
#else
HATBOX_INLINE inline void load_rows(const float* const* row, std::size_t at, Packet (&out)[4]) {
  float columns[4][4];
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t lane = 0; lane < 4; ++lane) columns[i][lane] = row[lane][at + i];
    out[i] = Packet::load_unaligned(columns[i]);
  }
}
inline Packet gather_at(const float* from, const std::uint32_t* index, const Packet&) {
  float gathered[4];
  for (std::size_t lane = 0; lane < 4; ++lane) gathered[lane] = from[index[lane]];
  return Packet::load_unaligned(gathered);
}
#endif
#endif

/// Of list_between (kernel_table.h), what whole packets of numbers there are: all but the last few, or where compilers
/// do as well, none. Returns how many numbers that was.
inline std::size_t list_whole_between([[maybe_unused]] const std::uint32_t* numbers, [[maybe_unused]] std::size_t n,
                                      [[maybe_unused]] std::uint32_t low, [[maybe_unused]] std::uint32_t high,
                                      [[maybe_unused]] std::uint32_t* where, [[maybe_unused]] std::uint32_t* which,
                                      [[maybe_unused]] std::size_t& listed) {
  std::size_t i = 0;
#if defined(HATBOX_ISA_ARCH) && defined(__AVX512F__)
  const __m512i first = _mm512_set1_epi32(static_cast<int>(low)),
                size = _mm512_set1_epi32(static_cast<int>(high - low));
  __m512i at = _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
  for (; i + 16 <= n; i += 16) {
    const __m512i number = _mm512_loadu_si512(numbers + i);
    const __mmask16 between = _mm512_cmplt_epu32_mask(_mm512_sub_epi32(number, first), size);
    _mm512_storeu_si512(where + listed, _mm512_maskz_compress_epi32(between, at));
    _mm512_storeu_si512(which + listed, _mm512_maskz_compress_epi32(between, number));
    listed += static_cast<std::size_t>(std::popcount(static_cast<unsigned>(between)));
    at = _mm512_add_epi32(at, _mm512_set1_epi32(16));
  }
#endif
  return i;
}

template <class V>
HATBOX_INLINE inline void load_rows(const float* const* row, std::size_t at, Twin<V> (&out)[4]) {
  V first[4], second[4];
  load_rows(row, at, first);
  load_rows(row + lanes<V>, at, second);
  for (std::size_t i = 0; i < 4; ++i) out[i] = Twin<V>(first[i], second[i]);
}

}  // namespace
}  // namespace hatbox::HATBOX_ISA
