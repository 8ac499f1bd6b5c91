#include <span>

#include "tools/kernels/kernel_table.h"

namespace plumb::kernels {
namespace {

/// Answers at once that nothing is hit. What a question to it takes is what the door itself takes.
struct Nothing {
  explicit Nothing(std::span<const plumb_surface>) {}
  static Hit closest(const Ray&) { return {}; }
  static bool any(const Ray&) { return false; }
  static void all(const Ray&, std::vector<Hit>&) {}
};

constexpr plumb_contract kContract{.precision = PLUMB_DOUBLE,
                                   .t_precision = PLUMB_DOUBLE,
                                   .culling = PLUMB_CULL_NONE,
                                   .edge_rule = PLUMB_EDGE_NONE,
                                   .range = PLUMB_RANGE_CLOSED,
                                   .inside = PLUMB_INSIDE_MISSES,
                                   .shapes = PLUMB_MESHES | PLUMB_SPHERES | PLUMB_BOXES | PLUMB_CYLINDERS | PLUMB_CONES,
                                   .capabilities = PLUMB_TRANSFORMS | PLUMB_THREAD_SAFE,
                                   .largest = 0};

}  // namespace
}  // namespace plumb::kernels

PLUMB_KERNEL_EXPORT const plumb_kernel* plumb_kernel_v1() {
  using namespace plumb::kernels;
  static const plumb_kernel table = KernelTable<Nothing>::make("empty", "answers every ray with a miss", kContract);
  return &table;
}
