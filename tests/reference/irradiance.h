// The irradiance of a patch lit by a whole disk or ellipse of unit radiance, by Lambert's contour integral: independent
// of every formula that the library or the other references use.
#pragma once

#include "reference/vector.h"

namespace hatbox::reference {

/// The part of the light below the patch's horizon is clipped. `patch_normal` must be of unit length.
double irradiance(const Disk& light, const Vec3& point, const Vector<double>& patch_normal);
double irradiance(const Ellipse& light, const Vec3& point, const Vector<double>& patch_normal);

}  // namespace hatbox::reference
