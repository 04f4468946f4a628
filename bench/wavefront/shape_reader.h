// What a <shape> element is: a surface's geometry, a light, or the body that a medium fills.
#pragma once

#include "xml_element.h"

namespace wavefront {

/// Of a sphere, rectangle, disk, cube or obj. A disk that the transform makes an ellipse is one.
Geometry read_geometry(const XmlElement& element, Properties& properties, const Imath::M44d& to_world,
                       const std::filesystem::path& directory);

/// The light that a shape is; triangles without an area are noted in `ignored`.
Light make_light(const XmlElement& element, const Geometry& geometry, const Imath::M44d& to_world,
                 std::vector<std::string>& ignored);

/// Of a sphere or cube.
Medium::Body read_body(const XmlElement& element, Properties& properties, const Imath::M44d& to_world);

/// <medium>: sigmaS and sigmaA, or sigmaT and albedo; scale; phase (isotropic, hg).
Medium read_medium(const XmlElement& element, std::vector<std::string>& ignored);

}  // namespace wavefront
