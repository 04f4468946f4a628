// Pictures for people: errors in false colour, and several pictures side by side.
#pragma once

#include "film.h"

#include <vector>

namespace wavefront {

/// The difference of the mean of the channels, on a logarithmic scale from 1e-4 (black) over blue, cyan, green, yellow
/// and red to 1 (white); a colour takes about two thirds of a decade.
Image false_colour_error(const Image& image, const Image& reference);

/// Rows of pictures of one size.
Image side_by_side(const std::vector<std::vector<const Image*>>& rows);

}  // namespace wavefront
