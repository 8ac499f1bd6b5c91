// PA 3: a ray tracer in one file.
//   g++ -O2 -std=c++17 -pthread -o tracer tracer.cpp
//   ./tracer scene.xml ...        writes scene.xml.png beside each scene
// A scene that cannot be read gives a message on stderr, no picture, and exit status 1.

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <map>
#include <memory>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

using std::string;
using Error = std::runtime_error;
const double kEpsilon = 1e-6;          // rays that leave a surface start this far along
const int kMaxDepth = 12;              // the camera's ray has depth 1
const double kMinContribution = 0.01;  // rays that matter less than this are not traced

// ------------------------------------------------------------------ vectors and matrices
struct Vec {  // a point, a direction or a colour
  double x = 0, y = 0, z = 0;
  double operator[](int i) const { return i == 0 ? x : i == 1 ? y : z; }
  double& operator[](int i) { return i == 0 ? x : i == 1 ? y : z; }
};
Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vec operator-(Vec a) { return {-a.x, -a.y, -a.z}; }
Vec operator*(Vec a, Vec b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
Vec operator*(Vec a, double s) { return {a.x * s, a.y * s, a.z * s}; }
Vec operator/(Vec a, double s) { return {a.x / s, a.y / s, a.z / s}; }
double dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vec cross(Vec a, Vec b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
double length(Vec a) { return std::sqrt(dot(a, a)); }
Vec unit(Vec a) { return a / length(a); }
Vec axis(int i, double value) { Vec v; v[i] = value; return v; }
Vec lowest(Vec a, Vec b) { return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)}; }
Vec highest(Vec a, Vec b) { return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}; }

struct Matrix {  // p -> L p + offset; the columns of L are x, y and z, the images of the axes
  Vec x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, offset;
  Vec vector(Vec v) const { return x * v.x + y * v.y + z * v.z; }
  Vec point(Vec p) const { return vector(p) + offset; }
};
Matrix operator*(const Matrix& a, const Matrix& b) {
  return {a.vector(b.x), a.vector(b.y), a.vector(b.z), a.point(b.offset)};
}
Matrix transposed(const Matrix& m) {  // of the linear part alone
  return {{m.x.x, m.y.x, m.z.x}, {m.x.y, m.y.y, m.z.y}, {m.x.z, m.y.z, m.z.z}, {}};
}
Matrix inverse(const Matrix& m) {
  double det = dot(m.x, cross(m.y, m.z));
  if (det == 0) throw Error("a transformation cannot be inverted");
  Matrix r = transposed({cross(m.y, m.z) / det, cross(m.z, m.x) / det, cross(m.x, m.y) / det, {}});
  r.offset = -r.vector(m.offset);
  return r;
}
Matrix rotation(char about, double degrees) {
  double c = std::cos(degrees * M_PI / 180), s = std::sin(degrees * M_PI / 180);
  if (about == 'x') return {{1, 0, 0}, {0, c, s}, {0, -s, c}, {}};
  if (about == 'y') return {{c, 0, -s}, {0, 1, 0}, {s, 0, c}, {}};
  return {{c, s, 0}, {-s, c, 0}, {0, 0, 1}, {}};
}

// ------------------------------------------------------------------ surfaces
struct Ray {
  Vec origin, direction;  // the direction need not have unit length
  double t_min = kEpsilon, t_max = INFINITY;
};

struct Hit {
  double t = INFINITY;
  Vec normal;  // while surfaces are asked: in object space, of any length
  const struct Surface* surface = nullptr;
};

struct Light { Vec position, intensity; };
struct Shader {  // with an index Glass, or Glazed if there is a substrate; without one Phong or Lambertian
  Vec diffuse{1, 1, 1}, specular{0, 0, 0};
  double exponent = 1, index = 0;
  std::shared_ptr<const Shader> substrate;
};

