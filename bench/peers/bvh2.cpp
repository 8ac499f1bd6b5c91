// The readable hierarchy, with the exact decisions that renders use and with plain Moller-Trumbore in doubles.
#include <optional>

#include "bench/peers/roster.h"
#include "renderer/accel/hierarchy.h"
#include "renderer/surfaces/triangle.h"

namespace plumb::bench {
namespace {

struct ExactTest {
  explicit ExactTest(const Ray& ray) : sheared(ray) {}
  std::optional<double> operator()(const Point3& a, const Point3& b, const Point3& c) const {
    if (const auto hit = intersect_triangle(sheared, a, b, c)) return hit->t;
    return std::nullopt;
  }
  ShearedRay sheared;
};

/// The textbook form [Moller 1997], culling nothing; wrong where rounding makes it so.
struct PlainTest {
  explicit PlainTest(const Ray& asked) : ray(asked) {}
  std::optional<double> operator()(const Point3& a, const Point3& b, const Point3& c) const {
    const Vec3 e1 = b - a, e2 = c - a, s = ray.origin - a;
    const Vec3 p = cross(ray.direction, e2);
    const double det = dot(e1, p);
    if (det == 0) return std::nullopt;
    const double inverse = 1 / det, u = inverse * dot(s, p);
    if (!(u >= 0 && u <= 1)) return std::nullopt;
    const Vec3 q = cross(s, e1);
    const double v = inverse * dot(ray.direction, q);
    if (!(v >= 0 && u + v <= 1)) return std::nullopt;
    const double t = inverse * dot(e2, q);
    if (!ray.contains(t)) return std::nullopt;
    return t;
  }
  const Ray& ray;
};

template <class Test>
class Bvh2Peer : public PeerLoops<Bvh2Peer<Test>> {
 public:
  Bvh2Peer(std::shared_ptr<const TriangleMesh> mesh, BuildCost& cost) : mesh_(std::move(mesh)) {
    timed_build(cost, [&] { hierarchy_.emplace(triangle_bounds(*mesh_)); });
  }

  Found closest_of(const RaySet& set, std::size_t ray) const override {
    Ray rest = set.rays[ray];
    const Test test(rest);
    Found found;
    TraceCounters counters;
    hierarchy_->walk(rest, counters, [&](std::uint32_t triangle) {
      const auto t = tested(test, triangle);
      if (t && (!found.hit() || *t < found.t || triangle < found.triangle)) {
        found = {*t, triangle};
        rest.t_max = *t;
      }
      return false;
    });
    return found;
  }

  bool any_of(const RaySet& set, std::size_t ray) const override {
    const Test test(set.rays[ray]);
    TraceCounters counters;
    return hierarchy_->walk(set.rays[ray], counters,
                            [&](std::uint32_t triangle) { return tested(test, triangle).has_value(); });
  }

  /// A node holds a box of doubles and three indices, padded; a triangle one index into the nodes' order.
  std::size_t bytes() const override {
    const std::size_t nodes = hierarchy_->node_count() * (sizeof(Bounds3) + 16);
    return nodes + mesh_->triangles.size() * (sizeof(std::uint32_t) + sizeof(mesh_->triangles[0])) +
           mesh_->positions.size() * sizeof(Point3);
  }

 private:
  std::optional<double> tested(const Test& test, std::uint32_t triangle) const {
    const auto [a, b, c] = mesh_->triangles[triangle];
    return test(mesh_->positions[a], mesh_->positions[b], mesh_->positions[c]);
  }

  std::shared_ptr<const TriangleMesh> mesh_;
  std::optional<Hierarchy> hierarchy_;
};

template <class Test>
std::unique_ptr<Peer> build(const std::shared_ptr<const TriangleMesh>& mesh, int, BuildCost& cost) {
  return std::make_unique<Bvh2Peer<Test>>(mesh, cost);
}

}  // namespace

std::vector<PeerKind> bvh2_peers() {
  return {{.name = std::string(kJudge),
           .description = "ours, the readable binary hierarchy in doubles, exact decisions",
           .build = build<ExactTest>,
           .most_threads = 1},
          {.name = "bvh2-plain",
           .description = "the same hierarchy, plain Moller-Trumbore in doubles",
           .build = build<PlainTest>,
           .most_threads = 1}};
}

}  // namespace plumb::bench
