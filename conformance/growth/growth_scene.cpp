#include "conformance/growth/growth_scene.h"

#include <fmt/format.h>

#include <cmath>

#include "conformance/families/random.h"

namespace plumb {
namespace {

constexpr double kDistance = 4;
/// A ball of radius 1 at that distance fills it but for its corners.
constexpr double kWindow = 0.4375;
/// The strip's pixels are narrower than high: it shows a thin slice of the scene, seen from its middle.
constexpr double kStripWindow = 0.0625;

double dyadic(double value) { return std::nearbyint(value * 4096) / 4096; }

GrowthCamera oblique_camera(Random& random) {
  // No component near 0, so that the view is well in between the axes.
  const auto component = [&] {
    const double size = random.between(0.4, 1);
    return size * random.sign();
  };
  const double x = component(), y = component(), z = component();
  const Vec3 out = normalized(Vec3{x, y, z});
  const Vec3 eye{dyadic(kDistance * out.x), dyadic(kDistance * out.y), dyadic(kDistance * out.z)};
  const double dx = random.between(-0.1, 0.1), dy = random.between(-0.1, 0.1), dz = random.between(-0.1, 0.1);
  const Vec3 target{dyadic(dx), dyadic(dy), dyadic(dz)};
  return {{eye.x, eye.y, eye.z}, target - eye, {0, 1, 0}, kWindow, kWindow};
}

GrowthCamera axis_aligned_camera(Random& random) {
  const int axis = random.integer(0, 2);
  const double side = random.sign();
  GrowthCamera camera{.eye = {}, .direction = {}, .up = {}, .view_width = kStripWindow, .view_height = kWindow};
  Vec3 eye;
  eye[axis] = side * kDistance;
  eye[(axis + 1) % 3] = dyadic(random.between(-0.25, 0.25));
  eye[(axis + 2) % 3] = dyadic(random.between(-0.25, 0.25));
  camera.eye = {eye.x, eye.y, eye.z};
  camera.direction[axis] = -side;
  camera.up[(axis + 1) % 3] = 1;
  return camera;
}

template <class Triple>
void add_triple(GrowthNames& names, const std::string& name, const Triple& v) {
  names[name] = fmt::format("{} {} {}", v.x, v.y, v.z);
  names[name + "_x"] = fmt::format("{}", v.x);
  names[name + "_y"] = fmt::format("{}", v.y);
  names[name + "_z"] = fmt::format("{}", v.z);
}

}  // namespace

GrowthCamera growth_camera(GrowthView view, int round, std::uint64_t seed) {
  Random random(seed, view == GrowthView::oblique ? "growth-oblique" : "growth-axis",
                static_cast<std::uint64_t>(round));
  return view == GrowthView::oblique ? oblique_camera(random) : axis_aligned_camera(random);
}

GrowthNames camera_names(const GrowthCamera& camera, int width, int height) {
  GrowthNames names{{"width", fmt::format("{}", width)},
                    {"height", fmt::format("{}", height)},
                    {"view_width", fmt::format("{}", camera.view_width)},
                    {"view_height", fmt::format("{}", camera.view_height)}};
  add_triple(names, "eye", camera.eye);
  add_triple(names, "direction", camera.direction);
  add_triple(names, "up", camera.up);
  return names;
}

GrowthNames ball_names(const GrowthBall& ball) {
  return {{"center", fmt::format("{} {} {}", ball.center.x, ball.center.y, ball.center.z)},
          {"x", fmt::format("{}", ball.center.x)},
          {"y", fmt::format("{}", ball.center.y)},
          {"z", fmt::format("{}", ball.center.z)},
          {"radius", fmt::format("{}", ball.radius)}};
}

std::string filled_template(std::string_view text, const GrowthNames& names) {
  std::string filled;
  for (;;) {
    const std::size_t open = text.find('{');
    const std::size_t close = open == std::string_view::npos ? open : text.find('}', open);
    if (close == std::string_view::npos) return filled.append(text);
    const auto known = names.find(text.substr(open + 1, close - open - 1));
    filled.append(text.substr(0, open));
    filled.append(known == names.end() ? "{" : known->second);
    text.remove_prefix(known == names.end() ? open + 1 : close + 1);
  }
}

}  // namespace plumb
