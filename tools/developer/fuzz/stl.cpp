#include "tools/developer/fuzz/reader_under_fuzz.h"

namespace {

/// A binary facet takes 50 bytes: 12 for a triangle, in a list whose length is known, and for each of three vertices 3
/// * 24 while their list grows, and up to 16 in the table that joins equal ones: 276, or 6 a byte, and the content. A
/// facet in text takes more than 80 bytes, and 36 for a triangle.
constexpr plumb::AllocationBound kBound = {8};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  plumb::TriangleMesh mesh;
  plumb::read_under_fuzz("x.stl", kBound, data, size, mesh);
  return 0;
}
