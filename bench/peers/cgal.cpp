// CGAL's AABB_tree with exact constructions: the kernel that is shipped with the suite, called in this process.
#include <dlfcn.h>

#include <stdexcept>

#include "bench/peers/roster.h"
#include "conformance/kernel/plumb_kernel.h"

namespace plumb::bench {
namespace {

const plumb_kernel* loaded() {
  static const plumb_kernel* const kernel = []() -> const plumb_kernel* {
    void* library = dlopen(PLUMB_CGAL_KERNEL, RTLD_NOW | RTLD_LOCAL);  // for the life of the process
    if (!library) return nullptr;
    const auto entry = reinterpret_cast<plumb_kernel_entry>(dlsym(library, PLUMB_KERNEL_ENTRY));
    return entry ? entry() : nullptr;
  }();
  return kernel;
}

class CgalPeer : public Peer {
 public:
  CgalPeer(const TriangleMesh& mesh, BuildCost& cost) {
    std::vector<double> positions;
    for (const Point3& p : mesh.positions) positions.insert(positions.end(), {p.x, p.y, p.z});
    plumb_surface surface{};
    surface.kind = PLUMB_MESH;
    surface.mesh = {positions.data(), mesh.positions.size(), mesh.triangles[0].data(), mesh.triangles.size()};
    for (const std::size_t one : {0, 5, 10}) surface.world_from_object[one] = 1;
    char error[256] = "";
    timed_build(cost, [&] { scene_ = loaded()->build(&surface, 1, error, sizeof error); });
    if (!scene_) throw std::runtime_error(std::string("CGAL: ") + error);
  }
  ~CgalPeer() override { loaded()->destroy(scene_); }
  CgalPeer(const CgalPeer&) = delete;
  CgalPeer& operator=(const CgalPeer&) = delete;

  Tally closest(const RaySet& set, const Slice& slice) const override {
    Tally tally;
    for (std::size_t i = slice.begin; i < slice.end; i += slice.step) {
      const Found found = closest_of(set, i);
      tally.hits += found.hit();
      tally.triangles += found.triangle;
    }
    return tally;
  }
  Tally any(const RaySet& set, const Slice& slice) const override {
    Tally tally;
    for (std::size_t i = slice.begin; i < slice.end; i += slice.step) tally.hits += any_of(set, i);
    return tally;
  }

  Found closest_of(const RaySet& set, std::size_t ray) const override {
    const Ray& asked = set.rays[ray];
    const plumb_rays rays = one(asked);
    std::uint32_t surface = PLUMB_MISS, triangle = 0;
    double t = 0, u = 0, v = 0;
    plumb_hits hits{&surface, &triangle, &t, &u, &v};
    loaded()->closest_hit(scene_, &rays, &hits);
    return surface == PLUMB_MISS ? Found{} : Found{t, triangle};
  }
  bool any_of(const RaySet& set, std::size_t ray) const override {
    const plumb_rays rays = one(set.rays[ray]);
    std::uint8_t hit = 0;
    loaded()->any_hit(scene_, &rays, &hit);
    return hit != 0;
  }

  /// Not known: its numbers are scattered over the heap.
  std::size_t bytes() const override { return 0; }

 private:
  static plumb_rays one(const Ray& ray) {
    const Point3& o = ray.origin;
    const Vec3& d = ray.direction;
    return {1, &o.x, &o.y, &o.z, &d.x, &d.y, &d.z, &ray.t_min, &ray.t_max};
  }

  plumb_scene* scene_ = nullptr;
};

std::unique_ptr<Peer> build(const std::shared_ptr<const TriangleMesh>& mesh, int, BuildCost& cost) {
  return std::make_unique<CgalPeer>(*mesh, cost);
}

}  // namespace

std::vector<PeerKind> cgal_peers() {
  if (!loaded()) return {};
  return {{.name = "cgal",
           .description = loaded()->description,
           .build = build,
           .most_threads = 1,
           .most_rays = 1024,
           .most_triangles = 100'000}};
}

}  // namespace plumb::bench
