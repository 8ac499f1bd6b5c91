#include "tools/developer/fuzz/reader_under_fuzz.h"

namespace {

/// A list that grows without its length being known holds three times its entries while it is moved (the old one and
/// one of twice the size), and twice of them from then on. What costs most are corners with texture coordinates, "1/1
/// ", in fans over vertices that were named before. A fan of 99 vertices takes 488 bytes and gives 97 triangles, each
/// with 12 bytes of indices and 3 * 56 of what its corners carry: 3 * 180 * 97 / 488 = 107 a byte. The prepared text,
/// with negative indices spelt out, is at most 4 times the file in a string of twice that: 8 more. Later, when each
/// corner has become a vertex, 2 * 180 a triangle, and 88 for an entry of the map and 3 * (24 + 16) for a vertex a
/// corner: 113 a byte, and the same 8.
constexpr plumb::AllocationBound kBound = {128};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  plumb::TriangleMesh mesh;
  plumb::read_under_fuzz("x.obj", kBound, data, size, mesh);
  return 0;
}
