/// \file
/// Many lights of mixed kinds: every shading point has its own. The same calls as for one light, with a light index a
/// point; nobody has to sort anything.
///
/// What disk.h says of a single light's calls holds here, but that the Workspace is one call's at a time and may grow
/// (and then throw std::bad_alloc). Every lane has the bits of the call for its light alone. `light` holds n indices,
/// one a point, in any order; all k samples or queries of a point are of its light. One that is out of range:
/// std::invalid_argument, which names the first such position, and nothing is written.
#pragma once

#include <hatbox/arrays.h>
#include <hatbox/disk.h>
#include <hatbox/ellipse.h>
#include <hatbox/export.h>
#include <hatbox/lights.h>
#include <hatbox/rectangle.h>
#include <hatbox/triangle.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace hatbox {

/// An immutable set of lights, ready for the kernels. Index 0 is the first disk; the ellipses follow the disks, then
/// come the rectangles, then the triangles. At most 96 bytes a light. Copies share what is in it; any number of threads
/// may use one. One that was moved from may only be assigned to or destroyed.
class LightSet {
 public:
  /// The map that each kind of light is sampled by. The best exact ones by default.
  struct Maps {
    /// @{
    DiskMap disk = DiskMap::ld_radial;  ///< of all lights of this kind
    EllipseMap ellipse = EllipseMap::ld_radial;
    RectangleMap rectangle = RectangleMap::spherical;
    TriangleMap triangle = TriangleMap::spherical;
    /// @}
  };

  /// Keeps none of the spans; any of them may be empty. Throws std::invalid_argument if a light is not one (see
  /// `check`), a map does not exist or 32 bits cannot count the lights; the message names the span, the position and
  /// the member.
  ///
  /// Cost: 0.2 to 0.3 µs a light, in the caller's thread.
  HATBOX_API LightSet(std::span<const Disk> disks, std::span<const Ellipse> ellipses,
                      std::span<const Rectangle> rectangles, std::span<const Triangle> triangles, const Maps& maps);

  /// The same with the maps by default.
  LightSet(std::span<const Disk> disks, std::span<const Ellipse> ellipses, std::span<const Rectangle> rectangles,
           std::span<const Triangle> triangles)
      : LightSet(disks, ellipses, rectangles, triangles, Maps{}) {}

  /// How many lights there are.
  HATBOX_API std::size_t size() const noexcept;

  struct Data;  // the library's own
  /// Of no use but to the library.
  const Data& data() const noexcept { return *data_; }

 private:
  std::shared_ptr<const Data> data_;
};

/// Scratch memory of the calls below, to be used again and again: 0.4 MB for each thread that the caller's task arena
/// may have (at least two) in calls of `parallel`, for one in the others. Once it has its size, calls allocate nothing
/// here. One call at a time may use it. One that was moved from may only be assigned to or destroyed.
class Workspace {
 public:
  /// Small until its first use.
  HATBOX_API Workspace();
  HATBOX_API ~Workspace();
  /// @{
  /// Leaves the other one without its memory.
  HATBOX_API Workspace(Workspace&&) noexcept;
  HATBOX_API Workspace& operator=(Workspace&&) noexcept;
  /// @}

  struct Data;  // the library's own
  /// Of no use but to the library.
  Data& data() noexcept { return *data_; }

 private:
  std::unique_ptr<Data> data_;
};

/// Samples k directions from each of n points to its light, as `sample` of that light does.
///
/// Cost: 1.2 to 2 times the calls for each light alone in sets that fit the cache, up to three times in those of a
/// million. The README's tables have all.
HATBOX_API void sample(const LightSet& set, std::span<const std::uint32_t> light, Points points, Variates variates,
                       Samples out, Workspace& workspace);

/// The density, per steradian, with which `sample` picks each of the k·n `directions`: 0 for one that misses its light.
/// `out` has k·n elements. That a light was chosen at all is not in it.
///
/// Cost of this and of what follows, as of `sample`: up to twice the calls for each light alone.
HATBOX_API void pdf(const LightSet& set, std::span<const std::uint32_t> light, Points points, Directions directions,
                    std::span<float> out, Workspace& workspace);

/// The density, per steradian, with which `sample` picks the direction to each of the k·n `places`: 0 outside its
/// light. `out` has k·n elements.
HATBOX_API void pdf(const LightSet& set, std::span<const std::uint32_t> light, Points points, Places places,
                    std::span<float> out, Workspace& workspace);

/// The (u, v) that `sample` turns into each of the k·n `directions`: -1, -1 for one that misses its light or cannot be
/// sampled. `u` and `v` have k·n elements each. Throws std::invalid_argument if the set has disks that are sampled by
/// DiskMap::rejection.
HATBOX_API void invert(const LightSet& set, std::span<const std::uint32_t> light, Points points, Directions directions,
                       std::span<float> u, std::span<float> v, Workspace& workspace);

/// The solid angle, in steradians, of its light from each of the n points. `out` has n elements.
HATBOX_API void solid_angle(const LightSet& set, std::span<const std::uint32_t> light, Points points,
                            std::span<float> out, Workspace& workspace);

namespace parallel {

/// @{
/// The same calls, split into blocks of points by TBB; see disk.h.
HATBOX_API void sample(const LightSet& set, std::span<const std::uint32_t> light, Points points, Variates variates,
                       Samples out, Workspace& workspace, std::size_t grain = 0);
HATBOX_API void pdf(const LightSet& set, std::span<const std::uint32_t> light, Points points, Directions directions,
                    std::span<float> out, Workspace& workspace, std::size_t grain = 0);
HATBOX_API void pdf(const LightSet& set, std::span<const std::uint32_t> light, Points points, Places places,
                    std::span<float> out, Workspace& workspace, std::size_t grain = 0);
HATBOX_API void invert(const LightSet& set, std::span<const std::uint32_t> light, Points points, Directions directions,
                       std::span<float> u, std::span<float> v, Workspace& workspace, std::size_t grain = 0);
HATBOX_API void solid_angle(const LightSet& set, std::span<const std::uint32_t> light, Points points,
                            std::span<float> out, Workspace& workspace, std::size_t grain = 0);
/// @}

}  // namespace parallel

}  // namespace hatbox
