// Equiangular sampling (Kulla and Fajardo 2012): a variate → a place on a segment, uniform in the angle under which a
// pivot sees it, in a form without cancellation.
//
// The paper's t = δ + D tan(…) subtracts nearly equal numbers where the segment is short or far away, and divides by D.
// Here a place is found from the point C of the segment that is nearest to the pivot: the foot of the pivot's
// perpendicular, if that is within, else an end. With ω the angle from C to the place, κ the angle between the ray and
// the line to the segment's other end E, and ω_E the angle from C to E, the sine rule gives
//
//     offset from C = |C − pivot| sin ω / sin(κ + (ω_E − ω)),      pdf = D / (φ (D² + x²)), x measured from the foot:
//
// all sums positive, all angles acute, and D and the angles have only to be right relative to themselves.
#pragma once

#include "segment_view.h"
#include "trig.h"

namespace hatbox::HATBOX_ISA {
namespace {

/// atan2(y, x) and what it lacks of a quarter turn, y, x >= 0, not both 0. Max error: 4 ulp of either.
template <class V>
struct AcuteAngle {
  HATBOX_INLINE AcuteAngle(V y, V x) {
    const Mask<V> steep = y > x;
    const V lesser = atan_unit(min(y, x) / max(y, x)), greater = constant<V>(pi / 2) - lesser;
    angle = select(steep, greater, lesser);
    complement = select(steep, lesser, greater);
  }

  V angle, complement;
};

template <class V>
struct DistanceSample {
  V t, pdf;
};

template <class V>
class EquiangularMap {
 public:
  HATBOX_INLINE EquiangularMap(const Ray<V>& ray, const V (&pivot)[3]);

  HATBOX_INLINE DistanceSample<V> sample(V u) const;
  HATBOX_INLINE V pdf(V t) const;

 private:
  // Lengths are in units of `unit_`, a power of two, but for t and the two pairs.
  V t_min_, t_max_;
  SegmentView<V> view_;
  V unit_, per_unit_;
  Pair<V> nearest_;           // t at C
  V distance_;                // D
  V nearest_distance_;        // |C − pivot|
  V angle_;                   // φ, under which the whole segment is seen
  V angle_before_;            // that of the part on C's other side than E: from the end next to C
  V kappa_before_, kappa_;    // κ at the end next to C, and at E
  V density_;                 // D/φ
  Mask<V> mirrored_, valid_;  // C is next to the segment's end rather than to its start
};

template <class V>
HATBOX_INLINE inline EquiangularMap<V>::EquiangularMap(const Ray<V>& ray, const V (&pivot)[3])
    : t_min_(ray.t_min), t_max_(ray.t_max), view_(ray, pivot) {
  const V largest = constant<V>(std::numeric_limits<Scalar<V>>::max());
  const Pair<V> length = two_sum(min(t_max_, largest), -t_min_);
  const V start = view_.start.high + view_.start.low;
  const Pair<V> sum = two_sum(view_.start.high, length.high);
  const V end = sum.high + (sum.low + (view_.start.low + length.low));

  // The unit is how far the pivot is from the start. Where it lies there, it is the length, if there is one.
  const V reach = max(abs(start), view_.distance);
  const V finite_length = select(t_max_ < largest, length.high, V(0));
  const V extent = select(reach >= constant<V>(smallest_normal<V>), reach, finite_length);
  unit_ = power_of_two(extent);
  per_unit_ = inverse_power_of_two(extent);

  // No variate reaches further than 2^60 units, so that may stand for infinity (and for a sum that overflowed). A pivot
  // on the ray has a density, if not on the segment, and no angle: 2^-32 of a unit beside it, it has one.
  const V infinite = constant<V>(0x1p60);
  distance_ = max(view_.distance * per_unit_, constant<V>(0x1p-32));
  const V a = start * per_unit_, b = min(end * per_unit_, infinite);
  mirrored_ = a + b < V(0);
  const V before = select(mirrored_, -b, a), behind = select(mirrored_, -a, b);  // |before| <= behind
  const Mask<V> inside = before < V(0);
  const V scaled_length = min(length.high * per_unit_, infinite);

  // Next to an end, φ is the difference of the angles to both, in one arc tangent.
  const AcuteAngle<V> first(select(inside, -before, distance_ * scaled_length),
                            select(inside, distance_, fma(before, behind, distance_ * distance_)));
  const AcuteAngle<V> to_end(behind, distance_);
  angle_before_ = select(inside, first.angle, V(0));
  kappa_before_ = first.complement;
  kappa_ = to_end.complement;
  angle_ = select(inside, first.angle + to_end.angle, first.angle);
  density_ = distance_ / angle_;
  nearest_distance_ = select(inside, distance_, sqrt(fma(before, before, distance_ * distance_)));
  const Pair<V> foot = two_sum(t_min_, -view_.start.high);
  nearest_.high = select(inside, foot.high, select(mirrored_, t_max_, t_min_));
  nearest_.low = select(inside, foot.low - view_.start.low, V(0));
  valid_ = honest(honest(view_.valid, extent), angle_);
}

template <class V>
HATBOX_INLINE inline DistanceSample<V> EquiangularMap<V>::sample(V u) const {
  const V inside_u = max(min(u, constant<V>(last_below_one<V>)), V(0));
  const V rest_of_u = V(1) - inside_u;
  const V from_before = select(mirrored_, rest_of_u, inside_u), from_behind = select(mirrored_, inside_u, rest_of_u);
  const V turned = from_before * angle_;
  const Mask<V> is_before = turned < angle_before_;
  const V omega = abs(turned - angle_before_);
  const V at_place = select(is_before, kappa_before_ + turned, fma(from_behind, angle_, kappa_));
  const V offset = nearest_distance_ * sin_of_acute(omega) / sin_of_acute(at_place) * unit_;
  const V towards_end = select(is_before, -offset, offset);
  const V ahead = select(mirrored_, -towards_end, towards_end);
  const V t = max(min(nearest_.high + (nearest_.low + ahead), t_max_), t_min_);
  const V density = select(is_finite(u), pdf(t), V(0));
  return {select(density > V(0), t, V(0)), density};
}

/// From the t as it was rounded, so that `sample` and `pdf` agree.
template <class V>
HATBOX_INLINE inline V EquiangularMap<V>::pdf(V t) const {
  const Pair<V> way = two_sum(t, -t_min_);
  const Pair<V> from_foot = two_sum(way.high, view_.start.high);
  const V x = (from_foot.high + (from_foot.low + (way.low + view_.start.low))) * per_unit_;
  const V density = density_ / fma(x, x, distance_ * distance_) * per_unit_;
  const Mask<V> inside = valid_ && is_finite(t) && (t >= t_min_) && (t <= t_max_);
  return select(honest(inside, density), density, V(0));
}

}  // namespace
}  // namespace hatbox::HATBOX_ISA
