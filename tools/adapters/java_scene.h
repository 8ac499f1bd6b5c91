#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tools/adapters/java_program.h"

namespace plumb {

/// Surfaces whose places are known by hand. The group of 1/0 takes (x, y, z) to (z + 10, 2x, y), for Rx(90) takes it to
/// (x, -z, y) and Rz(90) to (-y, x, z); 1/1/0 stands in it, three times as high.
inline constexpr const char* kJavaScene = R"(<scene>
  <image>4 4</image>
  <shader name="red" type="Phong"><diffuseColor>1 0 0</diffuseColor><exponent>20</exponent></shader>
  <surface type="Sphere"><shader ref="red"/><radius>0.1</radius></surface>
  <surface type="Group">
    <translate>10 0 0</translate> <rotate>90 0 90</rotate> <scale>2 1 1</scale>
    <surface type="Box"><minPt>0 0 0</minPt><maxPt>1 2 3</maxPt></surface>
    <surface type="Group"><scale>1 1 3</scale>
      <surface type="Cylinder"><center>5 5 5</center><radius>0.5</radius><height>2</height></surface>
    </surface>
  </surface>
  <surface type="Group"><translate>-30 60 0</translate><rotate>30 40 50</rotate>
    <surface type="Box"><minPt>-1 -2 -3</minPt><maxPt>1 2 3</maxPt></surface>
  </surface>
  <surface type="Mesh"><data>square.msh</data></surface>
  <surface type="Group"><translate>0 40 0</translate><scale>2 1 1</scale> <surface type="Sphere"/> </surface>
</scene>)";

/// The unit square at x = 1 and z = -20.
inline constexpr const char* kSquareMesh =
    "4\n2\nvertices\n1\n0\n-20\n2\n0\n-20\n2\n1\n-20\n1\n1\n-20\ntriangles\n0\n1\n2\n0\n2\n3\n";

inline std::vector<nlohmann::json> java_questions(const JavaProgram& program) {
  program.write("scene.xml", kJavaScene);
  program.write("square.msh", kSquareMesh);
  const nlohmann::json rays = {
      {0, 0, 5, 0, 0, -2, 0, "inf"},                 // the sphere, t in lengths of 2
      {20, 1, 1, -0.5, 0, 0, 0, "inf"},              // the box 1/0 at x = 13
      {25, 10, 50, 0, 0, -1, 0, "inf"},              // the cylinder at z = 5.5
      {0, 0, 5, 0, 0, -2, 0, 2.4},                   // ends before the sphere
      {0, 0, 5, 0, 0, -2, 2.5, 100},                 // begins within it
      {0, 0, 5, 0, 1, 0, 0, "inf"},                  // nothing
      {1.25, 0.75, -10, 0, 0, -1, 0, "inf"},         // the second triangle
      {std::sqrt(2.0), 40, 10, 0, 0, -1, 0, "inf"},  // the ellipsoid where its own normal is at 45 degrees
  };
  return {{{"ask", "load"}, {"scene", program.path("scene.xml")}},
          {{"ask", "surfaces"}},
          {{"ask", "bounds"}},
          {{"ask", "matrices"}},
          {{"ask", "average_positions"}},
          {{"ask", "closest"}, {"rays", rays}},
          {{"ask", "any"}, {"rays", rays}},
          {{"ask", "all"}, {"rays", rays}}};
}

inline std::vector<double> numbers(const nlohmann::json& list) { return list.get<std::vector<double>>(); }

inline void expect_near(const nlohmann::json& list, const std::vector<double>& expected, double tolerance) {
  EXPECT_THAT(numbers(list), testing::Pointwise(testing::DoubleNear(tolerance), expected));
}

/// Whether a box holds the image of the box [-h, h] under a matrix, all eight corners, within a tolerance.
inline bool holds_corners(const nlohmann::json& bounds, const nlohmann::json& world, const std::vector<double>& h,
                          double tolerance) {
  const std::vector<double> b = numbers(bounds), m = numbers(world);
  for (std::size_t i = 0; i < 3; ++i) {
    const double reach = std::abs(m[4 * i] * h[0]) + std::abs(m[4 * i + 1] * h[1]) + std::abs(m[4 * i + 2] * h[2]);
    if (b[i] > m[4 * i + 3] - reach + tolerance || b[i + 3] < m[4 * i + 3] + reach - tolerance) return false;
  }
  return true;
}

