#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string_view>

#include "meshes/triangle_mesh.h"

namespace plumb {

/// What is asked of a generator.
struct MeshRequest {
  /// How many triangles are wanted; the generator makes the nearest number not below it that its construction has
  /// (an icosphere has 20 * 4^n). From 1; at most 100 million.
  std::uint64_t triangles = 1000;
  /// Of the families that are random.
  std::uint64_t seed = 1;
  /// Told the share that is done, from 0 to 1, now and then; may be empty.
  std::function<void(double)> progress;
};

/// A family of generated meshes. The same request gives the same bits on every machine: + - * / and sqrt alone, or
/// correctly rounded functions (correctly_rounded.h).
struct MeshKind {
  std::string_view id;           ///< `torus_knot`, as `plumb mesh generate` takes it
  std::string_view description;  ///< a sentence
  bool closed;                   ///< whether every mesh of it is closed, manifold and oriented outward
  bool random;                   ///< whether the seed matters
  /// Throws InputError where the number of triangles is beyond what the family can be.
  TriangleMesh (*make)(const MeshRequest& request);
};

/// All, by name.
std::span<const MeshKind* const> mesh_kinds();
/// Throws InputError naming the nearest known id.
const MeshKind& mesh_kind(std::string_view id);

}  // namespace plumb
