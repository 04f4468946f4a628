// The <transform> element.
#pragma once

#include "xml_element.h"

namespace wavefront {

/// Its steps (translate, rotate, scale, lookAt, matrix) apply in the order in which they are written.
Imath::M44d read_transform(const XmlElement& transform);

}  // namespace wavefront
