// The shipped kernels, asked in a process of their own and in this one.
#include "conformance/subject/kernel_subject.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <random>

#include "conformance/subject/shipped_kernels.h"
#include "meshes/generators/icosphere.h"
#include "renderer/math/input_error.h"

namespace plumb {
namespace {

/// Volatile, because GCC 12 drops a plain rounding to float and back where it vectorises.
double as_float(double x) {
  const volatile float rounded = static_cast<float>(x);
  return rounded;
}

/// Numbers that are floats, so that every kernel may be given them.
class Floats {
 public:
  explicit Floats(unsigned seed) : random_(seed) {}
  double number(double scale = 1) { return as_float(scale * uniform_(random_)); }
  Point3 point(double scale) { return {number(scale), number(scale), number(scale)}; }
  /// From around 4 away to somewhere within 1.5 of the middle.
  Ray ray() {
    const Point3 origin = point(4);
    const Point3 target = point(1.5);
    return {origin, {as_float(target.x - origin.x), as_float(target.y - origin.y), as_float(target.z - origin.z)}};
  }
  std::vector<Ray> rays(std::size_t count) {
    std::vector<Ray> rays(count);
    for (Ray& r : rays) r = ray();
    return rays;
  }

 private:
  std::mt19937_64 random_;
  std::uniform_real_distribution<double> uniform_{-1, 1};
};

SubjectSurface surface_of(TriangleMesh mesh) {
  for (Point3& p : mesh.positions) p = {as_float(p.x), as_float(p.y), as_float(p.z)};
  SubjectSurface surface;
  surface.shape.kind = ShapeKind::mesh;
  surface.shape.mesh = std::make_shared<const TriangleMesh>(std::move(mesh));
  return surface;
}

SubjectSurface sphere(const Point3& center, double radius) {
  SubjectSurface surface;
  surface.shape.kind = ShapeKind::sphere;
  surface.shape.center = center;
  surface.shape.radius = radius;
  return surface;
}

/// A ball of 320 triangles with a triangle inside, or 20 spheres.
SubjectScene scene_for(const Contract& contract) {
  SubjectScene scene;
  if (contract.shapes & PLUMB_MESHES) {
    scene.push_back(surface_of(icosphere(2)));
    SubjectSurface triangle;
    triangle.shape.vertices = {Point3{-0.5, -0.5, 0}, Point3{0.5, -0.5, 0.25}, Point3{0, 0.75, 0}};
    scene.push_back(triangle);
  } else {
    Floats floats(5);
    for (int i = 0; i < 20; ++i) scene.push_back(sphere(floats.point(1.5), 0.25));
  }
  return scene;
}

bool same_bits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

void expect_same(const std::vector<SubjectHit>& a, const std::vector<SubjectHit>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].surface, b[i].surface) << i;
    EXPECT_EQ(a[i].primitive, b[i].primitive) << i;
    EXPECT_TRUE(same_bits(a[i].t, b[i].t) && same_bits(a[i].u, b[i].u) && same_bits(a[i].v, b[i].v)) << i;
  }
}

int hits_in(const std::vector<SubjectHit>& hits) {
  return static_cast<int>(std::ranges::count_if(hits, [](const SubjectHit& h) { return h.hit(); }));
}

class ShippedKernel : public testing::TestWithParam<const char*> {
 protected:
  std::filesystem::path library() const { return shipped_kernel(GetParam()); }
};

TEST_P(ShippedKernel, AnswersTheSameInBothProcesses) {
  KernelSubject apart(library());
  LocalKernelSubject here(library());
  EXPECT_EQ(apart.name(), GetParam());
  EXPECT_EQ(apart.name(), here.name());
  EXPECT_FALSE(apart.description().empty());
  EXPECT_EQ(to_string(apart.contract()), to_string(here.contract()));
  const SubjectScene scene = scene_for(apart.contract());
  const std::vector<Ray> rays = Floats(7).rays(300);
  apart.load(scene);
  here.load(scene);
  const std::vector<SubjectHit> hits = apart.closest(rays);
  expect_same(hits, here.closest(rays));
  ASSERT_TRUE(apart.last_cpu_seconds() && here.last_cpu_seconds());
  EXPECT_GT(*apart.last_cpu_seconds(), 0);
  if (apart.name() == "empty") return;
  EXPECT_GT(hits_in(hits), 90);
  EXPECT_LT(hits_in(hits), 300);
  if (apart.contract().capabilities & PLUMB_ANY_HIT) {
    const auto any = apart.any(rays);
    EXPECT_EQ(any, here.any(rays));
    for (std::size_t i = 0; i < rays.size(); ++i) EXPECT_EQ(any[i] == 1, hits[i].hit()) << i;
  }
  if (apart.contract().capabilities & PLUMB_ALL_HITS) {
    const auto all = apart.all(rays);
    const auto all_here = here.all(rays);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      expect_same(all[i], all_here[i]);
      ASSERT_EQ(all[i].empty(), !hits[i].hit()) << i;
      if (all[i].empty()) continue;
      const auto nearest = std::ranges::min_element(all[i], {}, [](const SubjectHit& h) { return h.t; });
      EXPECT_EQ(nearest->t, hits[i].t) << i;
    }
  }
  if (apart.contract().capabilities & PLUMB_BOUNDS) {
    EXPECT_EQ(apart.bounds(), here.bounds());
  }
}

