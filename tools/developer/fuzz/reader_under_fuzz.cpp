#include "tools/developer/fuzz/reader_under_fuzz.h"

#include <sanitizer/allocator_interface.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <system_error>

#include "meshes/read_mesh.h"
#include "renderer/math/input_error.h"

namespace plumb {
namespace {

// One thread reads, and the hooks see its allocations only while a file is being read.
bool watching = false;
std::size_t live = 0, peak = 0, allowed = 0;

std::size_t worst_peak = 0, worst_size = 0, meshes = 0, files = 0;
double worst_share = 0;

void on_malloc(const volatile void*, std::size_t size) {
  if (!watching) return;
  live += size;
  peak = std::max(peak, live);
  if (live <= allowed) return;
  watching = false;
  std::fprintf(stderr, "reading the file holds %zu bytes; the bound allows %zu\n", live, allowed);
  std::abort();
}

void on_free(const volatile void* pointer) {
  if (!watching || pointer == nullptr) return;
  const std::size_t size = __sanitizer_get_allocated_size(pointer);
  live -= std::min(live, size);  // what was allocated before may be freed meanwhile
}

void print_statistics() {
  std::fprintf(stderr,
               "%zu of %zu files were meshes; the largest share of the bound was %.3f: %zu bytes for a file of %zu\n",
               meshes, files, worst_share, worst_peak, worst_size);
}

void install() {
  if (__sanitizer_install_malloc_and_free_hooks(on_malloc, on_free) == 0) {
    std::fprintf(stderr, "the allocations cannot be watched\n");
    std::abort();
  }
  std::atexit(print_statistics);
}

void require(bool holds, const char* promise) {
  if (holds) return;
  std::fprintf(stderr, "the mesh breaks a promise: %s\n", promise);
  std::abort();
}

void require_sound(const TriangleMesh& mesh) {
  const std::size_t vertices = mesh.positions.size();
  require(mesh.normals.empty() || mesh.normals.size() == vertices, "one normal a vertex");
  require(mesh.texcoords.empty() || mesh.texcoords.size() == vertices, "one texture coordinate a vertex");
  for (const auto& t : mesh.triangles)
    require(t[0] < vertices && t[1] < vertices && t[2] < vertices, "every index is below the number of vertices");
  require(std::ranges::all_of(mesh.positions, is_finite<Point3>), "finite positions");
  require(std::ranges::all_of(mesh.normals, is_finite<Normal3>), "finite normals");
  for (const TexCoord& t : mesh.texcoords)
    require(std::isfinite(t.u) && std::isfinite(t.v), "finite texture coordinates");
}

struct ScratchFile {
  explicit ScratchFile(const std::string& ending) {
    const std::filesystem::path memory = "/dev/shm";
    const auto folder = std::filesystem::is_directory(memory) ? memory : std::filesystem::temp_directory_path();
    path = folder / ("plumb-fuzz-" + std::to_string(getpid()) + ending);
  }
  ~ScratchFile() {
    std::error_code ignored;
    std::filesystem::remove(path, ignored);
  }
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;

  std::filesystem::path path;
};

}  // namespace

const std::filesystem::path& scratch_file(const std::string& ending) {
  static const ScratchFile file(ending);
  return file.path;
}

bool read_under_fuzz(const std::filesystem::path& file, AllocationBound bound, const std::uint8_t* data,
                     std::size_t size, TriangleMesh& mesh) {
  static const bool installed = (install(), true);
  (void)installed;
  allowed = bound.per_byte * size + kConstantBytes;
  live = peak = 0;
  bool was_read = false;
  watching = true;
  try {
    mesh = parse_mesh(std::string(reinterpret_cast<const char*>(data), size), file);
    was_read = true;
  } catch (const InputError&) {
  }
  watching = false;
  ++files;
  if (const double share = static_cast<double>(peak) / static_cast<double>(allowed); share > worst_share) {
    worst_share = share;
    worst_peak = peak;
    worst_size = size;
  }
  if (!was_read) return false;
  ++meshes;
  require_sound(mesh);
  return true;
}

}  // namespace plumb