struct Surface {
  Matrix to_object, normal_to_world;
  std::shared_ptr<const Shader> shader;
  virtual ~Surface() = default;
  virtual void intersect(const Ray& ray, Hit& hit) const = 0;  // all in object space
};

// The part of a ray inside something convex. Parts 0, 1, 2 of its surface are the planes across that
// axis, 3 is the round one; -1 means that the ray's own range is the tighter limit.
struct Span {
  struct Limit { double t; int part; } start, end;
  bool empty = false;
  Span(const Ray& ray, Vec low, Vec high) : start{ray.t_min, -1}, end{ray.t_max, -1} {
    for (int i = 0; i < 3 && !empty; ++i) {  // a ray parallel to a slab gets infinite numbers
      double d = ray.direction[i], near = (low[i] - ray.origin[i]) / d, far = (high[i] - ray.origin[i]) / d;
      if (std::signbit(d)) std::swap(near, far);
      narrow(near, far, i);
    }
  }
  void narrow(double near, double far, int part) {
    if (start.t > far || near > end.t) empty = true;
    if (near > start.t) start = {near, part};
    if (far < end.t) end = {far, part};
  }
};

// What a box and a round body about `center` have in common: the points p with low <= p <= high and
// sum(weight p^2) <= radius^2. A sphere has weight (1, 1, 1), a cylinder (1, 1, 0), a box 0, a cone about its tip
// (1, 1, -slope^2) and radius 0.
// Hit where the ray enters, or where it leaves if it starts inside. There is deliberately no test
// that start <= end: the course's pictures show a box whose minPt lies above its maxPt on some axis
// as the farther of these two planes.
struct Solid : Surface {
  Vec low{-INFINITY, -INFINITY, -INFINITY}, high{INFINITY, INFINITY, INFINITY}, center, weight;
  double radius = 1;
  void intersect(const Ray& ray, Hit& hit) const override {
    Vec o = ray.origin - center, d = ray.direction;
    Ray local{o, d, ray.t_min, ray.t_max};
    double a = dot(weight * d, d), b = dot(weight * o, d), c = dot(weight * o, o) - radius * radius;
    double root = std::sqrt(b * b - a * c), near = (-b - root) / a, far = (-b + root) / a;
    if (a < 0) {  // steep in a cone: inside before the one side and after the other, all the way if there are none
      if (!meet(local, -INFINITY, far, hit)) meet(local, near, INFINITY, hit);
    } else if (!std::isnan(root) && (a != 0 || c <= 0)) {  // else the ray misses, or runs along a cylinder outside
      meet(local, near, far, hit);  // NaN, and no limit, if it runs along it inside
    }
  }
  bool meet(const Ray& ray, double near, double far, Hit& hit) const {  // within the round side from near to far
    Span span(ray, low, high);
    span.narrow(near, far, 3);
    bool enters = span.start.part >= 0;
    auto [t, part] = enters ? span.start : span.end;
    if (span.empty || part < 0) return false;
    double sign = part != 3 && (ray.direction[part] > 0) == enters ? -1 : 1;
    if (t < hit.t) hit = {t, part == 3 ? weight * (ray.origin + ray.direction * t) : axis(part, sign), this};
    return true;
  }
};

