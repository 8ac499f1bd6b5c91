#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "conformance/families/hardness_for_tests.h"

namespace plumb {
namespace {

using namespace textbook;

TEST(Hardness, BoxesFoolTheSlabTest) {
  EXPECT_GT(tally_of<float>("B1", 1000).wrong(), 120);
  EXPECT_GT(tally_of<double>("B1", 1000).wrong(), 120);
  EXPECT_GT(tally_of<float>("B3", 1000).wrong_class, 120);
  EXPECT_GT(tally_of<double>("B3", 1000).wrong_class, 120);
}

/// All that hits a box without thickness is lost by `entry < exit`.
TEST(Hardness, FlatBoxesAreMissedByAStrictTest) {
  const auto family = family_kind("B2").make(3, PLUMB_DOUBLE);
  int hits = 0;
  for (int i = 0; i < 500; ++i) {
    const FamilyCase question = family->next();
    for (const Ray& ray : question.rays) {
      if (!box<double>(question.surface.shape, line_of<double>(ray), true).hit) continue;
      ++hits;
      EXPECT_FALSE(box<double>(question.surface.shape, line_of<double>(ray), true, true).hit);
    }
  }
  EXPECT_GT(hits, 2000);
}

TEST(Hardness, SpheresFoolTheTextbook) {
  for (const char* id : {"S1", "S2", "S3", "S4"}) {
    EXPECT_GT(tally_of<float>(id, 1000).hard(), 1200) << id;
    EXPECT_GT(tally_of<double>(id, 1000).hard(), 1200) << id;
  }
}

/// q = -(b + sgn(b) sqrt(disc)) with sgn(0) = 0 is 0, and c / q infinite.
TEST(Hardness, SignOfZeroLosesTheRoot) {
  for (const plumb_precision precision : {PLUMB_FLOAT, PLUMB_DOUBLE}) {
    const auto family = family_kind("S5").make(3, precision);
    int rays = 0, zero = 0, inside = 0;
    for (int i = 0; i < 500; ++i) {
      const FamilyCase question = family->next();
      for (const Ray& ray : question.rays) {
        ++rays;
        const Vec3 f = ray.origin - question.surface.shape.center;
        const double r = question.surface.shape.radius;
        zero += dot(f, ray.direction) == 0 ? 1 : 0;
        inside += dot(f, f) < r * r ? 1 : 0;
      }
    }
    EXPECT_EQ(rays, 6000);
    EXPECT_EQ(zero, rays);
    EXPECT_GT(inside, rays / 3);
    EXPECT_LT(inside, rays * 9 / 10);
  }
}

TEST(Hardness, CappedSolidsLeakAtRims) {
  for (const plumb_precision precision : {PLUMB_FLOAT, PLUMB_DOUBLE}) {
    const auto family = family_kind("C1").make(3, precision);
    int from_inside = 0, leaks = 0;
    for (int i = 0; i < 1000; ++i) {
      const FamilyCase question = family->next();
      const Shape& shape = question.surface.shape;
      for (const Ray& ray : question.rays) {
        // From inside of its middle cylinder a ray meets the solid, whatever its direction.
        const Vec3 f = ray.origin - shape.center;
        if (shape.kind != ShapeKind::cylinder || std::fabs(f.z) > 0.45 * shape.height ||
            f.x * f.x + f.y * f.y > 0.9 * shape.radius * shape.radius) {
          continue;
        }
        ++from_inside;
        const bool hit = precision == PLUMB_FLOAT ? round_solid<float>(shape, line_of<float>(ray), 0).hit
                                                  : round_solid<double>(shape, line_of<double>(ray), 0).hit;
        leaks += hit ? 0 : 1;
      }
    }
    std::printf("C1: %d of %d leak\n", leaks, from_inside);
    EXPECT_GT(from_inside, 2000);
    EXPECT_GT(leaks, from_inside / 100);
  }
}

TEST(Hardness, CylindersFoolTheQuadratic) {
  EXPECT_GT(tally_of<float>("C2", 1000).hard(), 120);
  EXPECT_GT(tally_of<double>("C2", 1000).hard(), 120);
}

/// t in units of the condition: that is what conditions are for. With formulas that do not cancel by themselves, few
/// rays go beyond 64 u condition: those that lose the nearer hit at an edge or rim and report the far one.
TEST(Hardness, ConditionBoundsTheErrorOfT) {
  for (const char* id : {"T1", "T4", "T5", "T6", "T7", "T9", "S0", "S1", "S2", "S3", "S4", "C1", "C2", "M1", "M3"}) {
    const auto family = family_kind(id).make(5, PLUMB_DOUBLE);
    int compared = 0, beyond = 0;
    for (int i = 0; i < 400; ++i) {
      const FamilyCase question = family->next();
      const Shape& shape = question.surface.shape;
      for (const Ray& ray : question.rays) {
        const auto truth = intersect(shape, object_line<Quad>(question.surface, ray), true);
        const auto line = object_line<double>(question.surface, ray);
        const auto naive = shape.kind == ShapeKind::sphere ? precise_sphere(shape, line) : plain(shape, line);
        if (!truth.hit || !naive.hit || truth.margin < kUndecided) continue;
        ++compared;
        const Quad error = magnitude(static_cast<Quad>(naive.t) - truth.t);
        if (error > 64 * 0x1p-53 * question.condition * magnitude(truth.t)) ++beyond;
      }
    }
    std::printf("%-4s %d of %d beyond 64 u condition\n", id, beyond, compared);
    EXPECT_GT(compared, 500) << id;
    EXPECT_LE(beyond, compared / 20) << id;
  }
}

TEST(Hardness, NormalisingTheDirectionChangesT) {
  const auto family = family_kind("M1").make(3, PLUMB_DOUBLE);
  int rays = 0, changed = 0;
  double worst = 1;
  for (int i = 0; i < 500; ++i) {
    const FamilyCase question = family->next();
    worst = std::max(worst, question.condition);
    for (const Ray& ray : question.rays) {
      ++rays;
      const auto d = in_object_space(question.surface.world_from_object, line_of<double>(ray)).d;
      const double ratio = dot(d, d) / dot(ray.direction, ray.direction);
      changed += std::fabs(ratio - 1) > 0.01 ? 1 : 0;
    }
  }
  EXPECT_EQ(rays, 6000);
  EXPECT_GT(changed, rays / 2);
  EXPECT_GT(worst, 1e11);
  EXPECT_LE(worst, 1e12);
}

/// The angle between M n and M^-T n at the point that the normal of the recipe belongs to.
TEST(Hardness, NonUniformScaleTurnsNormals) {
  const auto family = family_kind("M2").make(3, PLUMB_DOUBLE);
  int triangles = 0, off = 0;
  double worst = 0;
  for (int i = 0; i < 600; ++i) {
    const FamilyCase question = family->next();
    const Shape& shape = question.surface.shape;
    if (shape.kind != ShapeKind::triangle) continue;
    ++triangles;
    const Transform world_from_object(question.surface.world_from_object);
    const Vec3 n = cross(shape.vertices[1] - shape.vertices[0], shape.vertices[2] - shape.vertices[0]);
    const double cosine = dot(normalized(world_from_object(as_normal(n))), normalized(world_from_object(n)));
    const double degrees = std::acos(std::min(1.0, cosine)) * 180 / std::numbers::pi;
    off += degrees > 30 ? 1 : 0;
    worst = std::max(worst, degrees);
  }
  EXPECT_GT(triangles, 150);
  // 36.87 degrees at a factor of 2 or 1/2; 53 at 3, and so on.
  EXPECT_EQ(off, triangles);
  EXPECT_GT(worst, 70);
}

double determinant(const AffineMatrix& m) {
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

TEST(Hardness, MirrorsHaveNegativeDeterminants) {
  for (const plumb_precision precision : {PLUMB_FLOAT, PLUMB_DOUBLE}) {
    const auto family = family_kind("M3").make(3, precision);
    for (int i = 0; i < 500; ++i) EXPECT_LT(determinant(family->next().surface.world_from_object), 0) << "case " << i;
  }
}

/// Radians leave dust where a zero should stand.
TEST(Hardness, RightAnglesAreExactOnlyInDegrees) {
  const auto family = family_kind("M4").make(3, PLUMB_DOUBLE);
  int turned = 0, dusty = 0;
  for (int i = 0; i < 500; ++i) {
    const SubjectSurface surface = family->next().surface;
    for (const auto& row : surface.world_from_object) {
      for (int c = 0; c < 3; ++c) {
        const double entry = std::fabs(row[static_cast<std::size_t>(c)]);
        EXPECT_TRUE(entry == 0 || entry == 1) << std::hexfloat << entry << " in case " << i;
      }
    }
    const Vec3 angles = surface.groups[0][0].value;
    for (int axis = 0; axis < 3; ++axis) {
      if (std::fmod(angles[axis], 180) == 0) continue;
      ++turned;
      dusty += std::cos(angles[axis] * std::numbers::pi / 180) != 0 ? 1 : 0;
    }
  }
  EXPECT_GT(turned, 200);
  EXPECT_EQ(dusty, turned);
}

/// Along each axis a transformed sphere reaches radius * sqrt(sum m_ij^2) from its centre; the box around the corners
/// of its box, radius * sum |m_ij|.
TEST(Hardness, BoxesOfBoxesAreLooseAndPlainRootsFailToContain) {
  const auto family = family_kind("A1").make(3, PLUMB_DOUBLE);
  int faces = 0, loose = 0, outside = 0;
  for (int i = 0; i < 600; ++i) {
    const SubjectSurface surface = family->next().surface;
    if (surface.shape.kind != ShapeKind::sphere) continue;
    for (const auto& row : surface.world_from_object) {
      const Triple<Quad> m{row[0], row[1], row[2]};
      const Quad center = dot(m, to<Quad>(surface.shape.center)) + row[3];
      const Quad reach = static_cast<Quad>(surface.shape.radius) * square_root(dot(m, m));
      const double by_corners = surface.shape.radius * (std::fabs(row[0]) + std::fabs(row[1]) + std::fabs(row[2]));
      const Point3 c = surface.shape.center;
      const double plain_top = row[0] * c.x + row[1] * c.y + row[2] * c.z + row[3] +
                               surface.shape.radius * std::sqrt(row[0] * row[0] + row[1] * row[1] + row[2] * row[2]);
      ++faces;
      loose += by_corners > 1.1 * static_cast<double>(reach) ? 1 : 0;
      outside += plain_top < center + reach ? 1 : 0;
    }
  }
  std::printf("A1: %d faces, %d loose by a tenth, %d fail to contain\n", faces, loose, outside);
  EXPECT_GT(faces, 800);
  EXPECT_GT(loose, faces / 2);
  EXPECT_GT(outside, faces / 4);
}

}  // namespace
}  // namespace plumb
