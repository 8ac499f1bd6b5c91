#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "meshes/triangle_mesh.h"
#include "renderer/math/bounds3.h"

namespace plumb {

/// A count and the first of what was counted (at most kExamples indices, in ascending order), to look at.
struct MeshFault {
  static constexpr std::size_t kExamples = 5;
  std::uint64_t count = 0;
  std::vector<std::uint32_t> examples;
};

/// What is known of a mesh. All of it is exact: predicates are decided on the doubles as they are, none by a tolerance,
/// but for `normals_not_unit`, whose tolerance stands with it.
struct MeshReport {
  std::uint64_t vertices = 0;
  std::uint64_t triangles = 0;
  std::uint64_t edges = 0;
  /// Of vertices that triangles use. Empty (min > max) for a mesh without triangles.
  Bounds3 bounds;

  MeshFault unused_vertices;      ///< vertices of no triangle
  MeshFault duplicate_vertices;   ///< vertices with the position of an earlier one
  MeshFault repeated_corners;     ///< triangles that name a vertex twice
  MeshFault zero_area;            ///< triangles of three different vertices on a line (exactly), or two at one place
  MeshFault duplicate_triangles;  ///< triangles of the same three vertices as an earlier one, in any order

  MeshFault boundary_edges;         ///< edges of one triangle; examples are triangles
  MeshFault edges_of_many;          ///< edges of three or more triangles
  MeshFault misoriented_edges;      ///< edges that two triangles run through in the same direction
  MeshFault vertices_of_many_fans;  ///< vertices whose triangles do not form one fan (bow ties)
  /// Triangles that intersect another one beyond a vertex or an edge they share. nullopt: not asked for.
  std::optional<MeshFault> self_intersections;

  bool closed = false;                    ///< no boundary edge, and there are triangles
  bool manifold = false;                  ///< every edge of one or two triangles, every vertex of one fan
  bool oriented = false;                  ///< no misoriented edge and none of many
  std::uint64_t components = 0;           ///< of triangles joined by edges
  std::int64_t euler_characteristic = 0;  ///< used vertices - edges + triangles
  /// Six times the enclosed volume is positive; only for a closed, oriented mesh. Sign by exact arithmetic.
  std::optional<bool> outward;

  bool has_normals = false;
  bool has_texcoords = false;
  MeshFault
      normals_not_unit;  ///< whose length is off 1 by more than 1e-6 (a unit normal in single precision is off by 1e-7)
  MeshFault normals_against;  ///< corners whose normal points behind its triangle; examples are triangles
};

struct MeshChecking {
  bool self_intersections = true;
  /// Told the share that is done, from 0 to 1; may be empty.
  std::function<void(double)> progress;
};

/// Requires indices in range and finite numbers, as read_mesh gives.
MeshReport check_mesh(const TriangleMesh& mesh, const MeshChecking& options = {});

/// What a mesh is fit for, of the suite's checks: a name (`escape` checks need closed, ...), whether, and if not, why.
struct MeshFitness {
  std::string check;
  bool fit = false;
  std::string reason;
};
std::vector<MeshFitness> mesh_fitness(const MeshReport& report);

}  // namespace plumb
