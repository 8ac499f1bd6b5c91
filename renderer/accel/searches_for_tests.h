#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <sstream>
#include <vector>

#include "renderer/accel/triangle_search.h"
#include "renderer/scene_for_tests.h"

// Meshes and rays on which the searches are compared.

namespace plumb {

class SearchRandom {
 public:
  explicit SearchRandom(unsigned seed) : engine_(seed) {}
  /// In [-1, 1).
  double operator()() { return uniform_(engine_); }
  Vec3 vector(double scale = 1) {
    const double x = scale * (*this)(), y = scale * (*this)();
    return {x, y, scale * (*this)()};
  }
  Point3 point(double scale = 1) { return Point3{} + vector(scale); }
  std::size_t below(std::size_t count) { return std::uniform_int_distribution<std::size_t>(0, count - 1)(engine_); }
  double sign() { return below(2) ? 1.0 : -1.0; }

 private:
  std::mt19937_64 engine_;
  std::uniform_real_distribution<double> uniform_{-1, 1};
};

inline void add_triangle(TriangleMesh& mesh, const Point3& a, const Point3& b, const Point3& c) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), {a, b, c});
  mesh.triangles.push_back({first, first + 1, first + 2});
}

/// Triangles of about this size in the cube from -1 to 1, none of which share a vertex.
inline TriangleMesh triangle_soup(SearchRandom& u, int count, double size) {
  TriangleMesh soup;
  for (int i = 0; i < count; ++i) {
    const Point3 a = u.point();
    add_triangle(soup, a, a + u.vector(size), a + u.vector(size));
  }
  return soup;
}

/// The surface of the cube [low, low + n]^3 out of unit squares, two triangles each, which share vertices within a
/// side.
inline TriangleMesh cube_of_squares(int low, int n) {
  TriangleMesh mesh;
  for (int axis = 0; axis < 3; ++axis) {
    for (const int side : {0, n}) {
      const auto row = static_cast<std::uint32_t>(n + 1);
      for (int i = 0; i <= n; ++i) {
        for (int j = 0; j <= n; ++j) {
          Point3 p;
          p[axis] = low + side;
          p[(axis + 1) % 3] = low + i;
          p[(axis + 2) % 3] = low + j;
          mesh.positions.push_back(p);
          if (i == n || j == n) continue;
          const std::uint32_t at = static_cast<std::uint32_t>(mesh.positions.size()) - 1;
          mesh.triangles.push_back({at, at + row, at + row + 1});
          mesh.triangles.push_back({at, at + row + 1, at + 1});
        }
      }
    }
  }
  return mesh;
}

/// p -> factor p + offset, rounded to doubles.
inline TriangleMesh moved(TriangleMesh mesh, double factor, const Vec3& offset) {
  for (Point3& p : mesh.positions) p = Point3{} + (factor * (p - Point3{}) + offset);
  return mesh;
}

/// A rotation, axis by axis, of numbers that are rounded: what is asked for is a condition, not orthogonality.
inline AffineMatrix turned(SearchRandom& u, double condition, double offset) {
  AffineMatrix matrix{};
  const auto factor = [&](int i) { return u.sign() * std::pow(condition, (i - 1) / 2.0); };
  const Vec3 scale{factor(0), factor(1), factor(2)};
  const Vec3 x = normalized(u.vector()), y = normalized(cross(x, u.vector())), z = cross(x, y);
  const Vec3 a = normalized(u.vector()), b = normalized(cross(a, u.vector())), c = cross(a, b);
  for (std::size_t i = 0; i < 3; ++i) {
    const int row = static_cast<int>(i);
    for (std::size_t k = 0; k < 3; ++k) {
      const int column = static_cast<int>(k);
      matrix[i][k] = x[row] * scale.x * a[column] + y[row] * scale.y * b[column] + z[row] * scale.z * c[column];
    }
    matrix[i][3] = offset * u();
  }
  return matrix;
}