struct Mesh : Surface {
  struct Triangle { int place, a, b, c; };  // its place in the file and its vertices
  struct Node {  // of the bounding volume hierarchy, for triangles[first .. last)
    int first, last, right = 0;  // the left child follows its parent; no right child: a leaf
    Vec low{INFINITY, INFINITY, INFINITY}, high{-INFINITY, -INFINITY, -INFINITY};
  };
  std::vector<Vec> vertices, normals;  // no normals: a flat mesh
  std::vector<Triangle> triangles;
  std::vector<Node> nodes;
  // Splits at the median of the centres along the longest side of the node's box.
  void build(int first, int last) {
    Node node{first, last};
    for (int i = first; i < last; ++i)
      for (int v : {triangles[i].a, triangles[i].b, triangles[i].c})
        node.low = lowest(node.low, vertices[v]), node.high = highest(node.high, vertices[v]);
    Vec size = node.high - node.low, pad = Vec{1, 1, 1} * (1e-9 * length(size));
    node.low = node.low - pad, node.high = node.high + pad;  // so that rounding never hides a triangle
    size_t index = nodes.size();
    nodes.push_back(node);
    if (last - first <= 4) return;
    int k = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2), middle = (first + last) / 2;
    auto centre = [&](const Triangle& t) { return vertices[t.a][k] + vertices[t.b][k] + vertices[t.c][k]; };
    auto before = [&](const Triangle& a, const Triangle& b) { return centre(a) < centre(b); };
    std::nth_element(&triangles[first], &triangles[middle], triangles.data() + last, before);
    build(first, middle);
    nodes[index].right = static_cast<int>(nodes.size());
    build(middle, last);
  }
  void intersect(const Ray& ray, Hit& hit) const override {
    int best = -1, stack[64] = {0}, size = 1;  // halving keeps the tree's depth below 32
    while (size > 0) {
      int index = stack[--size];
      const Node& node = nodes[index];
      Span inside(ray, node.low, node.high);
      if (inside.empty || inside.start.t > hit.t) continue;
      if (node.right > 0) stack[size++] = index + 1, stack[size++] = node.right;
      // Solves o + t d = a + beta (b - a) + gamma (c - a) by Cramer's rule in each triangle of a leaf.
      for (int i = node.first; i < node.last && node.right == 0; ++i) {
        auto [place, va, vb, vc] = triangles[i];
        Vec a = vertices[va], edge1 = vertices[vb] - a, edge2 = vertices[vc] - a, o = ray.origin - a;
        Vec p = cross(ray.direction, edge2), q = cross(o, edge1);
        double det = dot(edge1, p), t = dot(edge2, q) / det;
        double beta = dot(o, p) / det, gamma = dot(ray.direction, q) / det;
        if (!(beta >= 0 && gamma >= 0 && beta + gamma <= 1 && t >= ray.t_min && t <= ray.t_max)) continue;
        if (t > hit.t || (t == hit.t && best < place)) continue;  // on a tie the first one wins
        best = place, hit = {t, cross(edge1, edge2), this};
        if (normals.empty()) continue;
        hit.normal = normals[va] * (1 - beta - gamma) + normals[vb] * beta + normals[vc] * gamma;
      }
    }
  }
};

std::shared_ptr<Mesh> readMesh(const string& path) {
  std::ifstream in(path);
  if (!in) throw Error("cannot open the mesh " + path);
  auto number = [&](auto low, auto high) {  // of the type of its limits
    auto v = low;
    if (!(in >> v) || v < low || v >= high) throw Error(path + ": a number is missing or out of range");
    return v;
  };
  const int kMost = 10000000, vertices = number(1, kMost), triangles = number(1, kMost);
  const float kAny = INFINITY;  // 32 bits, as in the course's program: doubles change a pixel of bunny500
  auto vectors = [&] {
    std::vector<Vec> list(vertices);
    for (Vec& v : list) v = {number(-kAny, kAny), number(-kAny, kAny), number(-kAny, kAny)};
    return list;
  };
  auto mesh = std::make_shared<Mesh>();
  for (string word; in >> word;) {
    if (word == "vertices") mesh->vertices = vectors();
    else if (word == "normals") mesh->normals = vectors();
    else if (word == "texcoords") for (int i = 0; i < 2 * vertices; ++i) number(-kAny, kAny);
    else if (word != "triangles") throw Error(path + ": " + word + "?");
    else for (int i = 0; i < triangles; ++i)
      mesh->triangles.push_back({i, number(0, vertices), number(0, vertices), number(0, vertices)});
  }
  if (mesh->vertices.empty() || mesh->triangles.empty()) throw Error(path + ": no triangles");
  mesh->build(0, triangles);
  return mesh;
}

