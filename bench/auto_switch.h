// The far-light switch of production renderers (Guillén et al. 2017, §4.2), as a comparator: area sampling where a
// light looks small, solid-angle sampling elsewhere. hatbox itself switches nowhere; the benchmark and the renderer ask
// here what a switch would gain.
#pragma once

#include <hatbox/hatbox.h>

namespace hatbox::bench {

/// Samples like hatbox::sample, with DiskMap::area where πr² cos/distance², the usual estimate of the solid angle, is
/// below `below` steradians and with DiskMap::ld_radial elsewhere. Blocks of points are sorted into the two, sampled,
/// and put back; a block of one kind is sampled in place.
void sample_auto(const Disk& light, float below, const Points& points, const Variates& variates, const Samples& out);

namespace parallel {
void sample_auto(const Disk& light, float below, const Points& points, const Variates& variates, const Samples& out);
}

}  // namespace hatbox::bench
