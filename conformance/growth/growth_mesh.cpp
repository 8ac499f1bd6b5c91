#include "conformance/growth/growth_mesh.h"

#include <cmath>
#include <map>

#include "conformance/families/random.h"

namespace plumb {
namespace {

/// Each face of a cube in so many squares, each of two triangles.
constexpr int kSquares = 10;

double rounded(double value, double unit) { return std::nearbyint(value / unit) * unit; }

class Ball {
 public:
  explicit Ball(std::uint64_t seed) : random_(seed, "growth-mesh", 0) {}

  TriangleMesh make() {
    for (int axis = 0; axis < 3; ++axis)
      for (const int side : {0, kSquares}) face(axis, side);
    return std::move(mesh_);
  }

 private:
  using Corner = std::array<int, 3>;

  void face(int axis, int side) {
    const auto at = [&](int i, int j) {
      Corner corner{};
      corner[static_cast<std::size_t>(axis)] = side;
      corner[static_cast<std::size_t>((axis + 1) % 3)] = i;
      corner[static_cast<std::size_t>((axis + 2) % 3)] = j;
      return vertex(corner);
    };
    for (int i = 0; i < kSquares; ++i) {
      for (int j = 0; j < kSquares; ++j) {
        const std::uint32_t a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
        if (side == 0)  // seen from outside the other way around
          mesh_.triangles.insert(mesh_.triangles.end(), {{a, c, b}, {a, d, c}});
        else
          mesh_.triangles.insert(mesh_.triangles.end(), {{a, b, c}, {a, c, d}});
      }
    }
  }

  std::uint32_t vertex(const Corner& corner) {
    const auto [found, is_new] = known_.try_emplace(corner, static_cast<std::uint32_t>(mesh_.positions.size()));
    if (is_new) {
      const auto coordinate = [](int i) { return 2.0 * i / kSquares - 1; };
      const Vec3 out = normalized(Vec3{coordinate(corner[0]), coordinate(corner[1]), coordinate(corner[2])});
      const double radius = random_.between(0.9, 1.15);
      const double x = random_.between(-0.5, 0.5), y = random_.between(-0.5, 0.5), z = random_.between(-0.5, 0.5);
      constexpr double kUnit = 0x1p-12;
      mesh_.positions.push_back(
          {rounded(radius * out.x, kUnit), rounded(radius * out.y, kUnit), rounded(radius * out.z, kUnit)});
      mesh_.normals.push_back({rounded(out.x + x, kUnit), rounded(out.y + y, kUnit), rounded(out.z + z, kUnit)});
    }
    return found->second;
  }

  Random random_;
  TriangleMesh mesh_;
  std::map<Corner, std::uint32_t> known_;
};

}  // namespace

TriangleMesh growth_mesh(std::uint64_t seed) { return Ball(seed).make(); }

std::vector<GrowthBall> growth_balls(double count, std::uint64_t seed) {
  const int side = static_cast<int>(std::lround(std::cbrt(count)));
  const double cell = 2.0 / side;
  Random random(seed, "growth-balls", static_cast<std::uint64_t>(side));
  std::vector<GrowthBall> balls;
  for (int i = 0; i < side * side * side; ++i) {
    const auto coordinate = [&](int k) { return rounded(-1 + cell * (k + 0.5 + random.between(-0.1, 0.1)), 0x1p-20); };
    const double x = coordinate(i % side), y = coordinate(i / side % side), z = coordinate(i / side / side);
    balls.push_back({{x, y, z}, rounded(cell * random.between(0.25, 0.38), 0x1p-20)});
  }
  return balls;
}

}  // namespace plumb
