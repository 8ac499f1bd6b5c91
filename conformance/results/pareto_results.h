#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace plumb {

/// So many of so many rays.
struct Rate {
  std::int64_t count = 0, of = 0;
  /// Per million; 0 where nothing was asked.
  double per_million() const;
  /// Of none among N: the rate that it stays below at 95 %, 3 / N (the rule of three, for rays that are independent),
  /// per million. 0 where nothing was asked.
  double bound_per_million() const;
  friend bool operator==(const Rate&, const Rate&) = default;
};

/// How fast a kernel was, in CPU time of its own process: the median of several rounds, and the spread of them.
struct SpeedFigure {
  /// In one round, and the rounds; no rounds where the kernel failed.
  std::int64_t rays = 0;
  int rounds = 0;
  double million_rays_a_second = 0;
  double slowest = 0, fastest = 0;
};

/// The first figure: what a kernel says of one surface alone, held against the exact class.
struct ClassFigure {
  /// A family of the catalogue, and what part of it: `T8`, `huge`.
  std::string family, name;
  /// 0 where the kernel failed.
  std::int64_t rays = 0;
  /// Not asked, because their coordinates pass the kernel's largest.
  std::int64_t left_out = 0;
  std::int64_t false_misses = 0, false_hits = 0, wrong_crossings = 0;
  /// Hits with a t that is not finite; they stand as misses.
  std::int64_t not_finite = 0;
  /// Triangles: how far from an edge's line (edge_margin, in unit roundoffs of the kernel) the farthest wrong ray
  /// passes.
  double farthest_u = 0;
  /// The error of t of the right hits, in units of the last place of the kernel's precision of t.
  std::int64_t right_hits = 0;
  double t_ulps_median = 0, t_ulps_p99 = 0;

  Rate wrong() const { return {false_misses + false_hits + wrong_crossings, rays}; }
};

/// The second figure: rays from inside of closed meshes that hit nothing.
struct EscapeFigure {
  /// `vertices`, `edges`, `faces`
  std::string aim;
  std::int64_t meshes = 0;
  /// 0 where the kernel failed.
  std::int64_t rays = 0;
  std::int64_t escapes = 0;
  /// How far from an edge of the triangle that it should have hit: the median of the escaped rays, and the farthest.
  double median_u = 0, farthest_u = 0;
  /// The mesh with the most of them.
  std::string worst_mesh;

  Rate rate() const { return {escapes, rays}; }
};

/// The third figure: which triangle of a mesh is hit first, held against the exact order.
struct ClosestFigure {
  std::string scene, aim;
  /// 0 where the kernel failed.
  std::int64_t rays = 0;
  /// With more than one right answer: exact ties, and crossings on a boundary.
  std::int64_t ties = 0;
  std::int64_t missed = 0;  ///< a triangle is hit, and none was reported
  std::int64_t beside = 0;  ///< a triangle was reported that is not met at all
  std::int64_t behind = 0;  ///< a triangle was reported that is met, but behind another
  /// Of `missed` and `beside`: how far from an edge of the triangle about which the kernel is wrong.
  double farthest_u = 0;
  /// Of `behind`: how much farther than the first, in units of the last place of t.
  double farthest_ulps = 0;

  Rate wrong() const { return {missed + beside + behind, rays}; }
};

/// A kernel as it was asked: a column of the tables.
struct ParetoKernel {
  /// `mt-double`; `mt-double/53` for the same kernel, asked with numbers that use all bits of a double.
  std::string name;
  /// The precision of all numbers that it is asked with: `float` or `double`.
  std::string inputs;
  std::string description;
  SpeedFigure speed;
  /// The same ones in the same order for all kernels of a table.
  std::vector<ClassFigure> classes;
  std::vector<EscapeFigure> escapes;
  std::vector<ClosestFigure> closest;
};

/// A whole picture with so many samples a pixel, held against a converged one.
struct PictureFigure {
  std::string scene;
  int width = 0, height = 0;
  int samples = 0;
  /// Of the converged picture.
  int reference_samples = 0;
  /// Over all pixels and channels, in linear colour.
  double rms = 0, largest = 0;
  double cpu_seconds = 0;
};

/// What `plumb check --pareto` measured.
struct ParetoResults {
  std::string plumb_version, processor;
  std::uint64_t seed = 1;
  double intensity = 1;
  /// What a ray costs in the kernel's process without any work on it, and on the clock from question to answer.
  double empty_cpu_nanoseconds = 0, empty_clock_nanoseconds = 0;
  /// What the speeds were measured on, a sentence each.
  std::string triangle_scene, sphere_scene;
  std::vector<ParetoKernel> triangles, spheres;
  std::vector<PictureFigure> pictures;
  /// What went wrong with single kernels, a sentence each.
  std::vector<std::string> notes;
};

}  // namespace plumb
