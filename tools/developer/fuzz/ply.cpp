#include "tools/developer/fuzz/reader_under_fuzz.h"

namespace {

/// The shortest numbers have one byte (uchar), and become 4 in the prepared file: 4 times the file, in a string that
/// may have twice the size. One face of as many corners as there are bytes: 12 for a triangle, 4 for OpenMesh's list
/// and 4 for ours, each list three times while it grows, so 60 a corner. A vertex of 5 bytes (x y z u v) costs 24 for
/// its place and 3 * 56 for what it carries, 39 a byte. 8 + 60 < 72.
constexpr plumb::AllocationBound kBound = {72};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  plumb::TriangleMesh mesh;
  plumb::read_under_fuzz("x.ply", kBound, data, size, mesh);
  return 0;
}
