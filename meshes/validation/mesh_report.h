#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "meshes/triangle_mesh.h"
#include "renderer/math/bounds3.h"

namespace plumb {

/// A count and the first of what was counted (at most kExamples different indices, in ascending order), to look at.
struct MeshFault {
  static constexpr std::size_t kExamples = 5;
  std::uint64_t count = 0;
  std::vector<std::uint32_t> examples;

  /// Counts one more; in any order.
  void add(std::uint32_t index);
  friend bool operator==(const MeshFault&, const MeshFault&) = default;
};

/// What is known of a mesh. All of it is exact: predicates are decided on the doubles as they are, over their whole
/// range, none by a tolerance, but for `normals_not_unit`, whose tolerance stands with it.
///
/// Vertices at one position (0 and -0 are the same) are one *place*. Shape is a matter of places, since rays know
/// nothing of indices: edges, fans, components and self-intersections are of places, and a seam, where vertices stand
/// twice for the sake of their normals or texture coordinates, is no boundary. A triangle with two corners at one place
/// is only an edge: it is counted in `repeated_corners` or `zero_area` and left out of all that follows them.
struct MeshReport {
  std::uint64_t vertices = 0;
  std::uint64_t triangles = 0;
  std::uint64_t edges = 0;
  /// Of vertices that triangles use. Empty (min > max) for a mesh without triangles.
  Bounds3 bounds;

  MeshFault unused_vertices;     ///< vertices of no triangle
  MeshFault duplicate_vertices;  ///< vertices with the position, normal and texture coordinate of another, lower one
  MeshFault seam_vertices;  ///< other vertices with the position of a lower one, which is no fault; of those that have
                            ///< the same position, normal and texture coordinate only the lowest is looked at
  MeshFault repeated_corners;     ///< triangles that name a vertex twice
  MeshFault zero_area;            ///< triangles of three different vertices on a line (exactly), or two at one place
  MeshFault duplicate_triangles;  ///< triangles of the same three places as an earlier one, in any order

  MeshFault boundary_edges;         ///< edges of one triangle; examples are triangles
  MeshFault edges_of_many;          ///< edges of three or more triangles; examples are the first triangle of each
  MeshFault misoriented_edges;      ///< edges that both their triangles run through in the same direction; likewise
  MeshFault vertices_of_many_fans;  ///< places whose triangles do not form one fan (bow ties), by their lowest vertex
  /// Triangles that intersect another one beyond a vertex or an edge they share (self_intersections.h). nullopt: not
  /// asked for.
  std::optional<MeshFault> self_intersections;

  bool closed = false;                    ///< no boundary edge, and there are triangles
  bool manifold = false;                  ///< every edge of one or two triangles, every place of one fan
  bool oriented = false;                  ///< no misoriented edge and none of many
  std::uint64_t components = 0;           ///< of triangles joined by edges
  std::int64_t euler_characteristic = 0;  ///< used places - edges + triangles
  /// Six times the enclosed volume is positive; only for a closed, oriented mesh. Sign by exact arithmetic.
  std::optional<bool> outward;

  bool has_normals = false;
  bool has_texcoords = false;
  MeshFault normals_not_unit;  ///< vertices whose normal's length is off 1 by more than kUnitTolerance, or NaN
  MeshFault normals_against;   ///< corners whose normal points behind its triangle; examples are triangles

  /// A unit normal in single precision, or with seven decimals, is off by 1e-7.
  static constexpr double kUnitTolerance = 1e-6;
};

struct MeshChecking {
  bool self_intersections = true;
  /// Told the share that is done, from 0 to 1; may be empty.
  std::function<void(double)> progress;
};

/// Requires indices in range and finite numbers, as read_mesh gives, and fewer than 2^32 / 3 triangles (throws
/// std::length_error). Any shape will do. Beside the mesh, it needs about 90 bytes a triangle at its peak.
MeshReport check_mesh(const TriangleMesh& mesh, const MeshChecking& options = {});

/// A finding in words, with its count and examples: `3 edges have one triangle only: ... (at triangles 4, 7)`.
struct MeshFinding {
  std::string_view id;  ///< the field of MeshReport
  std::string sentence;
};
/// What makes a mesh less than sound; nothing for one that is closed, manifold, oriented outward, without degenerate or
/// duplicate triangles, duplicate or unused vertices and self-intersections (if they were looked for), and whose
/// normals, if any, are unit and agree with the winding.
std::vector<MeshFinding> mesh_faults(const MeshReport& report);

/// What a mesh is fit for, of the suite's checks (docs/mesh-tools.md): a name, whether, and if not, why: a sentence for
/// each thing that is wrong, parted by "; ".
struct MeshFitness {
  std::string_view check;
  std::string_view needs;
  bool fit = false;
  std::string reason;
};
std::vector<MeshFitness> mesh_fitness(const MeshReport& report);

}  // namespace plumb
