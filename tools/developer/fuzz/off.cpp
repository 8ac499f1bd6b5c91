#include <cstdio>
#include <cstdlib>

#include "tools/developer/fuzz/reader_under_fuzz.h"

namespace {

/// In text, a word of 2 bytes ("0 ") costs 3 * 16 for its place in the list of its line, while that grows: 24 a byte,
/// and the content and the prepared text with it. Later a corner of 2 bytes costs 12 for a triangle, 4 for OpenMesh's
/// list and 4 for ours, both three times while they grow: 18 a byte, and the prepared text. In the binary form a corner
/// takes 4 bytes.
constexpr plumb::AllocationBound kBound = {28};

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