TEST_P(ShippedKernel, ManySmallScenesAreAnsweredAsOneByOne) {
  KernelSubject apart(library());
  LocalKernelSubject here(library());
  Floats floats(11);
  const bool meshes = apart.contract().shapes & PLUMB_MESHES;
  std::vector<Subject::Small> questions;
  for (int i = 0; i < 5000; ++i) {  // more than go into one message
    SubjectSurface surface = sphere(floats.point(1), 1);
    if (meshes) {
      surface.shape.kind = ShapeKind::triangle;
      surface.shape.vertices = {floats.point(2), floats.point(2), floats.point(2)};
    }
    questions.push_back({{surface}, {floats.ray()}});
  }
  const auto together = apart.closest_each(questions);
  const auto locally = here.closest_each(questions);
  ASSERT_EQ(together.size(), questions.size());
  int hits = 0;
  for (std::size_t i = 0; i < questions.size(); ++i) {
    expect_same(together[i], locally[i]);
    hits += hits_in(together[i]);
    if (i % 50 != 0) continue;
    apart.load(questions[i].scene);
    expect_same(together[i], apart.closest(questions[i].rays));
  }
  EXPECT_TRUE(hits > 100 || apart.name() == "empty");
}

INSTANTIATE_TEST_SUITE_P(Each, ShippedKernel,
                         testing::Values("brute-force", "cgal", "embree", "embree-robust", "empty", "mt-double",
                                         "mt-float", "plumb", "sphere-precise-double", "sphere-precise-float",
                                         "sphere-textbook-double", "sphere-textbook-float", "woop-float"),
                         [](const auto& kernel) {
                           std::string name = kernel.param;
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

TEST(ShippedKernels, AreTheOnesThatAreTested) {
  EXPECT_EQ(shipped_kernel_names(),
            (std::vector<std::string>{"brute-force", "cgal", "embree", "embree-robust", "empty", "mt-double",
                                      "mt-float", "plumb", "sphere-precise-double", "sphere-precise-float",
                                      "sphere-textbook-double", "sphere-textbook-float", "woop-float"}));
  try {
    shipped_kernel("embre");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean"), std::string::npos) << error.what();
  }
}

TEST(ShippedKernels, OfTrianglesAgreeOnRandomRays) {
  // Rays that aim at no edge: none comes so near to one that roundings decide, as this seed shows.
  const std::vector<Ray> rays = Floats(13).rays(2000);
  LocalKernelSubject reference(shipped_kernel("brute-force"));
  const SubjectScene scene = scene_for(reference.contract());
  reference.load(scene);
  const std::vector<SubjectHit> expected = reference.closest(rays);
  EXPECT_GT(hits_in(expected), 500);
  for (const char* name : {"cgal", "embree", "embree-robust", "mt-double", "mt-float", "plumb", "woop-float"}) {
    LocalKernelSubject kernel(shipped_kernel(name));
    kernel.load(scene);
    const std::vector<SubjectHit> hits = kernel.closest(rays);
    const bool is_float = kernel.contract().t_precision == PLUMB_FLOAT;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      ASSERT_EQ(hits[i].surface, expected[i].surface) << name << " ray " << i;
      ASSERT_EQ(hits[i].primitive, expected[i].primitive) << name << " ray " << i;
      // Coordinates of at most 8 and angles that are not grazing: some hundred units in the last place.
      const double tolerance = is_float ? 1e-4 : 1e-12;
      EXPECT_NEAR(hits[i].t, expected[i].t, tolerance) << name << " ray " << i;
      EXPECT_NEAR(hits[i].u, expected[i].u, 10 * tolerance) << name << " ray " << i;
      EXPECT_NEAR(hits[i].v, expected[i].v, 10 * tolerance) << name << " ray " << i;
      EXPECT_TRUE(!is_float || hits[i].t == as_float(hits[i].t)) << name;
    }
  }
}

TEST(ShippedKernels, OfSpheresAgreeUnderMatrices) {
  Floats floats(17);
  SubjectScene scene;
  for (int i = 0; i < 20; ++i) {
    scene.push_back(sphere(floats.point(1), 0.25));
    scene.back().world_from_object = translation({floats.number(), 0, floats.number()}) * scaling({2, 0.5, -1});
  }
  const std::vector<Ray> rays = floats.rays(2000);
  LocalKernelSubject reference(shipped_kernel("plumb"));
  reference.load(scene);
  const std::vector<SubjectHit> expected = reference.closest(rays);
  EXPECT_GT(hits_in(expected), 500);
  for (const char* name :
       {"sphere-precise-double", "sphere-precise-float", "sphere-textbook-double", "sphere-textbook-float"}) {
    LocalKernelSubject kernel(shipped_kernel(name));
    kernel.load(scene);
    const std::vector<SubjectHit> hits = kernel.closest(rays);
    int agree = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      if (hits[i].surface != expected[i].surface) continue;  // near the rim
      ++agree;
      EXPECT_NEAR(hits[i].t, expected[i].t, kernel.contract().t_precision == PLUMB_FLOAT ? 2e-3 : 1e-9) << name;
    }
    EXPECT_GE(agree, 1995) << name;
  }
}

