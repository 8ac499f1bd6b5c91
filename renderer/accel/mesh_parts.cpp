#include "renderer/accel/mesh_parts.h"

#include <atomic>

#include "renderer/accel/binary_tree.h"

namespace plumb {
namespace {

constexpr std::size_t kBlock = 8192;

// Relaxed: each word is all that is told by it, and the pool orders one phase before the next.
using Word = std::atomic_ref<std::uint32_t>;
std::uint32_t read(std::uint32_t& word) { return Word(word).load(std::memory_order_relaxed); }
void write(std::uint32_t& word, std::uint32_t value) { Word(word).store(value, std::memory_order_relaxed); }

}  // namespace

MeshParts::MeshParts(const TriangleMesh& mesh, WorkerPool& pool)
    : parent_(mesh.positions.size()), vertices_(mesh.positions.size()) {
  const std::size_t vertices = mesh.positions.size();
  pool.blocks(vertices, kBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) parent_[v] = static_cast<std::uint32_t>(v);
  });
  pool.blocks(mesh.triangles.size(), kBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto& [a, b, c] = mesh.triangles[i];
      const std::uint32_t parent = read(parent_[a]);
      if (parent == read(parent_[b]) && parent == read(parent_[c])) continue;
      join(a, b);
      join(a, c);
    }
  });
  pool.blocks(vertices, kBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) count(static_cast<std::uint32_t>(v));
  });
  std::atomic<bool> has_small = false;
  pool.blocks(vertices, kBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v)
      if (parent_[v] == v && is_small(static_cast<std::uint32_t>(v))) has_small = true;
  });
  has_small_ = has_small;
}

std::uint32_t MeshParts::of(std::uint32_t vertex) const {
  while (parent_[vertex] != vertex) vertex = parent_[vertex];
  return vertex;
}

bool MeshParts::is_small(std::uint32_t part) const { return vertices_[part] >= 3 && vertices_[part] <= kLeafVertices; }

/// Halves the path on its way. What another thread does meanwhile can only lead further towards the same root.
std::uint32_t MeshParts::root_of(std::uint32_t vertex) {
  for (;;) {
    const std::uint32_t parent = read(parent_[vertex]);
    if (parent == vertex) return vertex;
    const std::uint32_t above = read(parent_[parent]);
    if (above == parent) return parent;
    write(parent_[vertex], above);
    vertex = above;
  }
}

/// The higher root under the lower one [Anderson 1991]; again where another thread has just done so with one of them.
void MeshParts::join(std::uint32_t a, std::uint32_t b) {
  for (;;) {
    a = root_of(a);
    b = root_of(b);
    if (a == b) return;
    if (a < b) std::swap(a, b);
    std::uint32_t expected = a;
    if (Word(parent_[a]).compare_exchange_strong(expected, b, std::memory_order_relaxed)) return;
  }
}

/// Only as far as a leaf's vertices and a few more, so that threads seldom wait for the count of a large part.
void MeshParts::count(std::uint32_t vertex) {
  const std::uint32_t root = root_of(vertex);
  write(parent_[vertex], root);
  if (read(vertices_[root]) <= kLeafVertices) Word(vertices_[root]).fetch_add(1, std::memory_order_relaxed);
}

}  // namespace plumb
