// What reading a mesh of 1.1 million triangles costs on one thread, from a file that the system's cache holds. The
// peers read the same file in turn within one iteration, so that what else the machine does falls on both; the times
// are medians of CPU time. `.msh` by a plain reader on std::ifstream, and by ours: once with the shortest digits of
// floats, as such files usually have, and once with those of doubles. Binary PLY by OpenMesh, read into its own mesh,
// and by ours; beside it the time to copy the file's bytes.

#include <benchmark/benchmark.h>
#include <unistd.h>

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <algorithm>
#include <charconv>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "meshes/generators/mesh_kind.h"
#include "meshes/read_mesh.h"
#include "meshes/write_mesh.h"

namespace plumb {
namespace {

const TriangleMesh& knot() {
  static const TriangleMesh mesh = [] {
    TriangleMesh made = mesh_kind("torus_knot").make({.triangles = 1'090'000, .progress = {}});
    made.normals.clear();
    return made;
  }();
  return mesh;
}

/// A folder that goes when the program ends.
const std::filesystem::path& folder() {
  struct Folder {
    Folder() { std::filesystem::create_directories(path); }
    ~Folder() { std::filesystem::remove_all(path); }
    std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("plumb-load-bench-" + std::to_string(getpid()));
  };
  static const Folder made;
  return made.path;
}

/// One number a line, as the course's files are, with the shortest digits that tell floats apart.
std::filesystem::path file_of_floats() {
  const TriangleMesh& mesh = knot();
  std::string text;
  const auto put = [&](auto number) {
    char line[32];
    text.append(line, std::to_chars(line, line + sizeof line, number).ptr).append("\n");
  };
  put(mesh.positions.size());
  put(mesh.triangles.size());
  text += "vertices\n";
  for (const Point3& p : mesh.positions)
    for (int axis = 0; axis < 3; ++axis) put(static_cast<float>(p[axis]));
  text += "triangles\n";
  for (const auto& triangle : mesh.triangles)
    for (const std::uint32_t corner : triangle) put(corner);
  const std::filesystem::path file = folder() / "floats.msh";
  std::ofstream(file, std::ios::binary).write(text.data(), static_cast<std::streamsize>(text.size()));
  return file;
}

std::filesystem::path written(const std::string& name) {
  const std::filesystem::path file = folder() / name;
  write_mesh(knot(), file);
  return file;
}

TriangleMesh read_by_iostream(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::size_t vertices = 0, triangles = 0;
  std::string word;
  TriangleMesh mesh;
  in >> vertices >> triangles >> word;
  mesh.positions.resize(vertices);
  mesh.triangles.resize(triangles);
  for (Point3& p : mesh.positions) in >> p.x >> p.y >> p.z;
  in >> word;
  for (auto& [a, b, c] : mesh.triangles) in >> a >> b >> c;
  if (!in) throw std::runtime_error("the plain reader does not read the file");
  return mesh;
}

std::size_t read_by_open_mesh(const std::filesystem::path& file) {
  OpenMesh::TriMesh_ArrayKernelT<> mesh;
  OpenMesh::IO::Options options = OpenMesh::IO::Options::Binary;
  if (!OpenMesh::IO::read_mesh(mesh, file.string(), options)) throw std::runtime_error("OpenMesh cannot read the file");
  return mesh.n_faces();
}

std::size_t copy_bytes(const std::filesystem::path& file) {
  std::vector<char> bytes(std::filesystem::file_size(file));
  std::ifstream(file, std::ios::binary).read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return static_cast<std::size_t>(bytes.back());
}

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

template <class Work>
double time_of(const Work& work) {
  const double start = cpu_seconds();
  benchmark::DoNotOptimize(work());
  return cpu_seconds() - start;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

void report(benchmark::State& state, const std::filesystem::path& file, const std::vector<double>& peer,
            const std::vector<double>& ours) {
  const double bytes = static_cast<double>(std::filesystem::file_size(file));
  state.counters["MB"] = 1e-6 * bytes;
  state.counters["peer ms"] = 1e3 * median(peer);
  state.counters["ours ms"] = 1e3 * median(ours);
  state.counters["ours MB/s"] = 1e-6 * bytes / median(ours);
  state.counters["peer/ours"] = median(peer) / median(ours);
  state.counters["triangles"] = static_cast<double>(knot().triangles.size());
}

void msh(benchmark::State& state, bool floats) {
  const std::filesystem::path file = floats ? file_of_floats() : written("doubles.msh");
  if (read_by_iostream(file) != read_mesh(file)) return state.SkipWithError("the two readers differ");
  std::vector<double> peer, ours;
  for (auto _ : state) {
    peer.push_back(time_of([&] { return read_by_iostream(file); }));
    ours.push_back(time_of([&] { return read_mesh(file); }));
    state.SetIterationTime(ours.back());
  }
  report(state, file, peer, ours);
}

void ply(benchmark::State& state) {
  const std::filesystem::path file = written("binary.ply");
  std::vector<double> peer, ours, copy;
  for (auto _ : state) {
    peer.push_back(time_of([&] { return read_by_open_mesh(file); }));
    ours.push_back(time_of([&] { return read_mesh(file); }));
    copy.push_back(time_of([&] { return copy_bytes(file); }));
    state.SetIterationTime(ours.back());
  }
  report(state, file, peer, ours);
  state.counters["copy ms"] = 1e3 * median(copy);
}

constexpr int kRounds = 15;
BENCHMARK_CAPTURE(msh, floats_beside_iostream, true)
    ->UseManualTime()
    ->Iterations(kRounds)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(msh, doubles_beside_iostream, false)
    ->UseManualTime()
    ->Iterations(kRounds)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(ply)
    ->Name("binary_ply_beside_open_mesh")
    ->UseManualTime()
    ->Iterations(kRounds)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace plumb