// ------------------------------------------------------------------ scene and shading
// The unpolarised Fresnel reflectance, going from index n1 into n2; sets the refracted cosine.
double fresnel(double cos1, double n1, double n2, double& cos2) {
  double squared = 1 - (n1 / n2) * (n1 / n2) * (1 - cos1 * cos1);
  if (squared < 0) return 1;  // total internal reflection
  cos2 = std::sqrt(squared);
  double parallel = (n2 * cos1 - n1 * cos2) / (n2 * cos1 + n1 * cos2);
  double perpendicular = (n1 * cos1 - n2 * cos2) / (n1 * cos1 + n2 * cos2);
  return (parallel * parallel + perpendicular * perpendicular) / 2;
}

struct Scene {
  Vec eye, ahead, right, up;  // `ahead` leads to the middle of the window, the others along its sides
  int width = 0, height = 0, side = 1;  // side x side samples a pixel
  std::vector<std::shared_ptr<const Surface>> surfaces;  // in the order of the file
  std::vector<Light> lights;
  // The nearest hit, its normal of unit length and in the world; without a surface if there is none.
  Hit intersect(const Ray& ray) const {
    Hit hit;
    for (const auto& s : surfaces)  // the direction keeps its length, so that t is the same in object space
      s->intersect({s->to_object.point(ray.origin), s->to_object.vector(ray.direction), ray.t_min, ray.t_max}, hit);
    if (hit.surface) hit.normal = unit(hit.surface->normal_to_world.vector(hit.normal));
    return hit;
  }
  // `weight` is what this ray's colour is multiplied with before it reaches the picture.
  Vec trace(const Ray& ray, int depth, double weight) const {
    if (depth > kMaxDepth || weight < kMinContribution) return {};
    Hit hit = intersect(ray);
    if (!hit.surface) return {};
    Vec p = ray.origin + ray.direction * hit.t, v = unit(-ray.direction);
    return shade(*hit.surface->shader, p, hit.normal, v, depth, weight);
  }
  // The colour seen from the direction v at the point p with normal n.
  Vec shade(const Shader& s, Vec p, Vec n, Vec v, int depth, double weight) const {
    if (s.index == 0) {
      Vec color;
      for (const Light& light : lights) {
        if (intersect({p, light.position - p, kEpsilon, 1}).surface) continue;  // glass casts a shadow too
        Vec l = unit(light.position - p), h = unit(l + v);
        color = color + s.diffuse * light.intensity * std::max(0.0, dot(n, l)) +
                s.specular * light.intensity * std::pow(std::max(0.0, dot(n, h)), s.exponent);
      }
      return color;
    }
    double n1 = 1, n2 = s.index, cosine = dot(n, v), cos2 = 0;
    if (s.substrate && cosine <= 0) return shade(*s.substrate, p, n, v, depth, weight);
    if (cosine < 0) n = -n, cosine = -cosine, std::swap(n1, n2);  // inside the glass
    double r = fresnel(cosine, n1, n2, cos2), t = 1 - r;  // if t is 0, nothing is refracted: trace drops that ray
    Ray reflected{p, n * (2 * cosine) - v}, refracted{p, n * (n1 / n2 * cosine - cos2) - v * (n1 / n2)};
    if (!s.substrate) return trace(reflected, depth + 1, weight * r) * r + trace(refracted, depth + 1, weight * t) * t;
    Vec below = shade(*s.substrate, p, n, v, depth, weight * t) * t;
    return below + trace(reflected, depth + 1, weight * r) * r;
  }
  // The colour of pixel (x, y), in linear light; row 0 is the bottom one.
  Vec pixel(int x, int y) const {
    Vec sum;
    for (int k = 0; k < side * side; ++k) {
      double u = (x + (k % side + .5) / side) / width - .5, v = (y + (k / side + .5) / side) / height - .5;
      sum = sum + trace({eye, unit(ahead + right * u + up * v)}, 1, 1);
    }
    return sum / (side * side);
  }
};