/// The answers to java_questions(), each number within a tolerance.
inline void expect_right_answers(const std::vector<nlohmann::json>& answers, double tolerance) {
  ASSERT_EQ(answers.size(), 9u);
  EXPECT_EQ(answers[1]["ok"], true) << answers[1];

  const nlohmann::json bounds = answers[3]["bounds"];
  ASSERT_EQ(bounds.size(), 6u) << answers[3];
  expect_near(bounds[0], {-0.1, -0.1, -0.1, 0.1, 0.1, 0.1}, tolerance);
  expect_near(bounds[1], {10, 0, 0, 13, 2, 2}, tolerance);
  expect_near(bounds[2], {22, 9, 4.5, 28, 11, 5.5}, tolerance);
  expect_near(bounds[4], {1, 0, -20, 2, 1, -20}, tolerance);
  expect_near(bounds[5], {-2, 39, -1, 2, 41, 1}, tolerance);

  const nlohmann::json matrices = answers[4]["matrices"];
  ASSERT_EQ(matrices.size(), 6u) << answers[4];
  expect_near(matrices[1]["world"], {0, 0, 1, 10, 2, 0, 0, 0, 0, 1, 0, 0}, tolerance);
  expect_near(matrices[1]["inverse"], {0, 0.5, 0, 0, 0, 0, 1, 0, 1, 0, 0, -10}, tolerance);
  expect_near(matrices[1]["inverse_transpose"], {0, 0, 1, 0.5, 0, 0, 0, 1, 0}, tolerance);
  expect_near(matrices[2]["world"], {0, 0, 3, 10, 2, 0, 0, 0, 0, 1, 0, 0}, tolerance);
  EXPECT_TRUE(holds_corners(bounds[3], matrices[3]["world"], {1, 2, 3}, tolerance));

  const nlohmann::json middles = answers[5]["average_positions"];
  ASSERT_EQ(middles.size(), 6u) << answers[5];
  expect_near(middles[1], {11.5, 1, 1}, tolerance);
  expect_near(middles[4], {1.5, 0.5, -20}, tolerance);

  const nlohmann::json hits = answers[6]["hits"];
  ASSERT_EQ(hits.size(), 8u) << answers[6];
  const auto expect_hit = [&](std::size_t i, int surface, double t, const std::vector<double>& normal) {
    ASSERT_TRUE(hits[i].is_object()) << i;
    EXPECT_EQ(hits[i]["s"], surface) << i;
    EXPECT_NEAR(hits[i]["t"].get<double>(), t, tolerance) << i;
    expect_near(hits[i]["n"], normal, tolerance);
  };
  expect_hit(0, 0, 2.45, {0, 0, 1});
  expect_hit(1, 1, 14, {1, 0, 0});
  expect_hit(2, 2, 44.5, {0, 0, 1});
  EXPECT_TRUE(hits[3].is_null());
  expect_hit(4, 0, 2.55, {0, 0, -1});
  EXPECT_TRUE(hits[5].is_null());
  expect_hit(6, 4, 10, {0, 0, 1});
  EXPECT_EQ(hits[6]["p"], 1);
  expect_hit(7, 5, 10 - std::sqrt(0.5), {1 / std::sqrt(5.0), 0, 2 / std::sqrt(5.0)});
  EXPECT_EQ(answers[7]["any"], nlohmann::json({1, 1, 1, 0, 1, 0, 1, 1}));

  std::vector<std::size_t> counts;
  for (const nlohmann::json& list : answers[8]["all"]) counts.push_back(list.size());
  EXPECT_THAT(counts, testing::ElementsAre(2u, 2u, 2u, 0u, 1u, 0u, 1u, 2u));
}

}  // namespace plumb
