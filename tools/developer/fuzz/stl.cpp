#include "tools/developer/fuzz/reader_under_fuzz.h"

namespace {

/// A binary facet takes 50 bytes: 12 for a triangle and 24 for each of three vertices, three times while the lists
/// grow, and 64 for each vertex in the map that joins equal ones: 3 * (12 + 72) + 3 * 64 = 444, or 9 a byte, and the
/// content. A facet in text takes more than 50 bytes.
constexpr plumb::AllocationBound kBound = {12};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  plumb::TriangleMesh mesh;
  plumb::read_under_fuzz("x.stl", kBound, data, size, mesh);
  return 0;
}
