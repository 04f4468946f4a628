// Lanes that lie apart in memory: what fma.h and simd.h are for arithmetic, this is for moving them.
#pragma once

#include "fma.h"

namespace hatbox::HATBOX_ISA {
namespace {

template <class V>
inline constexpr std::size_t lanes = Lanes<V>::count;

// Four neighbouring numbers of a row a lane, as four vectors: out[i] has in lane j the i-th of row[j]. Loading quarters
// of rows and transposing them takes a third of the time of four gathers.
inline void load_rows(const float* const (&row)[1], std::size_t at, float (&out)[4]) {
  for (std::size_t i = 0; i < 4; ++i) out[i] = row[0][at + i];
}

// The values at from[offset[0]], from[offset[1]] and so on, and back.
inline float load_listed(const float* from, const std::uint32_t* offset, float) { return from[*offset]; }
inline void store_listed(float* to, const std::uint32_t* offset, float x) { to[*offset] = x; }

#if defined(HATBOX_ISA_ARCH) && defined(__AVX512F__)
inline void load_rows(const float* const (&row)[16], std::size_t at, Packet (&out)[4]) {
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
inline Packet load_listed(const float* from, const std::uint32_t* offset, const Packet&) {
  return _mm512_i32gather_ps(_mm512_loadu_si512(offset), from, sizeof(float));
}
inline void store_listed(float* to, const std::uint32_t* offset, const Packet& x) {
  _mm512_i32scatter_ps(to, _mm512_loadu_si512(offset), x, sizeof(float));
}
#elif defined(HATBOX_ISA_ARCH)
#if defined(__AVX2__)
inline void load_rows(const float* const (&row)[8], std::size_t at, Packet (&out)[4]) {
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
inline Packet load_listed(const float* from, const std::uint32_t* offset, const Packet&) {
  __m256i index;
  std::memcpy(&index, offset, sizeof index);
  return _mm256_i32gather_ps(from, index, sizeof(float));
}
#else
inline void load_rows(const float* const (&row)[4], std::size_t at, Packet (&out)[4]) {
  float columns[4][4];
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t lane = 0; lane < 4; ++lane) columns[i][lane] = row[lane][at + i];
    out[i] = Packet::load_unaligned(columns[i]);
  }
}
inline Packet load_listed(const float* from, const std::uint32_t* offset, const Packet&) {
  float gathered[4];
  for (std::size_t lane = 0; lane < 4; ++lane) gathered[lane] = from[offset[lane]];
  return Packet::load_unaligned(gathered);
}
#endif
inline void store_listed(float* to, const std::uint32_t* offset, const Packet& x) {
  float apart[lanes<Packet>];
  x.store_unaligned(apart);
  for (std::size_t lane = 0; lane < lanes<Packet>; ++lane) to[offset[lane]] = apart[lane];
}
#endif

}  // namespace
}  // namespace hatbox::HATBOX_ISA
