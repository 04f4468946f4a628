// Two vectors worked on as one. A kernel over a Twin runs two independent chains of instructions side by side, which
// hides the latency of its divisions and square roots; each lane's bits are those of the plain vector.
#pragma once

#include "fma.h"

namespace hatbox::HATBOX_ISA {
namespace {

template <class M>
struct TwinMask {
  M first, second;

  friend TwinMask operator&&(const TwinMask& x, const TwinMask& y) {
    return {x.first && y.first, x.second && y.second};
  }
  friend TwinMask operator||(const TwinMask& x, const TwinMask& y) {
    return {x.first || y.first, x.second || y.second};
  }
  TwinMask operator!() const { return {!first, !second}; }
};

template <class V>
struct Twin {
  V first, second;

  Twin() = default;
  explicit Twin(Scalar<V> value) : first(value), second(value) {}
  Twin(const V& x, const V& y) : first(x), second(y) {}

  using M = TwinMask<hatbox::HATBOX_ISA::Mask<V>>;
  Twin operator-() const { return {-first, -second}; }
  friend Twin operator+(const Twin& x, const Twin& y) { return {x.first + y.first, x.second + y.second}; }
  friend Twin operator-(const Twin& x, const Twin& y) { return {x.first - y.first, x.second - y.second}; }
  friend Twin operator*(const Twin& x, const Twin& y) { return {x.first * y.first, x.second * y.second}; }
  friend Twin operator/(const Twin& x, const Twin& y) { return {x.first / y.first, x.second / y.second}; }
  friend M operator<(const Twin& x, const Twin& y) { return {x.first < y.first, x.second < y.second}; }
  friend M operator<=(const Twin& x, const Twin& y) { return {x.first <= y.first, x.second <= y.second}; }
  friend M operator>(const Twin& x, const Twin& y) { return {x.first > y.first, x.second > y.second}; }
  friend M operator>=(const Twin& x, const Twin& y) { return {x.first >= y.first, x.second >= y.second}; }
  friend M operator==(const Twin& x, const Twin& y) { return {x.first == y.first, x.second == y.second}; }
};

template <class V>
struct Lanes<Twin<V>> {
  using Scalar = typename Lanes<V>::Scalar;
  using Mask = TwinMask<typename Lanes<V>::Mask>;
  static constexpr std::size_t count = 2 * Lanes<V>::count;
};

template <class V>
inline Twin<V> select(const Mask<Twin<V>>& mask, const Twin<V>& yes, const Twin<V>& no) {
  return {select(mask.first, yes.first, no.first), select(mask.second, yes.second, no.second)};
}
template <class V>
inline Twin<V> sqrt(const Twin<V>& x) {
  return {sqrt(x.first), sqrt(x.second)};
}
template <class V>
inline Twin<V> abs(const Twin<V>& x) {
  return {abs(x.first), abs(x.second)};
}
template <class V>
inline Twin<V> min(const Twin<V>& x, const Twin<V>& y) {
  return {min(x.first, y.first), min(x.second, y.second)};
}
template <class V>
inline Twin<V> max(const Twin<V>& x, const Twin<V>& y) {
  return {max(x.first, y.first), max(x.second, y.second)};
}
template <class V>
inline Twin<V> copysign(const Twin<V>& x, const Twin<V>& y) {
  return {copysign(x.first, y.first), copysign(x.second, y.second)};
}
template <class M>
inline bool any(const TwinMask<M>& mask) {
  return any(mask.first || mask.second);
}
template <class V>
inline Twin<V> power_of_two(const Twin<V>& x) {
  return {power_of_two(x.first), power_of_two(x.second)};
}
template <class V>
inline Twin<V> inverse_power_of_two(const Twin<V>& x) {
  return {inverse_power_of_two(x.first), inverse_power_of_two(x.second)};
}
template <class V>
inline Twin<V> fma(const Twin<V>& x, const Twin<V>& y, const Twin<V>& z) {
  return {fma(x.first, y.first, z.first), fma(x.second, y.second, z.second)};
}
template <class V>
inline Twin<V> truncate(const Twin<V>& x) {
  return {truncate(x.first), truncate(x.second)};
}
template <class V>
inline Twin<V> gather(const float* from, const Twin<V>& index) {
  return {gather(from, index.first), gather(from, index.second)};
}
template <class V>
inline Twin<V> load(const Scalar<V>* from, const Twin<V>&) {
  return {load(from, V()), load(from + Lanes<V>::count, V())};
}
template <class V>
inline void store(Scalar<V>* to, const Twin<V>& x) {
  store(to, x.first);
  store(to + Lanes<V>::count, x.second);
}

}  // namespace
}  // namespace hatbox::HATBOX_ISA
