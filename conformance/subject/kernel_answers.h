#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "conformance/subject/kernel_message.h"
#include "conformance/subject/kernel_scene.h"
#include "conformance/subject/subject.h"

namespace plumb {

/// What every place of an answer holds before a kernel is called, so that one left unwritten is known: numbers that no
/// right answer holds.
inline constexpr std::uint32_t kUnwrittenIndex = 0xfffffffe;
inline constexpr std::uint8_t kUnwrittenFlag = 0xa5;
inline constexpr std::uint64_t kUnwrittenBits = 0x7ff8'0bad'0bad'0bad;
inline constexpr double kUnwrittenNumber = std::bit_cast<double>(kUnwrittenBits);  // a NaN

/// Hits as a kernel gave them; nothing about them is known yet. All arrays have the same length.
struct RawHits {
  std::vector<std::uint32_t> surface, primitive;
  std::vector<double> t, u, v;

  std::size_t count() const { return surface.size(); }
  void append(const RawHits& more, std::size_t begin, std::size_t end);
  void write(KernelMessageWriter& message) const;
  /// Throws KernelMessageFault.
  static RawHits read(KernelMessageReader& message, std::uint64_t count);
};

/// All hits of several rays: counts[i] of them belong to ray i, one after the other.
struct RawLists {
  std::vector<std::uint32_t> counts;
  RawHits hits;
};

/// What has to be known of a surface to judge an index.
struct AskedSurface {
  bool is_mesh = false;
  /// Triangles of a mesh; else 1.
  std::size_t primitives = 1;
};
std::vector<AskedSurface> asked_surfaces(const KernelScene& scene);

/// The answers, once each of them has been found possible: written, an index of a surface and of one of its triangles,
/// finite numbers. Whether t lies in the ray's range is for a check to judge. u and v of what is no mesh are ignored.
/// Throws SubjectFailure: fail with `protocol` or `not_finite`.
std::vector<SubjectHit> checked_hits(const RawHits& hits, std::span<const AskedSurface> surfaces);
std::vector<std::vector<SubjectHit>> checked_lists(const RawLists& lists, std::span<const AskedSurface> surfaces);
std::vector<std::uint8_t> checked_flags(std::vector<std::uint8_t> flags);
/// Six numbers a surface. The box of a mesh without triangles may be infinite, as an empty one is.
std::vector<Bounds3> checked_bounds(std::span<const double> numbers, std::span<const AskedSurface> surfaces);

}  // namespace plumb
