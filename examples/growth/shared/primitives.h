// What a search is given, and what it answers.
#pragma once

#include <cmath>
#include <utility>
#include <vector>

struct Vec {  // a point, a direction or a colour
  double x = 0, y = 0, z = 0;
  double operator[](int i) const { return i == 0 ? x : i == 1 ? y : z; }
};
inline Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec operator*(Vec a, Vec b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
inline Vec operator*(Vec a, double s) { return {a.x * s, a.y * s, a.z * s}; }
inline double dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec cross(Vec a, Vec b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
inline Vec unit(Vec a) { return a * (1 / std::sqrt(dot(a, a))); }
inline Vec lowest(Vec a, Vec b) { return {std::fmin(a.x, b.x), std::fmin(a.y, b.y), std::fmin(a.z, b.z)}; }
inline Vec highest(Vec a, Vec b) { return {std::fmax(a.x, b.x), std::fmax(a.y, b.y), std::fmax(a.z, b.z)}; }

struct Ray {
  Vec origin, direction, inverse;  // 1 / direction; infinite where that is 0
  double t_min = 1e-6;
  Ray(Vec o, Vec d) : origin(o), direction(d), inverse{1 / d.x, 1 / d.y, 1 / d.z} {}
};

struct Primitive;
struct Hit {
  double t = INFINITY;  // at first the end of the ray
  const Primitive* primitive = nullptr;
  double beta = 0, gamma = 0;  // weights of a triangle's second and third corner
};

struct Box {
  Vec low{INFINITY, INFINITY, INFINITY}, high{-INFINITY, -INFINITY, -INFINITY};
  void add(Vec p) { low = lowest(low, p), high = highest(high, p); }
  void add(const Box& b) { low = lowest(low, b.low), high = highest(high, b.high); }
  Vec size() const { return high - low; }
  // Where the ray enters, or INFINITY if it does not before `end`. A ray within the plane of a side makes
  // 0 * inf = NaN, and all comparisons below are then false: such a side is no limit.
  double entry(const Ray& ray, double end) const {
    double start = ray.t_min;
    auto narrow = [&](double near, double far, double inverse) {
      if (inverse < 0) std::swap(near, far);
      if (near > start) start = near;
      if (far < end) end = far;
    };
    narrow((low.x - ray.origin.x) * ray.inverse.x, (high.x - ray.origin.x) * ray.inverse.x, ray.inverse.x);
    narrow((low.y - ray.origin.y) * ray.inverse.y, (high.y - ray.origin.y) * ray.inverse.y, ray.inverse.y);
    narrow((low.z - ray.origin.z) * ray.inverse.z, (high.z - ray.origin.z) * ray.inverse.z, ray.inverse.z);
    return start <= end ? start : INFINITY;
  }
};

struct Primitive {      // a sphere, or a triangle: radius < 0
  Vec a, edge1, edge2;  // a sphere's centre; a triangle's first corner, and from there to the others
  double radius = -1;
  int place = 0, object = 0;  // among all primitives, and the surface that it is of

  Box box() const {
    Box b;
    if (radius >= 0)
      b.add(a - Vec{radius, radius, radius}), b.add(a + Vec{radius, radius, radius});
    else
      b.add(a), b.add(a + edge1), b.add(a + edge2);
    return b;
  }
  Vec centre() const { return radius >= 0 ? a : a + (edge1 + edge2) * (1 / 3.0); }
  void intersect(const Ray& ray, Hit& hit) const {
    const Vec o = ray.origin - a, d = ray.direction;
    if (radius >= 0) {
      const double aa = dot(d, d), b = dot(o, d), root = std::sqrt(b * b - aa * (dot(o, o) - radius * radius));
      offer(ray, hit, (-b - root) / aa, 0, 0) || offer(ray, hit, (-b + root) / aa, 0, 0);  // NaN if it misses
      return;
    }
    // o + t d = beta edge1 + gamma edge2 by Cramer's rule
    const Vec p = cross(d, edge2), q = cross(o, edge1);
    const double f = 1 / dot(edge1, p), beta = dot(o, p) * f, gamma = dot(d, q) * f;
    if (beta >= 0 && gamma >= 0 && beta + gamma <= 1) offer(ray, hit, dot(edge2, q) * f, beta, gamma);
  }

 private:
  bool offer(const Ray& ray, Hit& hit, double t, double beta, double gamma) const {
    if (!(t >= ray.t_min && t <= hit.t)) return false;
    if (t == hit.t && hit.primitive && hit.primitive->place < place) return false;  // on a tie the first one wins
    hit = {t, this, beta, gamma};
    return true;
  }
};