/// From within `reach` of the centre, in turn at a vertex, the middle of an edge, a point of a triangle, and anywhere
/// near.
inline std::vector<Ray> aimed_rays(const TriangleMesh& mesh, SearchRandom& u, int count, const Point3& center,
                                   double reach) {
  std::vector<Ray> rays;
  for (int i = 0; i < count; ++i) {
    const Point3 from = center + u.vector(reach);
    const auto& triangle = mesh.triangles[u.below(mesh.triangles.size())];
    const Point3 &a = mesh.positions[triangle[0]], &b = mesh.positions[triangle[1]], &c = mesh.positions[triangle[2]];
    const double v = 0.25 * (1 + u()), w = 0.25 * (1 + u());
    const Point3 targets[] = {a, a + 0.5 * (b - a), a + (v * (b - a) + w * (c - a)), center + u.vector(reach)};
    rays.push_back({from, targets[i % 4] - from});
  }
  return rays;
}

inline bool same_hit(const std::optional<SurfaceHit>& a, const std::optional<SurfaceHit>& b) {
  if (!a || !b) return !a && !b;
  return a->part == b->part && same_bits(a->t, b->t) && same_bits(a->u, b->u) && same_bits(a->v, b->v);
}

inline std::string shown(const Ray& ray, const std::optional<SurfaceHit>& hit) {
  std::ostringstream text;
  text << std::hexfloat << "origin " << ray.origin.x << " " << ray.origin.y << " " << ray.origin.z << " direction "
       << ray.direction.x << " " << ray.direction.y << " " << ray.direction.z << " range " << ray.t_min << " "
       << ray.t_max;
  if (hit) text << ": triangle " << hit->part << " at " << hit->t << " weights " << hit->u << " " << hit->v;
  if (!hit) text << ": a miss";
  return text.str();
}

/// What comparing counted.
struct SearchTally {
  int rays = 0, hits = 0, different = 0;
  SearchTally& operator+=(const SearchTally& other) {
    rays += other.rays;
    hits += other.hits;
    different += other.different;
    return *this;
  }
};

/// Holds the 8-wide hierarchy of a mesh to the search through all triangles, and `any` of both to that. Fails with the
/// first difference.
class SearchComparison {
 public:
  explicit SearchComparison(TriangleMesh mesh, int threads = 1)
      : mesh_(std::make_shared<const TriangleMesh>(std::move(mesh))),
        linear_(mesh_, Accel::linear),
        bvh8_(mesh_, Accel::bvh8, threads) {}

  /// The hit, where they agree.
  std::optional<SurfaceHit> operator()(const PlacedRay& ray) {
    const auto expected = linear_.closest(ray, counters_), found = bvh8_.closest(ray, counters_);
    const bool any = bvh8_.any(ray, counters_), right = linear_.any(ray, counters_) == expected.has_value();
    ++tally_.rays;
    tally_.hits += expected.has_value();
    if (right && any == expected.has_value() && same_hit(expected, found)) return expected;
    if (++tally_.different == 1) {
      ADD_FAILURE() << "the first difference, of " << mesh_->triangles.size()
                    << " triangles\n  all:  " << shown(*ray.world, expected) << "\n  bvh8: " << shown(*ray.world, found)
                    << "\n  any: " << any << (right ? "" : ", and not right in all");
    }
    return std::nullopt;
  }

  SearchTally operator()(const std::vector<Ray>& rays) {
    const SearchTally before = tally_;
    for (const Ray& ray : rays) (*this)(PlacedRay(ray));
    return {tally_.rays - before.rays, tally_.hits - before.hits, tally_.different - before.different};
  }

  const SearchTally& tally() const { return tally_; }
  const TriangleSearch& linear() const { return linear_; }
  const TriangleSearch& bvh8() const { return bvh8_; }
  const TriangleMesh& mesh() const { return *mesh_; }

 private:
  std::shared_ptr<const TriangleMesh> mesh_;
  TriangleSearch linear_, bvh8_;
  TraceCounters counters_;
  SearchTally tally_;
};

}  // namespace plumb
