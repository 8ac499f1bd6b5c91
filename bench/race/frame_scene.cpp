#include "bench/race/frame_scene.h"

#include <cstdio>
#include <memory>
#include <stdexcept>

#include "meshes/write_mesh.h"

namespace plumb::bench {
namespace {

/// What both files are written from. Directions have unit length, so both programs mean the same by them: plumb makes
/// them so itself, and POV-Ray takes its three vectors as they are.
struct Frame {
  Point3 eye{1.6, 1.3, 3.4};
  Vec3 forward = normalized(Point3{} - eye);
  Vec3 right = normalized(cross(forward, {0, 1, 0}));
  Vec3 up = cross(right, forward);
  double distance = 1.5, width = 1.36, height = 1.02;
  Point3 light{-2, 5, 4};
  Color color{0.8, 0.65, 0.4};
};

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

File opened(const std::filesystem::path& path) {
  File file(std::fopen(path.c_str(), "w"), std::fclose);
  if (!file) throw std::runtime_error("cannot write " + path.string());
  return file;
}

void write_xml(const Frame& f, const std::filesystem::path& path) {
  const File file = opened(path);
  std::fprintf(file.get(),
               "<scene>\n"
               "  <camera>\n"
               "    <viewPoint>%.17g %.17g %.17g</viewPoint>\n"
               "    <viewDir>%.17g %.17g %.17g</viewDir>\n"
               "    <viewUp>0 1 0</viewUp>\n"
               "    <projDistance>%g</projDistance>\n"
               "    <viewWidth>%g</viewWidth>\n"
               "    <viewHeight>%g</viewHeight>\n"
               "  </camera>\n"
               "  <image>640 480</image>\n"
               "  <shader name=\"matt\" type=\"Lambertian\"><diffuseColor>%g %g %g</diffuseColor></shader>\n"
               "  <surface type=\"Mesh\"><shader ref=\"matt\" /><data>mesh.msh</data></surface>\n"
               "  <light><position>%g %g %g</position><intensity>1 1 1</intensity></light>\n"
               "</scene>\n",
               f.eye.x, f.eye.y, f.eye.z, f.forward.x, f.forward.y, f.forward.z, f.distance, f.width, f.height,
               f.color.r, f.color.g, f.color.b, f.light.x, f.light.y, f.light.z);
}

void write_vector(std::FILE* file, const char* name, const Vec3& v) {
  std::fprintf(file, "  %s <%.17g, %.17g, %.17g>\n", name, v.x, v.y, v.z);
}

/// The camera's vectors are given outright: so POV-Ray's left-handed default does not matter.
void write_pov(const TriangleMesh& mesh, const Frame& f, const std::filesystem::path& path) {
  const File file = opened(path);
  std::FILE* out = file.get();
  std::fprintf(out,
               "#version 3.7;\nglobal_settings { assumed_gamma 1 }\nbackground { rgb 0 }\ncamera {\n  perspective\n");
  write_vector(out, "location", f.eye - Point3{});
  write_vector(out, "direction", f.distance * f.forward);
  write_vector(out, "right", f.width * f.right);
  write_vector(out, "up", f.height * f.up);
  std::fprintf(out, "}\nlight_source { <%g, %g, %g> rgb 1 }\n", f.light.x, f.light.y, f.light.z);
  std::fprintf(out, "mesh2 {\n  vertex_vectors { %zu", mesh.positions.size());
  for (const Point3& p : mesh.positions) std::fprintf(out, ",\n<%.9g,%.9g,%.9g>", p.x, p.y, p.z);
  std::fprintf(out, " }\n  face_indices { %zu", mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles) std::fprintf(out, ",\n<%u,%u,%u>", a, b, c);
  std::fprintf(out, " }\n  pigment { rgb <%g, %g, %g> }\n  finish { ambient 0 diffuse 1 }\n}\n", f.color.r, f.color.g,
               f.color.b);
}

}  // namespace

void write_frame_scene(const TriangleMesh& mesh, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  const Frame frame;
  write_mesh(mesh, folder / "mesh.msh");
  write_xml(frame, folder / "scene.xml");
  write_pov(mesh, frame, folder / "scene.pov");
}

}  // namespace plumb::bench
