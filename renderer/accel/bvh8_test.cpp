#include "renderer/accel/bvh8.h"

#include <gtest/gtest.h>

#include "meshes/generators/icosphere.h"
#include "renderer/accel/searches_for_tests.h"

// The 8-wide hierarchy against the search through all triangles: the same triangle, and the same bits of t, u and v.

namespace plumb {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(Bvh8, FindsTheSameHitsInRandomSoups) {
  SearchRandom u(1);
  SearchTally sum;
  int soups = 0;
  for (const int count : {1, 2, 3, 7, 8, 9, 17, 100, 1000}) {
    for (const double size : {0.01, 0.2, 2.0}) {
      for (const bool floats : {true, false}) {
        TriangleMesh soup = triangle_soup(u, count, size);
        if (floats) soup = in_single_precision(soup);
        const std::vector<Ray> rays = aimed_rays(soup, u, 1000, {}, 3);
        sum += SearchComparison(std::move(soup))(rays);
        ++soups;
      }
    }
  }
  EXPECT_EQ(soups, 54);
  EXPECT_EQ(sum.rays, 54000);
  EXPECT_GT(sum.hits, 20000);
  EXPECT_GT(sum.rays - sum.hits, 5000);
}

TEST(Bvh8, FindsTheSameHitsOnCubesOfSquares) {
  SearchRandom u(2);
  SearchTally sum;
  int cubes = 0;
  for (const int low : {1, 0, -4}) {
    for (const double factor : {1.0, 0.1, 1.0 / 3}) {
      const TriangleMesh cube = moved(cube_of_squares(low, 8), factor, {});
      const double middle = factor * (low + 4);
      sum += SearchComparison(cube)(aimed_rays(cube, u, 8000, {middle, middle, middle}, 3 * factor));
      ++cubes;
    }
  }
  EXPECT_EQ(cubes, 9);
  EXPECT_EQ(sum.rays, 72000);
  EXPECT_GT(sum.hits, 71500) << "from inside";
}

TEST(Bvh8, FindsTheSameHitsAlongTheAxes) {
  SearchRandom u(3);
  SearchTally sum;
  for (const int low : {-4, 0}) {
    const TriangleMesh cube = cube_of_squares(low, 8);
    SearchComparison compare(cube);
    for (int i = 0; i < 6000; ++i) {
      // Off the lattice, on its planes, on its lines.
      Ray ray{{low + 4 + 5 * u(), low + 4 + 5 * u(), low + 4 + 5 * u()}, {}};
      for (int axis = 0; axis < 3; ++axis) {
        if (u.below(3) > 0) ray.origin[axis] = std::round(ray.origin[axis]);
        ray.direction[axis] = u.sign() * 0.0;
      }
      ray.direction[i % 3] = u.sign() * (i % 5 ? 1 : 0.1);
      if (i % 4 == 0) ray.direction[(i + 1) % 3] = u.sign() * (i % 8 ? 1 : 1e-30);
      compare(PlacedRay(ray));
    }
    sum += compare.tally();
  }
  EXPECT_EQ(sum.rays, 12000);
  EXPECT_GT(sum.hits, 5000);
  EXPECT_GT(sum.rays - sum.hits, 1000);
}

TEST(Bvh8, FindsTheSameHitsAmongDegenerateTriangles) {
  SearchRandom u(4);
  TriangleMesh one_center, points, needles, spread, plane, twice = icosphere(2);
  for (int i = 0; i < 300; ++i) {
    const Vec3 a = u.vector(), b = u.vector();
    add_triangle(one_center, Point3{} + a, Point3{} + b, Point3{} + -(a + b));
    const Point3 p = u.point();
    add_triangle(points, p, p, p);
    add_triangle(needles, p, p + a, p + (0.5 * a + u.vector(1e-12)));
    const double size = std::pow(10.0, 10 * u());
    add_triangle(spread, Point3{} + size * a, Point3{} + size * b, Point3{} + u.vector(size));
    add_triangle(plane, {p.x, p.y, 0}, {a.x, a.y, 0}, {b.x, b.y, 0});
  }
  for (TriangleMesh* mesh : {&points, &needles}) add_triangle(*mesh, {-3, -3, 0.5}, {3, -3, 0.5}, {0, 3, 0.5});
  const auto faces = static_cast<std::ptrdiff_t>(twice.triangles.size());
  twice.triangles.insert(twice.triangles.end(), twice.triangles.begin(), twice.triangles.begin() + faces);
  int meshes = 0;
  for (const TriangleMesh* mesh : {&one_center, &points, &needles, &spread, &plane, &twice}) {
    const SearchTally tally = SearchComparison(*mesh)(aimed_rays(*mesh, u, 3000, {}, 3));
    EXPECT_EQ(tally.rays, 3000) << meshes;
    EXPECT_GT(tally.hits, 300) << meshes;
    ++meshes;
  }
  EXPECT_EQ(meshes, 6);
}

TEST(Bvh8, FindsTheSameHitsFarFromTheOrigin) {
  SearchRandom u(5);
  SearchTally sum;
  int meshes = 0;
  for (const double far : {1e3, 1e4, 1e5, 1e6, 1e7}) {
    for (const bool floats : {true, false}) {
      for (const TriangleMesh& near : {icosphere(2), triangle_soup(u, 300, 0.5)}) {
        const Vec3 offset{far, -0.7 * far, 0.3 * far};
        TriangleMesh mesh = moved(near, 1, offset);
        if (floats) mesh = in_single_precision(mesh);
        SearchComparison compare(mesh);
        sum += compare(aimed_rays(mesh, u, 1500, Point3{} + offset, 2));
        sum += compare(aimed_rays(mesh, u, 500, Point3{}, 2));
        ++meshes;
      }
    }
  }
  EXPECT_EQ(meshes, 20);
  EXPECT_EQ(sum.rays, 40000);
  EXPECT_GT(sum.hits, 20000);
}

TEST(Bvh8, FindsTheSameHitsAtAnyScale) {
  SearchRandom u(6);
  SearchTally sum;
  int scales = 0;
  for (const double scale :
       {1e-300, 1e-150, 1e-60, 1e-40, 1e-24, 1e-12, 1e-6, 1e6, 1e12, 1e17, 1e30, 1e45, 1e150, 1e300}) {
    for (const TriangleMesh& near : {icosphere(2), triangle_soup(u, 300, 0.5)}) {
      const TriangleMesh mesh = moved(near, scale, {});
      SearchComparison compare(mesh);
      sum += compare(aimed_rays(mesh, u, 1500, {}, 2 * scale));
      std::vector<Ray> rays = aimed_rays(mesh, u, 500, {}, 2 * scale);
      for (Ray& ray : rays) ray.direction = (1 / scale) * ray.direction;
      sum += compare(rays);
    }
    ++scales;
  }
  EXPECT_EQ(scales, 14);
  EXPECT_EQ(sum.rays, 14 * 4000);
  EXPECT_GT(sum.hits, 14 * 2000);
}

TEST(Bvh8, FindsTheSameHitsByRaysOfAnyLengthAndFromAnywhere) {
  SearchRandom u(7);
  SearchTally sum;
  SearchComparison sphere(icosphere(2)), soup(triangle_soup(u, 300, 0.5));
  int sources = 0;
  for (SearchComparison* compare : {&sphere, &soup}) {
    for (const double length : {0x1p-900, 0x1p-140, 0x1p-60, 0x1p-31, 0x1p-29, 0x1p29, 0x1p31, 0x1p100, 0x1p900}) {
      std::vector<Ray> rays = aimed_rays(compare->mesh(), u, 1000, {}, 2);
      for (Ray& ray : rays) ray.direction = length * ray.direction;
      sum += (*compare)(rays);
      ++sources;
    }
    for (const double far : {4.0, 1e2, 1e3, 1e6, 1e9, 1e14, 1e30}) {
      std::vector<Ray> rays = aimed_rays(compare->mesh(), u, 1000, {}, 2);
      for (Ray& ray : rays) ray.origin = ray.origin + -far * ray.direction;
      sum += (*compare)(rays);
      for (Ray& ray : rays) ray.direction = (1 / far) * ray.direction;
      sum += (*compare)(rays);
      ++sources;
    }
  }
  EXPECT_EQ(sources, 32);
  EXPECT_EQ(sum.rays, 46000);
  EXPECT_GT(sum.hits, 20000);
}

TEST(Bvh8, FindsTheSameHitsBeyondWhereFloatsEnd) {
  // Along an axis a ray from anywhere meets what it is aimed at; by other numbers of its own size it meets it by
  // chance.
  SearchRandom u(12);
  SearchTally sum;
  int sizes = 0;
  for (const double size : {1e-320, 1e-300, 1e-24, 1.0, 1e17, 1e300}) {
    SearchComparison compare(moved(icosphere(1), size, {}));
    for (const double far : {1e-310, 1e-200, 1e-30, 1e-10, 1.0, 1e10, 1e20, 1e40, 1e60, 1e100, 1e200, 1e307}) {
      for (const double length : {1e-320, 1e-300, 1e-100, 1.0, 1e100, 1e300}) {
        for (int i = 0; i < 6; ++i) {
          Ray ray{Point3{} + u.vector(0.5 * size), {}};
          ray.origin[i % 3] = u.sign() * far;
          ray.direction[i % 3] = std::copysign(length, -ray.origin[i % 3]);
          compare(PlacedRay(ray));
          ray.t_min = -kInfinity;
          compare(PlacedRay(ray));
          ray.t_max = 0;
          compare(PlacedRay(ray));
        }
      }
    }
    sum += compare.tally();
    ++sizes;
  }
  EXPECT_EQ(sizes, 6);
  EXPECT_EQ(sum.rays, 6 * 12 * 6 * 18);
  EXPECT_GT(sum.hits, 3500);
  EXPECT_EQ(sum.different, 0);
}

TEST(Bvh8, FindsTheSameHitsInAnyRange) {
  SearchRandom u(8);
  int hits = 0, cut = 0;
  SearchComparison sphere(icosphere(2)), soup(in_single_precision(triangle_soup(u, 300, 0.5)));
  for (SearchComparison* compare : {&sphere, &soup}) {
    for (Ray ray : aimed_rays(compare->mesh(), u, 2000, {}, 2)) {
      ray.t_min = -kInfinity;
      const auto first = (*compare)(PlacedRay(ray));
      if (!first) continue;
      ++hits;
      const double t = first->t, below = std::nextafter(t, -kInfinity), above = std::nextafter(t, kInfinity);
      const auto in = [&](double t_min, double t_max) {
        Ray part = ray;
        part.t_min = t_min;
        part.t_max = t_max;
        cut += !(*compare)(PlacedRay(part));
      };
      for (const double end : {below, t, above}) {
        in(-kInfinity, end);
        in(end, kInfinity);
        in(end, end);
        in(-3, end);
      }
      for (const double end : {-1.0, 0.0, 0.25, 1.0}) {
        in(end, end + 0.5);
        in(end, 1e300);
      }
      in(1, 0.5);
      in(kInfinity, -kInfinity);
      in(above, below);
    }
  }
  EXPECT_GT(hits, 3000);
  EXPECT_GT(cut, 4 * hits);
  EXPECT_EQ(sphere.tally().rays + soup.tally().rays, 4000 + 23 * hits);
  EXPECT_EQ(sphere.tally().different + soup.tally().different, 0);
}

TEST(Bvh8, FindsTheSameHitsFromOnTheMesh) {
  SearchRandom u(9);
  SearchTally sum;
  int meshes = 0;
  for (const TriangleMesh& mesh :
       {icosphere(2), in_single_precision(icosphere(2)), cube_of_squares(-4, 8), triangle_soup(u, 300, 0.5)}) {
    std::vector<Ray> rays;
    for (const Ray& aimed : aimed_rays(mesh, u, 6000, {}, 2)) {
      Ray ray{aimed.at(1), u.vector()};
      if (rays.size() % 3 == 0) ray.direction = mesh.positions[u.below(mesh.positions.size())] - ray.origin;
      if (rays.size() % 5 == 0) ray.t_min = 1e-9;
      if (rays.size() % 7 == 0) ray.t_max = 0;
      if (ray.direction != Vec3{}) rays.push_back(ray);
    }
    sum += SearchComparison(mesh)(rays);
    ++meshes;
  }
  EXPECT_EQ(meshes, 4);
  EXPECT_GT(sum.rays, 23900);
  EXPECT_GT(sum.hits, 15000);
}

TEST(Bvh8, RaysWithoutFiniteNumbersHitNothing) {
  SearchComparison compare(icosphere(1));
  ASSERT_TRUE(compare(PlacedRay(Ray{{0.1, 0.2, 5}, {0, 0, -1}})));
  int rays = 0;
  const auto expect_miss = [&](const Ray& ray) {
    EXPECT_FALSE(compare(PlacedRay(ray))) << rays;
    ++rays;
  };
  for (const Ray& ray : rays_with_nan()) expect_miss(ray);
  for (const double bad : {kInfinity, -kInfinity, kNan}) {
    for (int axis = 0; axis < 3; ++axis) {
      Ray origin{{0.1, 0.2, 5}, {0, 0, -1}}, direction = origin, both = origin;
      origin.origin[axis] = bad;
      direction.direction[axis] = bad;
      both.origin[axis] = both.direction[axis] = bad;
      for (const Ray& ray : {origin, direction, both}) expect_miss(ray);
    }
  }
  for (const double zero : {0.0, -0.0}) expect_miss({{0.1, 0.2, 0.3}, {zero, zero, zero}});
  EXPECT_EQ(rays, 8 + 27 + 2);
  EXPECT_EQ(compare.tally().different, 0);
}

TEST(Bvh8, OfAMeshWithoutTrianglesIsNeverHit) {
  TriangleMesh vertices;
  vertices.positions = {{0, 0, 0}, {1, 0, 0}};
  int meshes = 0;
  for (const TriangleMesh& mesh : {TriangleMesh{}, vertices}) {
    SearchComparison compare(mesh);
    EXPECT_FALSE(compare(PlacedRay(Ray{{0, 0, 3}, {0, 0, -1}})));
    EXPECT_EQ(compare.tally().different, 0);
    ++meshes;
  }
  EXPECT_EQ(meshes, 2);
}

TEST(Bvh8, FindsTheSameHitsBesideVerticesThatNothingUses) {
  SearchRandom u(10);
  SearchTally sum;
  int meshes = 0;
  for (const double far : {1e3, 1e20, 1e150, kInfinity, kNan}) {
    TriangleMesh mesh = icosphere(2);
    const std::vector<Ray> rays = aimed_rays(mesh, u, 2000, {}, 2);
    mesh.positions.push_back({far, 0, -far});
    sum += SearchComparison(std::move(mesh))(rays);
    ++meshes;
  }
  EXPECT_EQ(meshes, 5);
  EXPECT_EQ(sum.rays, 10000);
  EXPECT_GT(sum.hits, 7000);
}

TEST(Bvh8, TrianglesWithoutFiniteNumbersAreNotThere) {
  SearchRandom u(11);
  SearchTally sum;
  int meshes = 0;
  for (const double bad : {kNan, kInfinity, -kInfinity}) {
    for (const std::size_t every : {1, 2, 10, 100}) {
      TriangleMesh mesh = triangle_soup(u, 300, 0.5), sound;
      for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        if (i % every == 0)
          mesh.positions[mesh.triangles[i][i % 3]][static_cast<int>(i / 3 % 3)] = bad;
        else
          sound.triangles.push_back(mesh.triangles[i]);
      }
      sound.positions = mesh.positions;
      if (every == 1) sound = triangle_soup(u, 10, 0.5);
      SearchComparison compare(mesh);
      sum += compare(aimed_rays(sound, u, 1000, {}, 2));
      ++meshes;
    }
  }
  EXPECT_EQ(meshes, 12);
  EXPECT_EQ(sum.rays, 12000);
  EXPECT_GT(sum.hits, 6000);
}

}  // namespace
}  // namespace plumb
