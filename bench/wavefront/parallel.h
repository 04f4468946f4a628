// Loops over the entries of a queue, by TBB.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>

namespace wavefront {

constexpr unsigned packet = 16;  // rays that Embree traces together

/// body(i) for all i below n.
template <class Body>
void in_parallel(std::size_t n, const Body& body) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n, 256), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) body(i);
  });
}

/// body(first, lanes) for packets of rays.
template <class Body>
void for_each_packet(std::size_t n, const Body& body) {
  tbb::parallel_for(std::size_t{0}, (n + packet - 1) / packet, [&](std::size_t i) {
    body(i * packet, static_cast<unsigned>(std::min<std::size_t>(packet, n - i * packet)));
  });
}

}  // namespace wavefront
