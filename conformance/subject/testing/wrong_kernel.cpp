// A kernel that does wrong on demand. Built without sanitizers and without our libraries, as a stranger's would be.
//
// PLUMB_WRONG_KERNEL in the environment names what is wrong with its table. A ray's t_max names what goes wrong when
// it is asked (wrong_kernel.h); any other ray is answered rightly: all rays hit triangle 0 of surface 0 at t = 1.
#include "conformance/subject/testing/wrong_kernel.h"

#include <unistd.h>

#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "conformance/kernel/plumb_kernel.h"

namespace {

using plumb::Wrong;

std::vector<char*> taken;

void take_memory() {
  constexpr std::size_t kPiece = 16u << 20;
  for (;;) {
    taken.push_back(static_cast<char*>(std::malloc(kPiece)));
    std::memset(taken.back(), 1, kPiece);
  }
}

/// What happens to the whole process.
void misbehave(Wrong wrong) {
  switch (wrong) {
    case Wrong::crash:
      std::raise(SIGSEGV);
      break;
    case Wrong::abort:
      std::abort();
    case Wrong::throws:
      throw std::runtime_error("out of a C function");
    case Wrong::hang:
      for (;;) ::usleep(1000);
    case Wrong::exits_with_zero:
      ::exit(0);
    case Wrong::exits_with_three:
      ::_exit(3);
    case Wrong::closes_everything:
      for (int descriptor = 0; descriptor < 1000; ++descriptor) ::close(descriptor);
      break;
    case Wrong::writes_everywhere:
      for (int descriptor = 0; descriptor < 1000; ++descriptor)
        if (::write(descriptor, "this is no message at all, but long", 36) < 0) continue;
      break;
    case Wrong::takes_memory:
      take_memory();
      break;
    case Wrong::prints:
      for (int i = 0; i < 100000; ++i) std::printf("line %d of what nobody asked for, again and again\n", i);
      std::fprintf(stderr, "and without an end of line");
      break;
    default:
      break;
  }
}

void write_hit(plumb_hits* hits, std::size_t i, Wrong wrong) {
  if (wrong == Wrong::leaves_all) return;
  hits->surface[i] = wrong == Wrong::bad_surface ? 1000 : 0;
  hits->primitive[i] = wrong == Wrong::bad_primitive ? 12 : 0;
  if (wrong != Wrong::leaves_t)
    hits->t[i] = wrong == Wrong::nan ? std::nan("") : wrong == Wrong::infinite ? HUGE_VAL : 1;
  hits->u[i] = wrong == Wrong::nan_u ? std::nan("") : 0.25;
  if (wrong != Wrong::leaves_v) hits->v[i] = 0.25;
}

Wrong wrong_of(const plumb_rays* rays, std::size_t i) { return static_cast<Wrong>(static_cast<int>(rays->t_max[i])); }

void closest_hit(const plumb_scene*, const plumb_rays* rays, plumb_hits* hits) {
  for (std::size_t i = 0; i < rays->count; ++i) {
    misbehave(wrong_of(rays, i));
    write_hit(hits, i, wrong_of(rays, i));
    if (wrong_of(rays, i) == Wrong::overrun) hits->u[rays->count] = 1;
    if (wrong_of(rays, i) == Wrong::underrun) hits->surface[-1] = 1;
  }
}

void any_hit(const plumb_scene*, const plumb_rays* rays, std::uint8_t* hit) {
  for (std::size_t i = 0; i < rays->count; ++i) {
    const Wrong wrong = wrong_of(rays, i);
    if (wrong == Wrong::overrun) hit[rays->count] = 1;
    if (wrong != Wrong::leaves_all) hit[i] = wrong == Wrong::bad_flag ? 2 : 1;
  }
}

std::uint32_t counted = 0;

void all_hits(const plumb_scene*, const plumb_rays* rays, std::size_t capacity, plumb_hits* hits,
              std::uint32_t* count) {
  for (std::size_t i = 0; i < rays->count; ++i) {
    const Wrong wrong = wrong_of(rays, i);
    std::uint32_t there = static_cast<std::uint32_t>(rays->t_min[i]);  // so that a test can ask for any number
    if (wrong == Wrong::counts_too_many) there = 4'000'000'000u;
    if (wrong == Wrong::counts_differently) there = 20 + counted++;
    if (wrong != Wrong::leaves_all) count[i] = there;
    for (std::size_t k = 0; k < there && k < capacity; ++k) write_hit(hits, i * capacity + k, wrong);
    if (wrong == Wrong::overrun) write_hit(hits, rays->count * capacity, Wrong::nothing);
  }
}

void bounds(const plumb_scene*, double* six_a_surface) {
  for (int i = 0; i < 6; ++i) six_a_surface[i] = i < 3 ? 0 : 1;
}

/// A scene that needs no memory. A sphere's radius names what goes wrong when it is built.
plumb_scene* build(const plumb_surface* surfaces, std::size_t count, char* error, std::size_t error_size) {
  if (count > 0 && surfaces[0].kind == PLUMB_SPHERE) {
    const auto wrong = static_cast<Wrong>(static_cast<int>(surfaces[0].radius));
    misbehave(wrong);
    if (wrong == Wrong::refuses_with_a_reason) std::snprintf(error, error_size, "this sphere\nis too round");
    if (wrong == Wrong::refuses || wrong == Wrong::refuses_with_a_reason) return nullptr;
  }
  static char scene;
  return reinterpret_cast<plumb_scene*>(&scene);
}

void destroy(plumb_scene*) {}

}  // namespace

extern "C" const plumb_kernel* plumb_kernel_v1(void) {
  static plumb_kernel table{
      PLUMB_KERNEL_VERSION,
      sizeof(plumb_kernel),
      "wrong",
      "a kernel for tests",
      {PLUMB_DOUBLE, PLUMB_DOUBLE, PLUMB_CULL_NONE, PLUMB_EDGE_NONE, PLUMB_RANGE_CLOSED, PLUMB_INSIDE_HITS_EXIT,
       PLUMB_MESHES | PLUMB_SPHERES, PLUMB_ANY_HIT | PLUMB_ALL_HITS | PLUMB_BOUNDS, 0},
      build,
      destroy,
      closest_hit,
      any_hit,
      all_hits,
      bounds};
  const char* variable = std::getenv("PLUMB_WRONG_KERNEL");
  const std::string_view wrong = variable ? variable : "";
  if (wrong == "null") return nullptr;
  if (wrong == "version") table.version = 2;
  if (wrong == "size") table.size = 8;
  if (wrong == "function") table.closest_hit = nullptr;
  if (wrong == "capability") table.bounds = nullptr;
  if (wrong == "name") table.name = "two words";
  if (wrong == "no name") table.name = nullptr;
  if (wrong == "description") table.description = "two\nlines";
  if (wrong == "precision") table.contract.precision = 7;
  if (wrong == "edges") table.contract.edge_rule = 0;
  if (wrong == "shapes") table.contract.shapes = 1024;
  if (wrong == "largest") table.contract.largest = std::nan("");
  if (wrong == "crash") std::raise(SIGSEGV);
  if (wrong == "hang")
    for (;;) ::usleep(1000);
  if (wrong == "another name") table.name = "another";
  if (wrong == "float") table.contract.precision = PLUMB_FLOAT;
  if (wrong == "small") table.contract.largest = 100;
  return &table;
}
