#include "conformance/subject/subject.h"

namespace plumb {
namespace {

[[noreturn]] void unsupported(const Subject& subject, const char* what) {
  throw UnsupportedBySubject(subject.name() + " does not answer " + what);
}

}  // namespace

std::vector<std::uint8_t> Subject::any(std::span<const Ray>) { unsupported(*this, "whether a ray hits anything"); }
std::vector<std::vector<SubjectHit>> Subject::all(std::span<const Ray>) { unsupported(*this, "all hits of a ray"); }
std::vector<Bounds3> Subject::bounds() { unsupported(*this, "bounds"); }
std::vector<SubjectMatrices> Subject::matrices() { unsupported(*this, "matrices"); }
std::vector<Point3> Subject::average_positions() { unsupported(*this, "average positions"); }
double Subject::fresnel(double, double, double) { unsupported(*this, "Fresnel reflectance"); }
std::optional<Vec3> Subject::refract(const Vec3&, const Vec3&, double, double) { unsupported(*this, "refraction"); }
std::array<Vec3, 3> Subject::frame(const Vec3&) { unsupported(*this, "frames"); }

std::vector<std::vector<SubjectHit>> Subject::closest_each(std::span<const Small> questions) {
  std::vector<std::vector<SubjectHit>> answers;
  answers.reserve(questions.size());
  for (const Small& question : questions) {
    load(question.scene);
    answers.push_back(closest(question.rays));
  }
  return answers;
}

}  // namespace plumb
