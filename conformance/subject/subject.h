#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "conformance/subject/contract.h"
#include "conformance/verdict.h"
#include "reference/exact_transform.h"
#include "reference/shape.h"
#include "renderer/math/bounds3.h"
#include "renderer/math/ray.h"

namespace plumb {

/// One surface of a scene that a subject is asked about.
struct SubjectSurface {
  Shape shape;
  /// The groups around it, outermost first, each a list of lines in file order. For a probe, which is given a scene
  /// file.
  std::vector<std::vector<TransformStep>> groups;
  /// For a kernel, which is given the matrix: the rounded product of the groups (or any matrix, where there are none).
  AffineMatrix world_from_object = identity_matrix();
};
using SubjectScene = std::vector<SubjectSurface>;

/// A hit, or none: surface is the place in the SubjectScene.
struct SubjectHit {
  static constexpr std::uint32_t kMiss = PLUMB_MISS;
  std::uint32_t surface = kMiss;
  /// The triangle of a mesh.
  std::uint32_t primitive = 0;
  double t = 0, u = 0, v = 0;
  /// Whether the subject reports u and v.
  bool has_weights = true;
  /// In world space, where the subject reports one.
  std::optional<Vec3> normal;
  bool hit() const { return surface != kMiss; }
};

/// What a subject holds to be the matrices of one surface.
struct SubjectMatrices {
  AffineMatrix world_from_object{};
  AffineMatrix inverse{};
  std::array<std::array<double, 3>, 3> inverse_transpose{};
};

struct SubjectFresnel {
  double reflectance = 0;
};

/// The subject cannot do what was asked, and said so: the verdict is `unsupported`.
class UnsupportedBySubject : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The subject failed in a way that ends the question: crash, timeout, memory_limit, or fail with the cause `protocol`
/// (garbage, half a line, a number that is not one, an index out of range) or `not_finite`.
class SubjectFailure : public std::runtime_error {
 public:
  SubjectFailure(Verdict verdict, std::string cause, const std::string& sentence)
      : std::runtime_error(sentence), verdict_(verdict), cause_(std::move(cause)) {}
  Verdict verdict() const { return verdict_; }
  const std::string& cause() const { return cause_; }

 private:
  Verdict verdict_;
  std::string cause_;
};

/// The thing under test. A check loads a scene and asks; every answer has been validated (finite, in range, right
/// count), else SubjectFailure. After a SubjectFailure the next load starts the subject afresh. Not thread-safe.
class Subject {
 public:
  virtual ~Subject() = default;

  virtual const std::string& name() const = 0;
  /// One line of versions and flags; may be empty.
  virtual std::string description() const { return ""; }
  virtual const Contract& contract() const = 0;

  /// By how much fewer questions it is asked than a kernel in the same time; 1 for a kernel, less where each scene is a
  /// file.
  virtual double pace() const { return 1; }

  /// Ends whatever process the subject holds, so that another may run; the next load starts it afresh.
  virtual void rest() {}

  /// Replaces the scene that is asked about.
  virtual void load(const SubjectScene& scene) = 0;
  virtual std::vector<SubjectHit> closest(std::span<const Ray> rays) = 0;
  virtual std::vector<std::uint8_t> any(std::span<const Ray> rays);
  virtual std::vector<std::vector<SubjectHit>> all(std::span<const Ray> rays);
  /// One a surface.
  virtual std::vector<Bounds3> bounds();
  /// One a surface. A kernel, which is given its matrix, is UnsupportedBySubject.
  virtual std::vector<SubjectMatrices> matrices();
  virtual std::vector<Point3> average_positions();
  /// Exact Fresnel reflectance for unpolarised light; cosine, index from, index to.
  virtual double fresnel(double cosine, double from, double to);
  /// Nothing for total internal reflection.
  virtual std::optional<Vec3> refract(const Vec3& direction, const Vec3& normal, double from, double to);
  /// An orthonormal frame about a direction: u, v, w with w along it.
  virtual std::array<Vec3, 3> frame(const Vec3& direction);

  /// Many small scenes at once, each with its rays; the same as load and closest for each, but one question to a child
  /// process.
  struct Small {
    SubjectScene scene;
    std::vector<Ray> rays;
  };
  virtual std::vector<std::vector<SubjectHit>> closest_each(std::span<const Small> questions);

  /// CPU seconds that the subject itself spent in the last closest(), measured in its own process; nothing where that
  /// cannot be measured.
  virtual std::optional<double> last_cpu_seconds() const { return std::nullopt; }
};

}  // namespace plumb
