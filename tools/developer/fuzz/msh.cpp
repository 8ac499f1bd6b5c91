#include <cstdio>
#include <cstdlib>

#include "meshes/formats/write_msh.h"
#include "meshes/read_mesh.h"
#include "tools/developer/fuzz/reader_under_fuzz.h"

namespace {

/// The content itself, and for each vertex, whose coordinates take 6 bytes of text at least ("0 0 0 "), 24 bytes of
/// position and, where the keywords follow, 24 of normal and 16 of texture coordinate, made before their numbers are
/// seen: 1 + 64 / 6 < 12. A triangle takes 6 bytes as well and needs only 12.
constexpr plumb::AllocationBound kBound = {12};

}  // namespace

/// Every mesh that is read must come back from write_msh as it was.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  plumb::TriangleMesh mesh;
  if (!plumb::read_under_fuzz("x.msh", kBound, data, size, mesh)) return 0;
  plumb::write_msh(mesh, plumb::scratch_file(".msh"));
  if (plumb::read_mesh(plumb::scratch_file(".msh")) != mesh) {
    std::fprintf(stderr, "what write_msh wrote is another mesh\n");
    std::abort();
  }
  return 0;
}