TEST(ShippedKernels, KeepTheRangeTheyDeclare) {
  // The triangle of kernels of triangles is hit at t = 2, the sphere's near side likewise.
  SubjectSurface triangle;
  triangle.shape.vertices = {Point3{-1, -1, 0}, Point3{1, -1, 0}, Point3{0, 1, 0}};
  int asked = 0;
  for (const std::string& name : shipped_kernel_names()) {
    if (name == "empty") continue;
    LocalKernelSubject kernel(shipped_kernel(name));
    kernel.load({kernel.contract().shapes & PLUMB_MESHES ? triangle : sphere({0, 0, -1}, 1)});
    const auto hit = [&](const Point3& origin, double t_min, double t_max) {
      return kernel.closest(std::vector<Ray>{{origin, {0, 0, -1}, t_min, t_max}})[0].hit();
    };
    const bool closed = kernel.contract().range == PLUMB_RANGE_CLOSED;
    const auto beside = [](double x, double towards) -> double {
      return std::nextafterf(static_cast<float>(x), static_cast<float>(towards));
    };
    EXPECT_TRUE(hit({0, 0, 2}, 0, 8)) << name;
    EXPECT_EQ(hit({0, 0, 2}, 0, 2), closed) << name;
    EXPECT_EQ(hit({0, 0, 2}, 2, 3), closed) << name;
    EXPECT_EQ(hit({0, 0, 0}, 0, 1), closed) << name;
    EXPECT_TRUE(hit({0, 0, 2}, 0, beside(2, 3))) << name;
    EXPECT_TRUE(hit({0, 0, 2}, beside(2, 0), 3)) << name;
    EXPECT_FALSE(hit({0, 0, 2}, 0, beside(2, 0))) << name;
    EXPECT_FALSE(hit({0, 0, 2}, beside(2, 3), 3)) << name;
    ++asked;
  }
  EXPECT_EQ(asked, 12);
}

TEST(ShippedKernels, OurTracerKnowsEverySolidAndSharesMeshes) {
  SubjectScene scene;
  scene.push_back(surface_of(icosphere(1)));
  scene.push_back(scene[0]);
  scene[1].world_from_object = translation({4, 0, 0});
  SubjectSurface box = sphere({}, 1);
  box.shape.kind = ShapeKind::box;
  box.shape.min = {7, -1, -1};
  box.shape.max = {9, 1, 1};
  scene.push_back(box);
  SubjectSurface cylinder = sphere({12, 0, 0}, 1);
  cylinder.shape.kind = ShapeKind::cylinder;
  cylinder.shape.height = 2;
  scene.push_back(cylinder);
  SubjectSurface cone = cylinder;
  cone.shape.kind = ShapeKind::cone;
  cone.shape.center = {16, 0, 0};
  cone.shape.tip_z = 2;
  scene.push_back(cone);
  scene.push_back(sphere({20, 0, 0}, 1));
  KernelSubject tracer(shipped_kernel("plumb"));
  tracer.load(scene);
  const std::vector<Bounds3> bounds = tracer.bounds();
  ASSERT_EQ(bounds.size(), scene.size());
  for (std::size_t i = 0; i < scene.size(); ++i) {
    const std::vector<Ray> down{{{4.0 * static_cast<double>(i) + 0.1, 0.2, 5}, {0, 0, -1}}};
    const SubjectHit hit = tracer.closest(down)[0];
    ASSERT_EQ(hit.surface, i);
    EXPECT_EQ(tracer.all(down)[0].size(), 2u) << "in and out of surface " << i;
    EXPECT_EQ(tracer.any(down)[0], 1);
    EXPECT_TRUE(bounds[i].contains(down[0].at(hit.t))) << i;
  }
}

TEST(ShippedKernels, AQuestionOfNothingIsAnswered) {
  for (const std::string& name : shipped_kernel_names()) {
    KernelSubject kernel(shipped_kernel(name));
    kernel.load({});
    EXPECT_FALSE(kernel.closest(std::vector<Ray>{{{0, 0, 1}, {0, 0, -1}}})[0].hit()) << name;
    EXPECT_TRUE(kernel.closest({}).empty()) << name;
    EXPECT_TRUE(kernel.closest_each({}).empty()) << name;
    if (!(kernel.contract().shapes & PLUMB_MESHES)) continue;
    kernel.load({surface_of({})});
    EXPECT_FALSE(kernel.closest(std::vector<Ray>{{{0, 0, 1}, {0, 0, -1}}})[0].hit()) << name;
  }
}

}  // namespace
}  // namespace plumb
