#include "meshes/formats/write_msh.h"

#include <charconv>
#include <ostream>

#include "meshes/formats/sound_mesh.h"
#include "meshes/formats/staged_mesh_file.h"
#include "meshes/formats/write_progress.h"

namespace plumb {
namespace {

class MshWriter {
 public:
  MshWriter(const TriangleMesh& mesh, std::ostream& out, const std::function<void(double)>& progress)
      : mesh_(mesh), out_(out), progress_(progress, steps_of(mesh)) {}

  void write() {
    put(mesh_.positions.size());
    put(mesh_.triangles.size());
    put_triples("vertices\n", mesh_.positions);
    out_ << "triangles\n";
    for (const auto& triangle : mesh_.triangles) {
      for (const std::uint32_t index : triangle) put(index);
      progress_.step();
    }
    if (!mesh_.texcoords.empty()) out_ << "texcoords\n";
    for (const TexCoord& t : mesh_.texcoords) {
      put(t.u);
      put(t.v);
      progress_.step();
    }
    if (!mesh_.normals.empty()) put_triples("normals\n", mesh_.normals);
  }

 private:
  static std::size_t steps_of(const TriangleMesh& mesh) {
    return mesh.positions.size() + mesh.triangles.size() + mesh.texcoords.size() + mesh.normals.size();
  }

  template <class Number>
  void put(Number value) {
    char line[32];  // the longest double is -2.2250738585072014e-308, 24 bytes
    char* const end = std::to_chars(line, line + sizeof line - 1, value).ptr;
    *end = '\n';
    out_.write(line, end + 1 - line);
  }

  template <class Triple>
  void put_triples(const char* keyword, const std::vector<Triple>& triples) {
    out_ << keyword;
    for (const Triple& t : triples) {
      put(t.x);
      put(t.y);
      put(t.z);
      progress_.step();
    }
  }

  const TriangleMesh& mesh_;
  std::ostream& out_;
  WriteProgress progress_;
};

}  // namespace

void write_msh(const TriangleMesh& mesh, const std::filesystem::path& file,
               const std::function<void(double)>& progress) {
  require_sound(mesh);
  StagedMeshFile staged(file);
  MshWriter(mesh, staged.stream(), progress).write();
  staged.commit();
}

}  // namespace plumb
