#include "tools/developer/fuzz/reader_under_fuzz.h"

namespace {

/// In a binary file the shortest corner has one byte (uchar) and becomes a triangle of 12, in a list that grows: 36 a
/// byte, and the content. A vertex of 8 bytes (x y z nx ny nz u v) costs 64. In text a corner of 2 bytes becomes 4 in
/// the prepared file, in a string that may have twice the size, 12 for a triangle in a list whose length is known, 4
/// for OpenMesh's list and 4 for ours, each three times while it grows: 8 + 12 + 24 = 44, so 22 a byte, and the
/// content. An element of the header, of 12 bytes, costs 3 * 72.
constexpr plumb::AllocationBound kBound = {40};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  plumb::TriangleMesh mesh;
  plumb::read_under_fuzz("x.ply", kBound, data, size, mesh);
  return 0;
}
