// Three numbers of any precision, for the references.
#pragma once

#include <hatbox/lights.h>

#include <cmath>

namespace hatbox::reference {

template <class Real>
struct Vector {
  Real x, y, z;
};

template <class Real>
constexpr Vector<Real> operator+(const Vector<Real>& p, const Vector<Real>& q) {
  return {p.x + q.x, p.y + q.y, p.z + q.z};
}

template <class Real>
constexpr Vector<Real> operator-(const Vector<Real>& p, const Vector<Real>& q) {
  return {p.x - q.x, p.y - q.y, p.z - q.z};
}

template <class Real>
constexpr Vector<Real> operator*(Real factor, const Vector<Real>& p) {
  return {factor * p.x, factor * p.y, factor * p.z};
}

template <class Real>
constexpr Real dot(const Vector<Real>& p, const Vector<Real>& q) {
  return p.x * q.x + p.y * q.y + p.z * q.z;
}

template <class Real>
constexpr Vector<Real> cross(const Vector<Real>& p, const Vector<Real>& q) {
  return {p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
}

template <class Real>
Real length(const Vector<Real>& p) {
  return std::sqrt(dot(p, p));
}

template <class Real>
Vector<Real> normalize(const Vector<Real>& p) {
  return (1 / length(p)) * p;
}

template <class To, class From>
constexpr Vector<To> convert(const Vector<From>& p) {
  return {static_cast<To>(p.x), static_cast<To>(p.y), static_cast<To>(p.z)};
}

template <class To>
constexpr Vector<To> convert(const Vec3& p) {
  return {static_cast<To>(p.x), static_cast<To>(p.y), static_cast<To>(p.z)};
}

/// Right also where 1 − p·q or |p × q| alone would lose the angle.
template <class Real>
Real angle_between(const Vector<Real>& p, const Vector<Real>& q) {
  return std::atan2(length(cross(p, q)), dot(p, q));
}

}  // namespace hatbox::reference
