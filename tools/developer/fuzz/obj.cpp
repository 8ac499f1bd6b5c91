#include "tools/developer/fuzz/reader_under_fuzz.h"

namespace {

/// A list that grows without its length being known holds three times its entries while it is moved (the old one and
/// one of twice the size), and twice of them from then on. What costs most are corners that name their vertex again:
/// with n digits to the number of vertices, "1 " becomes n + 1 bytes in its face and 8 for a vertex that stands in. A
/// file of one such face, with n up to 4, costs for each corner of 2 bytes: 2 * 13 in the prepared text, 2 * 4 for the
/// number that it stands for, 12 for a triangle, 28 for the corner, 3 * 4 in OpenMesh's list and 3 * 4 in ours, and the
/// line as OpenMesh holds it, in a string of up to twice its 5 bytes, in a stream and in a copy: 20. That is 118, or 59
/// a byte.
///
/// With texture coordinates, "1/1 ", it is 2 * 15, 8, 12, 28, 24 for those of a triangle, 2 * 28 for those that wait
/// for their face, 2 * 12 and 2 * 4 in OpenMesh's lists and ours, and 4 * 7 for the line: 218, or 55 a byte. Normals
/// give less. Where numbers are longer, faces of 1000 corners are a small part of the file, and the prepared text, of
/// at most 19 bytes a corner, the list behind it and the triangles are left: (2 * 19 + 8 + 12) / 2 = 29 a byte. Before
/// OpenMesh is asked, the content, three times the prepared text while it grows, and the list: 1 + (3 * 13 + 3 * 4) / 2
/// = 27.
constexpr plumb::AllocationBound kBound = {72};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  plumb::TriangleMesh mesh;
  plumb::read_under_fuzz("x.obj", kBound, data, size, mesh);
  return 0;
}
