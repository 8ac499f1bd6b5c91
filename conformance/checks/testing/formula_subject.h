#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "conformance/subject/subject.h"

namespace plumb::planted {

/// A hit of one shape in its own frame. The normal has any length.
struct LocalHit {
  double t = 0, u = 0, v = 0;
  std::uint32_t primitive = 0;
  Normal3 normal{};
};

/// What a subject computes, each part a function, so that one of them can be replaced by a wrong one.
struct Formulas {
  Contract contract;
  /// The ray of world space in the surface's frame.
  std::function<Ray(const AffineMatrix&, const Ray&)> into_object;
  /// Every hit of the shape within the ray's range, both in the shape's frame.
  std::function<std::vector<LocalHit>(const Shape&, const Ray&)> hits;
  std::function<Vec3(const AffineMatrix&, const Normal3&)> normal_to_world;
  std::function<SubjectMatrices(const SubjectSurface&)> matrices;
  std::function<Bounds3(const SubjectSurface&)> bounds;
  std::function<Point3(const SubjectSurface&)> average_position;
  std::function<double(double cosine, double from, double to)> fresnel;
  std::function<std::optional<Vec3>(const Vec3& direction, const Vec3& normal, double from, double to)> refract;
  std::function<std::array<Vec3, 3>(const Vec3&)> frame;
};

/// Right ones: hits and boxes by the oracle, matrices, optics and frames by the renderer. Doubles, a closed range, all
/// shapes, everything that a kernel and a probe can be asked.
Formulas right_formulas();

/// Tries every surface. Numbers that are not finite are refused as those of a kernel are: SubjectFailure.
class FormulaSubject : public Subject {
 public:
  explicit FormulaSubject(Formulas formulas) : formulas_(std::move(formulas)) {}

  const std::string& name() const override { return name_; }
  const Contract& contract() const override { return formulas_.contract; }
  void load(const SubjectScene& scene) override { scene_ = scene; }
  std::vector<SubjectHit> closest(std::span<const Ray> rays) override;
  std::vector<std::uint8_t> any(std::span<const Ray> rays) override;
  std::vector<std::vector<SubjectHit>> all(std::span<const Ray> rays) override;
  std::vector<Bounds3> bounds() override;
  std::vector<SubjectMatrices> matrices() override;
  std::vector<Point3> average_positions() override;
  double fresnel(double cosine, double from, double to) override { return formulas_.fresnel(cosine, from, to); }
  std::optional<Vec3> refract(const Vec3& direction, const Vec3& normal, double from, double to) override {
    return formulas_.refract(direction, normal, from, to);
  }
  std::array<Vec3, 3> frame(const Vec3& direction) override { return formulas_.frame(direction); }

 private:
  std::vector<SubjectHit> hits_of(const Ray& ray) const;

  std::string name_ = "formulas";
  Formulas formulas_;
  SubjectScene scene_;
};

}  // namespace plumb::planted
