#include "reports/pareto_csv.h"

#include <fmt/format.h>

#include <functional>

namespace plumb {
namespace {

/// Lines of fields, the same number in each.
class Csv {
 public:
  template <class... Fields>
  void line(const Fields&... fields) {
    std::string separator;
    ((text_ += separator + field(fields), separator = ","), ...);
    text_ += "\n";
  }
  std::string take() && { return std::move(text_); }

 private:
  static std::string field(const std::string& text) { return csv_field(text); }
  static std::string field(const char* text) { return csv_field(text); }
  /// The shortest text that reads back to the same number.
  template <class Number>
  static std::string field(Number number) {
    return fmt::format("{}", number);
  }

  std::string text_;
};

using KernelLine = std::function<void(const char* surface, const ParetoKernel& kernel)>;

void for_each_kernel(const ParetoResults& results, const KernelLine& line) {
  for (const ParetoKernel& kernel : results.triangles) line("triangle", kernel);
  for (const ParetoKernel& kernel : results.spheres) line("sphere", kernel);
}

std::string kernels_csv(const ParetoResults& results) {
  Csv csv;
  csv.line("surface", "kernel", "inputs", "description", "rays", "rounds", "million_rays_a_second", "slowest",
           "fastest");
  for_each_kernel(results, [&](const char* surface, const ParetoKernel& k) {
    csv.line(surface, k.name, k.inputs, k.description, k.speed.rays, k.speed.rounds, k.speed.million_rays_a_second,
             k.speed.slowest, k.speed.fastest);
  });
  return std::move(csv).take();
}

std::string run_csv(const ParetoResults& results) {
  Csv csv;
  csv.line("what", "value");
  csv.line("plumb_version", results.plumb_version);
  csv.line("processor", results.processor);
  csv.line("seed", results.seed);
  csv.line("intensity", results.intensity);
  csv.line("empty_cpu_nanoseconds_a_ray", results.empty_cpu_nanoseconds);
  csv.line("empty_clock_nanoseconds_a_ray", results.empty_clock_nanoseconds);
  csv.line("triangle_scene", results.triangle_scene);
  csv.line("sphere_scene", results.sphere_scene);
  for (const std::string& note : results.notes) csv.line("note", note);
  return std::move(csv).take();
}

std::string class_csv(const ParetoResults& results) {
  Csv csv;
  csv.line("surface", "kernel", "inputs", "million_rays_a_second", "family", "name", "rays", "left_out", "false_misses",
           "false_hits", "wrong_crossings", "not_finite", "wrong_per_million", "bound_of_none_per_million",
           "farthest_u", "right_hits", "t_ulps_median", "t_ulps_p99");
  for_each_kernel(results, [&](const char* surface, const ParetoKernel& k) {
    for (const ClassFigure& f : k.classes)
      csv.line(surface, k.name, k.inputs, k.speed.million_rays_a_second, f.family, f.name, f.rays, f.left_out,
               f.false_misses, f.false_hits, f.wrong_crossings, f.not_finite, f.wrong().per_million(),
               f.wrong().bound_per_million(), f.farthest_u, f.right_hits, f.t_ulps_median, f.t_ulps_p99);
  });
  return std::move(csv).take();
}

std::string escapes_csv(const ParetoResults& results) {
  Csv csv;
  csv.line("kernel", "inputs", "million_rays_a_second", "aim", "meshes", "rays", "escapes", "escapes_per_million",
           "bound_of_none_per_million", "median_u", "farthest_u", "worst_mesh");
  for (const ParetoKernel& k : results.triangles)
    for (const EscapeFigure& f : k.escapes)
      csv.line(k.name, k.inputs, k.speed.million_rays_a_second, f.aim, f.meshes, f.rays, f.escapes,
               f.rate().per_million(), f.rate().bound_per_million(), f.median_u, f.farthest_u, f.worst_mesh);
  return std::move(csv).take();
}

std::string closest_csv(const ParetoResults& results) {
  Csv csv;
  csv.line("kernel", "inputs", "million_rays_a_second", "scene", "aim", "rays", "ties", "missed", "beside", "behind",
           "wrong_per_million", "bound_of_none_per_million", "farthest_u", "farthest_ulps");
  for (const ParetoKernel& k : results.triangles)
    for (const ClosestFigure& f : k.closest)
      csv.line(k.name, k.inputs, k.speed.million_rays_a_second, f.scene, f.aim, f.rays, f.ties, f.missed, f.beside,
               f.behind, f.wrong().per_million(), f.wrong().bound_per_million(), f.farthest_u, f.farthest_ulps);
  return std::move(csv).take();
}

std::string pictures_csv(const ParetoResults& results) {
  Csv csv;
  csv.line("scene", "width", "height", "samples", "reference_samples", "rms", "largest", "cpu_seconds");
  for (const PictureFigure& f : results.pictures)
    csv.line(f.scene, f.width, f.height, f.samples, f.reference_samples, f.rms, f.largest, f.cpu_seconds);
  return std::move(csv).take();
}

}  // namespace

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + "\"";
}

std::vector<ReportFile> pareto_csv(const ParetoResults& results) {
  return {{"run.csv", run_csv(results)},         {"kernels.csv", kernels_csv(results)},
          {"class.csv", class_csv(results)},     {"escapes.csv", escapes_csv(results)},
          {"closest.csv", closest_csv(results)}, {"pictures.csv", pictures_csv(results)}};
}

}  // namespace plumb
