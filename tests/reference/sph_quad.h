// The algorithm of Ureña, Fajardo and King 2013, Listings 1-3, as printed but for one end of a clamp: a rectangle's
// spherical map a sample at a time. In float it is what renderers use and what the benchmark compares with; with enough
// digits to afford its cancellations it is the reference of the tests.
#pragma once

#include "reference/vector.h"

#include <cmath>
#include <limits>

namespace hatbox::reference {

template <class Real>
class SphQuad {
 public:
  using Vec = Vector<Real>;

  /// The corner, the edges and the shading point.
  SphQuad(const Vec& s, const Vec& ex, const Vec& ey, const Vec& shading_point) : o(shading_point) {
    using std::acos;
    const Real exl = norm(ex), eyl = norm(ey);
    x = Real(1 / exl) * ex;
    y = Real(1 / eyl) * ey;
    z = cross(x, y);
    const Vec d = s - o;
    z0 = dot(d, z);
    if (z0 > 0) {
      z = Real(-1) * z;
      z0 = -z0;
    }
    x0 = dot(d, x);
    y0 = dot(d, y);
    x1 = x0 + exl;
    y1 = y0 + eyl;
    const Vec v00{x0, y0, z0}, v01{x0, y1, z0}, v10{x1, y0, z0}, v11{x1, y1, z0};
    const Vec n0 = unit(cross(v00, v10)), n1 = unit(cross(v10, v11)), n2 = unit(cross(v11, v01)),
              n3 = unit(cross(v01, v00));
    const Real g0 = acos(-dot(n0, n1)), g1 = acos(-dot(n1, n2)), g2 = acos(-dot(n2, n3)), g3 = acos(-dot(n3, n0));
    b0_ = n0.z;
    b1_ = n2.z;
    k_ = 2 * acos(Real(-1)) - g2 - g3;
    S = g0 + g1 - k_;
  }

  /// A point of the rectangle.
  Vec sample(const Real& u, const Real& v) const {
    const Vec p = local(u, v);
    return o + p.x * x + p.y * y + p.z * z;
  }

  /// The same in the axes of the reference system, from the shading point.
  Vec local(const Real& u, const Real& v) const {
    using std::cos;
    using std::sin;
    using std::sqrt;
    const Real au = u * S + k_;
    const Real fu = (cos(au) * b0_ - b1_) / sin(au);
    Real cu = 1 / sqrt(fu * fu + b0_ * b0_) * (fu > 0 ? 1 : -1);
    cu = clamp(cu, -1, 1);
    const Real xu = clamp(-(cu * z0) / sqrt(1 - cu * cu), x0, x1);
    const Real d = sqrt(xu * xu + z0 * z0);
    const Real h0 = y0 / sqrt(d * d + y0 * y0), h1 = y1 / sqrt(d * d + y1 * y1);
    const Real hv = h0 + v * (h1 - h0), hv2 = hv * hv;
    const Real end = hv > 0 ? y1 : y0;  // the listing has y1 for both
    const Real yv = hv2 < 1 - std::numeric_limits<Real>::epsilon() ? hv * d / sqrt(1 - hv2) : end;
    return {xu, yv, z0};
  }

  Real S;  // solid angle
  Vec o, x, y, z;
  Real x0, x1, y0, y1, z0;

 private:
  static Real norm(const Vec& p) {
    using std::sqrt;
    return sqrt(dot(p, p));
  }
  static Vec unit(const Vec& p) { return Real(1 / norm(p)) * p; }
  static Real clamp(const Real& x, const Real& low, const Real& high) { return x < low ? low : x > high ? high : x; }

  Real b0_, b1_, k_;
};

}  // namespace hatbox::reference