// ------------------------------------------------------------------ reading scenes
struct Element {
  string tag, type, name, ref, text;  // the tag in lower case, the type without its package
  std::vector<Element> children;
  mutable bool used = false;  // whatever nobody has asked for is a mistake in the scene
  bool is(const string& wanted) const { return tag == wanted && (used = true); }
  Vec numbers(int count) const {
    std::istringstream in(text);
    Vec v;
    for (int i = 0; i < count; ++i) in >> v[i];
    if (!in || !(in >> std::ws).eof()) throw Error("wrong number of numbers in <" + tag + ">");
    return v;
  }
  Vec vec(const string& child, Vec value, int count = 3) const {  // if there are several, the last one wins
    for (const Element& c : children) if (c.is(child)) value = c.numbers(count);
    return value;
  }
  double number(const string& child, double otherwise) const { return vec(child, {otherwise}, 1).x; }
  void check() const {
    for (const Element& c : children)
      if (c.used) c.check(); else throw Error("<" + c.tag + "> is unknown inside <" + tag + ">");
  }
};

// Reads the part of XML that scenes use. An element with `ref` becomes a copy of the one it names.
Element readXml(std::istream& in) {
  static const std::regex kTag(R"((/?)(\w+)((?:\s+\w+\s*=\s*(?:"[^"]*"|'[^']*'))*)\s*(/?))");
  std::vector<Element> open(1);  // the document, then the elements that are not closed yet
  std::map<string, Element> named;
  for (string text, tag; std::getline(in, text, '<') && std::getline(in, tag, '>');) {
    open.back().text += text;
    bool comment = tag.compare(0, 3, "!--") == 0;
    while (comment && tag.substr(tag.size() - 2) != "--" && std::getline(in, text, '>')) tag += ">" + text;
    if (comment || tag[0] == '?') continue;
    std::smatch part, found;
    if (!std::regex_match(tag, part, kTag)) throw Error("cannot read <" + tag.substr(0, 40) + ">");
    auto attribute = [&](const string& key) {
      return std::regex_search(tag, found, std::regex("\\s" + key + "\\s*=\\s*[\"']([^\"']*)")) ? found.str(1) : "";
    };
    Element e;
    for (char c : part.str(2)) e.tag += static_cast<char>(std::tolower(c));
    if (part.length(1) == 0) {
      e.type = attribute("type"), e.name = attribute("name"), e.ref = attribute("ref");
      e.type = e.type.substr(e.type.rfind('.') + 1);
      open.push_back(e);
      if (part.length(4) == 0) continue;
    }
    if (open.back().tag != e.tag) throw Error("</" + e.tag + "> closes another element");
    e = open.back(), open.pop_back();
    if (!e.ref.empty() && !named.count(e.ref)) throw Error("nothing before has the name '" + e.ref + "'");
    if (string own = e.tag; !e.ref.empty()) e = named[e.ref], e.tag = own;
    if (!e.name.empty()) named[e.name] = e;
    open.back().children.push_back(e);
  }
  if (open.size() != 1 || open[0].children.size() != 1) throw Error("an element is not closed");
  return open[0].children[0];
}

using ShaderPointer = std::shared_ptr<const Shader>;
ShaderPointer readShader(const Element& e) {
  auto s = std::make_shared<Shader>();
  bool phong = e.type == "Phong", glazed = e.type == "Glazed";
  if (phong || e.type == "Lambertian") s->diffuse = e.vec("diffusecolor", {1, 1, 1});
  else if (!glazed && e.type != "Glass") throw Error("a shader of unknown type '" + e.type + "'");
  else if (!((s->index = e.number("refractiveindex", 0)) > 0)) throw Error("a refractiveIndex above 0 is needed");
  if (phong) s->specular = e.vec("specularcolor", {1, 1, 1}), s->exponent = e.number("exponent", 1);
  for (const Element& c : e.children) if (glazed && c.is("substrate")) s->substrate = readShader(c);
  if (glazed && !s->substrate) throw Error("a Glazed shader needs a substrate");
  return s;
}

std::shared_ptr<Surface> readShape(const Element& e, const string& folder) {
  if (e.type == "Mesh") {
    string name;
    for (const Element& c : e.children) if (c.is("data")) std::istringstream(c.text) >> name;
    return readMesh(folder + name);
  }
  auto solid = std::make_shared<Solid>();
  if (e.type == "Box") {
    solid->low = e.vec("minpt", {}), solid->high = e.vec("maxpt", {});
    return solid;
  }
  double half = e.type == "Sphere" ? INFINITY : e.number("height", 1) / 2;
  solid->center = e.vec("center", {}), solid->radius = e.number("radius", 1);
  solid->low.z = -half, solid->high.z = half, solid->weight = {1, 1, e.type == "Sphere" ? 1.0 : 0.0};
  bool known = e.type == "Sphere" || e.type == "Cylinder" || e.type == "Cone";
  if (!known) throw Error("a surface of unknown type '" + e.type + "'");
  if (solid->radius < 0 || half < 0) throw Error("a radius or a height is negative");
  if (e.type == "Cone") {
    double above = solid->center.z - e.number("tipz", 0);  // of the tip, which takes the place of the centre
    if (above == 0) throw Error("a cone's tip lies at its centre");
    solid->weight.z = -std::pow(solid->radius / above, 2), solid->radius = 0;
    solid->center.z -= above, solid->low.z += above, solid->high.z += above;
  }
  return solid;
}

// Adds the surface, or all that are in the group, to the scene.
void readSurface(const Element& e, Matrix world, ShaderPointer shader, const string& folder, Scene& scene) {
  for (const Element& c : e.children) if (c.is("shader")) shader = readShader(c);
  if (e.type == "Group") {  // first all transformations, the first in the file outermost
    for (const Element& c : e.children) {
      Vec v = c.is("translate") || c.is("rotate") || c.is("scale") ? c.numbers(3) : Vec{};
      if (c.is("translate")) world = world * Matrix{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, v};
      if (c.is("rotate")) world = world * rotation('z', v.z) * rotation('y', v.y) * rotation('x', v.x);
      if (c.is("scale")) world = world * Matrix{{v.x, 0, 0}, {0, v.y, 0}, {0, 0, v.z}, {}};
    }
    for (const Element& c : e.children) if (c.is("surface")) readSurface(c, world, shader, folder, scene);
    return;
  }
  auto surface = readShape(e, folder);
  surface->to_object = inverse(world);
  surface->normal_to_world = transposed(surface->to_object);
  surface->shader = shader;
  scene.surfaces.push_back(surface);
}

void readCamera(const Element& e, Scene& scene) {
  Vec gaze = e.vec("viewdir", {0, 0, -1}), normal = e.vec("projnormal", gaze), up = e.vec("viewup", {0, 1, 0});
  if (dot(normal, gaze) == 0) throw Error("projNormal is perpendicular to viewDir");
  if (length(cross(up, normal)) == 0) throw Error("viewUp is parallel to projNormal");
  Vec w = unit(dot(normal, gaze) > 0 ? -normal : normal), u = unit(cross(up, w));
  scene.eye = e.vec("viewpoint", {}), scene.ahead = unit(gaze) * e.number("projdistance", 1);
  scene.right = u * e.number("viewwidth", 1), scene.up = cross(w, u) * e.number("viewheight", 1);
}

Scene readScene(const string& path) {
  std::ifstream in(path);
  if (!in) throw Error("cannot open it");
  const Element e = readXml(in);
  Scene scene;
  Vec size = e.vec("image", {}, 2);
  if (e.tag != "scene" || size.x < 1 || size.y < 1 || size.x > 1e5 || size.y > 1e5)
    throw Error("a <scene> with an <image> of 1 to 100000 pixels a side is expected");
  scene.width = static_cast<int>(size.x), scene.height = static_cast<int>(size.y);
  scene.side = std::max(1, static_cast<int>(std::lround(std::sqrt(e.number("samples", 1)))));
  readCamera({}, scene);  // the defaults
  for (const Element& c : e.children) {
    if (c.is("camera")) readCamera(c, scene);
    if (c.is("shader")) readShader(c);  // only to find its mistakes
    if (c.is("light")) scene.lights.push_back({c.vec("position", {}), c.vec("intensity", c.vec("color", {1, 1, 1}))});
    if (c.is("surface")) readSurface(c, {}, std::make_shared<Shader>(), path.substr(0, path.rfind('/') + 1), scene);
  }
  e.check();
  return scene;
}

// ------------------------------------------------------------------ pictures
string bigEndian(unsigned v) { return {char(v >> 24), char(v >> 16), char(v >> 8), char(v)}; }
string chunk(const string& body) {  // of a PNG file: length, name and data, checksum
  unsigned crc = ~0u;
  for (unsigned char byte : body) {
    crc ^= byte;
    for (int k = 0; k < 8; ++k) crc = crc & 1 ? 0xedb88320u ^ (crc >> 1) : crc >> 1;
  }
  return bigEndian(static_cast<unsigned>(body.size() - 4)) + body + bigEndian(~crc);
}

// `rows` are the rows from the top, each a 0 (no filter) and its pixels. Stored, not compressed.
void writePng(const string& path, int width, int height, const string& rows) {
  string zlib = "\x78\x01";
  unsigned a = 1, b = 0;
  for (unsigned char byte : rows) a = (a + byte) % 65521, b = (b + a) % 65521;
  for (size_t at = 0; at < rows.size(); at += 65535) {
    size_t n = std::min<size_t>(65535, rows.size() - at);
    zlib += string{char(at + n == rows.size()), char(n), char(n >> 8), char(~n), char(~n >> 8)} + rows.substr(at, n);
  }
  std::ofstream out(path, std::ios::binary);
  out << "\x89PNG\r\n\x1a\n"
      << chunk("IHDR" + bigEndian(width) + bigEndian(height) + string("\x08\x02\0\0\0", 5))
      << chunk("IDAT" + zlib + bigEndian(b << 16 | a)) << chunk("IEND");
  if (!out.flush()) throw Error("cannot write " + path);
}

void render(const Scene& scene, const string& path) {
  const size_t stride = 1 + 3 * static_cast<size_t>(scene.width);
  string rows(stride * scene.height, '\0');
  const int count = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  auto work = [&](int first) {  // every `count`th row
    for (int row = first; row < scene.height; row += count)
      for (int x = 0; x < scene.width; ++x) {
        Vec color = scene.pixel(x, scene.height - 1 - row);
        for (int k : {0, 1, 2}) {
          auto c = static_cast<float>(std::min(1.0, std::pow(std::max(0.0, color[k]), 1 / 2.2)));
          rows[row * stride + 1 + 3 * x + k] = static_cast<char>(static_cast<int>(255.0 * c + .5));
        }
      }
  };
  std::vector<std::thread> threads;
  for (int i = 0; i < count; ++i) threads.emplace_back(work, i);
  for (std::thread& t : threads) t.join();
  writePng(path, scene.width, scene.height, rows);
}

int main(int argc, char** argv) {
  int status = argc > 1 ? 0 : 1;
  for (string path : std::vector<string>(argv + 1, argv + argc)) try {
    render(readScene(path), path + ".png");
  } catch (const std::exception& e) {
    std::cerr << path << ": " << e.what() << "\n";
    status = 1;
  }
  return status;
}
