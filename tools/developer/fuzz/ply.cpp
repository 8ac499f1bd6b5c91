#include "tools/developer/fuzz/reader_under_fuzz.h"

namespace {

/// The shortest numbers have one byte (uchar), and become 4 in the prepared file: 4 times the file, in a string that
/// may have twice the size. One face of as many corners as there are bytes: 12 for a triangle in a list whose length is
/// known, 4 for OpenMesh's list and 4 for ours, each three times while it grows: 8 + 12 + 24 = 44 a byte. A vertex of 5
/// bytes (x y z u v) costs 24 for its place and 16 for what it carries, 8 a byte. While the file is prepared there are
/// its content and three times the prepared file, 13 a byte; an element of the header, of 12 bytes, costs 3 * 72.
constexpr plumb::AllocationBound kBound = {48};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  plumb::TriangleMesh mesh;
  plumb::read_under_fuzz("x.ply", kBound, data, size, mesh);
  return 0;
}
