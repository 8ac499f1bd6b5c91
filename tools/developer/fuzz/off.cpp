#include <cstdio>
#include <cstdlib>

#include "tools/developer/fuzz/reader_under_fuzz.h"

namespace {

/// In text a corner takes 2 bytes ("0 ") and costs 12 for a triangle, 4 for OpenMesh's list and 4 for ours, each list
/// three times while it grows: 30 a byte, and the prepared text in a string of up to twice its size. Before that, a
/// word of 2 bytes costs 3 * 16 for its place in the list of a line: 24 a byte, the content, and 3 for the prepared
/// text while it grows. 30 + 2 < 36. In the binary form a corner takes 4 bytes.
constexpr plumb::AllocationBound kBound = {36};

}  // namespace

/// OpenMesh opens the file to learn its kind, so there has to be one.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::filesystem::path& file = plumb::scratch_file(".off");
  std::FILE* out = std::fopen(file.c_str(), "wb");
  if (out == nullptr || std::fwrite(data, 1, size, out) != size || std::fclose(out) != 0) std::abort();
  plumb::TriangleMesh mesh;
  plumb::read_under_fuzz(file, kBound, data, size, mesh);
  return 0;
}
