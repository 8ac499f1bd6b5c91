// PA 3: a ray tracer in one file.
//   g++ -O2 -std=c++17 -pthread -o tracer tracer.cpp
//   ./tracer scene.xml ...        writes scene.xml.png beside each scene
// A scene that cannot be read gives a message on stderr, no picture, and exit status 1.
//
// THIS COPY IS WRONG ON PURPOSE. Its two planted faults, otherwise it is ../cpp-correct:
//   1. normals are transformed by the matrix M itself instead of its inverse transpose;
//   2. the Glazed shader weights the reflection with 1 - R instead of R.

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
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
Vec cross(Vec a, Vec b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double length(Vec a) { return std::sqrt(dot(a, a)); }
Vec unit(Vec a) { return a / length(a); }
Vec axis(int i, double value) { Vec v; v[i] = value; return v; }

struct Matrix {  // p -> L p + offset; the columns of L are the images of the axes
  Vec column[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  Vec offset;
  Vec vector(Vec v) const { return column[0] * v.x + column[1] * v.y + column[2] * v.z; }
  Vec point(Vec p) const { return vector(p) + offset; }
};
Matrix operator*(const Matrix& a, const Matrix& b) {
  return {{a.vector(b.column[0]), a.vector(b.column[1]), a.vector(b.column[2])}, a.point(b.offset)};
}
Matrix transposed(const Matrix& m) {  // of the linear part alone
  const Vec* c = m.column;
  return {{{c[0].x, c[1].x, c[2].x}, {c[0].y, c[1].y, c[2].y}, {c[0].z, c[1].z, c[2].z}}, {}};
}
Matrix inverse(const Matrix& m) {
  const Vec* c = m.column;
  double det = dot(c[0], cross(c[1], c[2]));
  if (det == 0) throw Error("a transformation cannot be inverted");
  Matrix r = transposed({{cross(c[1], c[2]) / det, cross(c[2], c[0]) / det, cross(c[0], c[1]) / det}, {}});
  r.offset = -r.vector(m.offset);
  return r;
}
Matrix rotation(int about, double degrees) {
  double angle = degrees * M_PI / 180, c = std::cos(angle), s = std::sin(angle);
  int j = (about + 1) % 3, k = (about + 2) % 3;
  Matrix m;
  m.column[j] = axis(j, c) + axis(k, s);
  m.column[k] = axis(j, -s) + axis(k, c);
  return m;
}

// ------------------------------------------------------------------ surfaces

struct Ray {
  Vec origin, direction;  // the direction need not have unit length
  double t_min = kEpsilon, t_max = INFINITY;
};

struct Hit {
  double t = INFINITY;
  Vec normal;  // as `intersect` leaves it: in object space, of any length
  // Takes the root t if it lies in the ray's range and before the root taken so far.
  void offer(const Ray& ray, double root, Vec n) {
    if (root >= ray.t_min && root <= ray.t_max && root < t) t = root, normal = n;
  }
};

struct Shader;
struct Surface {
  Matrix to_object, normal_to_world;
  std::shared_ptr<const Shader> shader;
  virtual ~Surface() = default;
  virtual void intersect(const Ray& ray, Hit& hit) const = 0;  // all in object space
};

// x^2 + y^2 = constant + factor z^2 about `center`, capped by the planes z = bottom and z = top.
// Sphere: r^2 - z^2, no caps. Cylinder: r^2. Cone, seen from its tip: (r / r's distance)^2 z^2.
struct Quadric : Surface {
  Vec center;
  double constant = 1, factor = 0, bottom = -INFINITY, top = INFINITY;
  void intersect(const Ray& ray, Hit& hit) const override {
    Vec o = ray.origin - center, d = ray.direction;
    double a = d.x * d.x + d.y * d.y - factor * d.z * d.z;
    double b = o.x * d.x + o.y * d.y - factor * o.z * d.z;
    double c = o.x * o.x + o.y * o.y - factor * o.z * o.z - constant;
    double root = std::sqrt(b * b - a * c);  // NaN if the ray misses: NaN is never in range
    for (double t : {a == 0 ? -c / (2 * b) : (-b - root) / a, (-b + root) / a}) {
      Vec p = o + d * t;
      if (p.z >= bottom && p.z <= top) hit.offer(ray, t, {p.x, p.y, -factor * p.z});
    }
    for (double z : {bottom, top}) {
      double t = (z - o.z) / d.z;
      Vec p = o + d * t, outward{0, 0, z == top ? 1.0 : -1.0};
      if (p.x * p.x + p.y * p.y <= constant + factor * z * z) hit.offer(ray, t, outward);
    }
  }
};

// The part of a ray inside an axis-parallel box, by slabs; an axis is -1 where the ray's own range
// is the tighter limit.
struct Slabs {
  double start, end;
  int start_axis = -1, end_axis = -1;
  bool hit = true;
  Slabs(Vec low, Vec high, const Ray& ray) : start(ray.t_min), end(ray.t_max) {
    for (int i = 0; i < 3; ++i) {  // a ray parallel to a slab gets infinite numbers
      double d = ray.direction[i], near = (low[i] - ray.origin[i]) / d, far = (high[i] - ray.origin[i]) / d;
      if (std::signbit(d)) std::swap(near, far);
      if (start > far || near > end) { hit = false; return; }
      if (near > start) start = near, start_axis = i;
      if (far < end) end = far, end_axis = i;
    }
  }
};

// Hit where the ray enters, or where it leaves if it starts inside. There is deliberately no test
// that start <= end: the course's pictures show a box whose minPt lies above its maxPt on some axis
// as the farther of these two planes.
struct Box : Surface {
  Vec low, high;
  void intersect(const Ray& ray, Hit& hit) const override {
    Slabs s(low, high, ray);
    if (!s.hit) return;
    if (int i = s.start_axis; i >= 0) hit.offer(ray, s.start, axis(i, ray.direction[i] > 0 ? -1 : 1));
    else if (i = s.end_axis; i >= 0) hit.offer(ray, s.end, axis(i, ray.direction[i] > 0 ? 1 : -1));
  }
};

struct Mesh : Surface {
  struct Triangle { int a, b, c; };
  struct Node {  // of the bounding volume hierarchy; order[first .. last) are its triangles
    Vec low{INFINITY, INFINITY, INFINITY}, high{-INFINITY, -INFINITY, -INFINITY};
    int first = 0, last = 0, left = -1, right = -1;
  };
  std::vector<Vec> vertices, normals;  // no normals: a flat mesh
  std::vector<Triangle> triangles;
  std::vector<Node> nodes;
  std::vector<int> order;

  // Splits at the median of the centres along the longest side of the node's box.
  int build(int first, int last) {
    Node node;
    for (int i = node.first = first; i < (node.last = last); ++i)
      for (int v : {triangles[order[i]].a, triangles[order[i]].b, triangles[order[i]].c})
        for (int k = 0; k < 3; ++k) {
          node.low[k] = std::min(node.low[k], vertices[v][k]);
          node.high[k] = std::max(node.high[k], vertices[v][k]);
        }
    Vec size = node.high - node.low;
    double pad = 1e-9 * length(size);  // so that rounding never hides a triangle behind its box
    node.low = node.low - Vec{pad, pad, pad}, node.high = node.high + Vec{pad, pad, pad};
    int index = static_cast<int>(nodes.size()), middle = (first + last) / 2;
    nodes.push_back(node);
    if (last - first <= 4) return index;
    int k = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    auto centre = [&](int i) {
      return vertices[triangles[i].a][k] + vertices[triangles[i].b][k] + vertices[triangles[i].c][k];
    };
    std::nth_element(&order[first], &order[middle], order.data() + last,
                     [&](int i, int j) { return centre(i) < centre(j); });
    int left = build(first, middle), right = build(middle, last);
    nodes[index].left = left, nodes[index].right = right;
    return index;
  }

  void intersect(const Ray& ray, Hit& hit) const override {
    int best = -1, stack[64] = {0}, size = 1;  // halving keeps the tree's depth below 32
    while (size > 0) {
      const Node& node = nodes[stack[--size]];
      Slabs s(node.low, node.high, ray);
      if (!s.hit || s.start > hit.t) continue;
      if (node.left >= 0) {
        stack[size++] = node.left, stack[size++] = node.right;
        continue;
      }
      // Solves o + t d = a + beta (b - a) + gamma (c - a) by Cramer's rule.
      for (int i = node.first; i < node.last; ++i) {
        auto [va, vb, vc] = triangles[order[i]];
        Vec a = vertices[va], edge1 = vertices[vb] - a, edge2 = vertices[vc] - a, o = ray.origin - a;
        Vec p = cross(ray.direction, edge2), q = cross(o, edge1);
        double det = dot(edge1, p), t = dot(edge2, q) / det;
        double beta = dot(o, p) / det, gamma = dot(ray.direction, q) / det;
        if (!(beta >= 0 && gamma >= 0 && beta + gamma <= 1 && t >= ray.t_min && t <= ray.t_max)) continue;
        if (t > hit.t || (t == hit.t && best < order[i])) continue;  // on a tie the first one wins
        hit.t = t, best = order[i], hit.normal = cross(edge1, edge2);
        if (normals.empty()) continue;
        hit.normal = normals[va] * (1 - beta - gamma) + normals[vb] * beta + normals[vc] * gamma;
      }
    }
  }
};

std::shared_ptr<Mesh> readMesh(const string& path) {
  std::ifstream in(path);
  if (!in) throw Error("cannot open the mesh " + path);
  auto mesh = std::make_shared<Mesh>();
  auto number = [&] {
    float v;  // 32 bits, as in the course's program: doubles change a pixel of bunny500
    if (!(in >> v)) throw Error(path + ": a number is missing");
    return v;
  };
  auto vectors = [&](int count, std::vector<Vec> list = {}) {
    for (; count > 0; --count) { Vec v; for (int k : {0, 1, 2}) v[k] = number(); list.push_back(v); }
    return list;
  };
  auto integer = [&](int low, int high) {
    int v;
    if (!(in >> v) || v < low || v >= high) throw Error(path + ": a wrong count or index");
    return v;
  };
  int vertices = integer(1, 1 << 30), triangles = integer(1, 1 << 30);
  for (string word; in >> word;) {
    if (word == "vertices") mesh->vertices = vectors(vertices);
    else if (word == "normals") mesh->normals = vectors(vertices);
    else if (word == "texcoords") for (int i = 0; i < 2 * vertices; ++i) number();
    else if (word != "triangles" || !mesh->triangles.empty()) throw Error(path + ": " + word + "?");
    else for (int i = 0; i < triangles; ++i) {
      int a = integer(0, vertices), b = integer(0, vertices), c = integer(0, vertices);
      mesh->triangles.push_back({a, b, c}), mesh->order.push_back(i);
    }
  }
  if (mesh->vertices.empty() || mesh->triangles.empty()) throw Error(path + ": no triangles");
  mesh->build(0, triangles);
  return mesh;
}

// ------------------------------------------------------------------ scene and shading

struct Shader {
  enum Kind { kPhong, kGlazed, kGlass } kind = kPhong;  // Lambertian: Phong without the highlight
  Vec diffuse{1, 1, 1}, specular{0, 0, 0};
  double exponent = 1, index = 0;
  std::shared_ptr<const Shader> substrate;
};
struct Light { Vec position, intensity; };

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
  int width = 0, height = 0, samples = 1;
  std::vector<std::shared_ptr<const Surface>> surfaces;  // in the order of the file
  std::vector<Light> lights;

  // Finds the nearest hit; its normal is of unit length and in the world. Nullptr is a miss.
  const Surface* intersect(const Ray& ray, Hit& nearest) const {
    const Surface* found = nullptr;
    for (const auto& s : surfaces) {
      // The direction keeps its length in object space, so that t is the same in both.
      Ray local{s->to_object.point(ray.origin), s->to_object.vector(ray.direction), ray.t_min, ray.t_max};
      Hit hit;
      s->intersect(local, hit);
      if (hit.t < nearest.t) nearest = hit, found = s.get();
    }
    if (found) nearest.normal = unit(found->normal_to_world.vector(nearest.normal));
    return found;
  }

  // `contribution` is what this ray's colour is multiplied with before it reaches the picture.
  Vec trace(const Ray& ray, int depth, double contribution) const {
    if (depth > kMaxDepth || contribution < kMinContribution) return {};
    Hit hit;
    const Surface* surface = intersect(ray, hit);
    if (!surface) return {};
    Vec p = ray.origin + ray.direction * hit.t;
    return shade(*surface->shader, p, hit.normal, unit(-ray.direction), depth, contribution);
  }

  // The colour seen from the direction v at the point p with normal n.
  Vec shade(const Shader& s, Vec p, Vec n, Vec v, int depth, double contribution) const {
    double cosine = dot(n, v), cos2 = 0;
    Vec color;
    if (s.kind == Shader::kPhong) {
      for (const Light& light : lights) {
        Hit blocker;  // every surface casts a shadow, glass too
        if (intersect({p, light.position - p, kEpsilon, 1}, blocker)) continue;
        Vec l = unit(light.position - p), h = unit(l + v);
        color = color + s.diffuse * light.intensity * std::max(0.0, dot(n, l)) +
                s.specular * light.intensity * std::pow(std::max(0.0, dot(n, h)), s.exponent);
      }
      return color;
    }
    if (s.kind == Shader::kGlazed) {
      if (cosine <= 0) return shade(*s.substrate, p, n, v, depth, contribution);
      double r = fresnel(cosine, 1, s.index, cos2);
      color = shade(*s.substrate, p, n, v, depth, contribution * (1 - r)) * (1 - r);
      return color + trace({p, n * (2 * cosine) - v}, depth + 1, contribution * (1 - r)) * (1 - r);
    }
    double n1 = 1, n2 = s.index;
    if (cosine < 0) n = -n, cosine = -cosine, std::swap(n1, n2);  // inside the glass
    double r = fresnel(cosine, n1, n2, cos2);
    color = trace({p, n * (2 * cosine) - v}, depth + 1, contribution * r) * r;
    if (r == 1) return color;
    Vec refracted = n * (n1 / n2 * cosine - cos2) - v * (n1 / n2);
    return color + trace({p, refracted}, depth + 1, contribution * (1 - r)) * (1 - r);
  }

  // The colour of pixel (x, y), in linear light; row 0 is the bottom one.
  Vec pixel(int x, int y) const {
    Vec sum;
    for (int j = 0; j < samples; ++j)
      for (int i = 0; i < samples; ++i) {
        double u = (x + (i + .5) / samples) / width - .5, v = (y + (j + .5) / samples) / height - .5;
        sum = sum + trace({eye, unit(ahead + right * u + up * v)}, 1, 1);
      }
    return sum / (samples * samples);
  }
};

// ------------------------------------------------------------------ reading scenes

struct Element {
  string tag, type, name, ref, text;  // the tag in lower case, the type without its package
  std::vector<Element> children;
  mutable bool used = false;  // whatever nobody has asked for is a mistake in the scene

  const Element* find(const string& child) const {  // the last one wins
    const Element* found = nullptr;
    for (const Element& c : children) if (c.tag == child) found = &c, c.used = true;
    return found;
  }
  Vec numbers(int count) const {
    std::istringstream in(text);
    Vec v;
    for (int i = 0; i < count; ++i) if (!(in >> v[i])) throw Error("a number is missing in <" + tag + ">");
    if (in >> std::ws; !in.eof()) throw Error("too much in <" + tag + ">");
    return v;
  }
  Vec vec(const string& child, Vec otherwise) const {
    return find(child) ? find(child)->numbers(3) : otherwise;
  }
  double number(const string& child, double otherwise) const {
    return find(child) ? find(child)->numbers(1).x : otherwise;
  }
  void check() const {
    for (const Element& c : children)
      if (c.used) c.check(); else throw Error("<" + c.tag + "> is unknown inside <" + tag + ">");
  }
};

// Reads the part of XML that scenes use. An element with `ref` becomes a copy of the one it names.
Element readXml(const string& text) {
  static const std::regex kTag("(/?)([^\\s/]+)((?:\\s+\\w+\\s*=\\s*(?:\"[^\"]*\"|'[^']*'))*)\\s*(/?)");
  static const std::regex kAttribute("(\\w+)\\s*=\\s*[\"']([^\"']*)");
  std::vector<Element> open(1);  // the document, then the elements that are not closed yet
  std::map<string, Element> named;
  for (size_t at = 0, less; (less = text.find('<', at)) != string::npos;) {
    open.back().text += text.substr(at, less - at);
    string end = text.compare(less, 4, "<!--") == 0 ? "-->" : ">";
    string tag = text.substr(less + 1, text.find(end, less) - less - 1);
    at = less + 1 + tag.size() + end.size();
    if (end == "-->" || tag[0] == '?') continue;
    std::smatch part;
    if (!std::regex_match(tag, part, kTag)) throw Error("cannot read <" + tag.substr(0, 40) + ">");
    Element e;
    for (char c : part.str(2)) e.tag += static_cast<char>(std::tolower(c));
    if (part.length(1) == 0) {
      string attributes = part.str(3);
      for (std::sregex_iterator a(attributes.begin(), attributes.end(), kAttribute), none; a != none; ++a) {
        string key = (*a)[1], value = (*a)[2];
        (key == "type" ? e.type : key == "name" ? e.name : key == "ref" ? e.ref : key) = value;
      }
      e.type = e.type.substr(e.type.rfind('.') + 1);
      open.push_back(e);
      if (part.length(4) == 0) continue;
    }
    if (open.back().tag != e.tag || open.size() == 1) throw Error("</" + e.tag + "> closes another element");
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
  if (e.type == "Lambertian" || e.type == "Phong") s->diffuse = e.vec("diffusecolor", {1, 1, 1});
  if (e.type == "Phong") {
    s->specular = e.vec("specularcolor", {1, 1, 1}), s->exponent = e.number("exponent", 1);
  } else if (e.type == "Glazed" || e.type == "Glass") {
    s->kind = e.type == "Glass" ? Shader::kGlass : Shader::kGlazed;
    s->index = e.number("refractiveindex", 0);
    if (!(s->index > 0)) throw Error("a shader needs a refractiveIndex above 0");
    const Element* substrate = s->kind == Shader::kGlazed ? e.find("substrate") : nullptr;
    if (substrate) s->substrate = readShader(*substrate);
    if (s->kind == Shader::kGlazed && !substrate) throw Error("a Glazed shader needs a substrate");
  } else if (e.type != "Lambertian") {
    throw Error("a shader of unknown type '" + e.type + "'");
  }
  return s;
}

std::shared_ptr<Surface> readSolid(const Element& e) {
  double half = e.type == "Sphere" ? INFINITY : e.number("height", 1) / 2, radius = e.number("radius", 1);
  if (radius < 0 || half < 0) throw Error("a radius or a height is negative");
  auto q = std::make_shared<Quadric>();
  q->center = e.vec("center", {}), q->constant = radius * radius, q->bottom = -half, q->top = half;
  if (e.type == "Sphere") q->factor = -1;
  if (e.type == "Cone") {
    double tip = e.number("tipz", 0), above = q->center.z - tip;
    if (above == 0) throw Error("a cone's tip is at its centre");
    q->factor = q->constant / (above * above), q->constant = 0;
    q->center.z = tip, q->bottom += above, q->top += above;
  }
  return q;
}

// Adds the surface, or all that are in the group, to the scene.
void readSurface(const Element& e, Matrix world, ShaderPointer shader, const string& folder, Scene& scene) {
  e.find("shader");
  for (const Element& c : e.children) if (c.tag == "shader") shader = readShader(c);
  if (e.type == "Group") {  // first all transformations, the first in the file outermost
    for (const string tag : {"translate", "rotate", "scale", "surface"}) e.find(tag);
    for (const Element& c : e.children) {
      Vec v = c.tag == "surface" || c.tag == "shader" ? Vec{} : c.numbers(3);
      if (c.tag == "translate") world = world * Matrix{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, v};
      if (c.tag == "rotate") world = world * rotation(2, v.z) * rotation(1, v.y) * rotation(0, v.x);
      if (c.tag == "scale") world = world * Matrix{{axis(0, v.x), axis(1, v.y), axis(2, v.z)}, {}};
    }
    for (const Element& c : e.children) if (c.tag == "surface") readSurface(c, world, shader, folder, scene);
    return;
  }
  std::shared_ptr<Surface> surface;
  if (e.type == "Mesh") {
    string name;
    if (const Element* data = e.find("data")) std::istringstream(data->text) >> name;
    surface = readMesh(folder + name);
  } else if (e.type == "Box") {
    auto box = std::make_shared<Box>();
    box->low = e.vec("minpt", {}), box->high = e.vec("maxpt", {});
    surface = box;
  } else if (e.type == "Sphere" || e.type == "Cylinder" || e.type == "Cone") {
    surface = readSolid(e);
  } else {
    throw Error("a surface of unknown type '" + e.type + "'");
  }
  surface->to_object = inverse(world);
  surface->normal_to_world = world;
  surface->shader = shader;
  scene.surfaces.push_back(surface);
}

void readCamera(const Element& e, Scene& scene) {
  Vec direction = e.vec("viewdir", {0, 0, -1}), up = e.vec("viewup", {0, 1, 0});
  Vec normal = e.vec("projnormal", direction);
  if (dot(normal, direction) == 0) throw Error("projNormal is perpendicular to viewDir");
  if (length(cross(up, normal)) == 0) throw Error("viewUp is parallel to projNormal");
  Vec w = unit(dot(normal, direction) > 0 ? -normal : normal), u = unit(cross(up, w));
  scene.eye = e.vec("viewpoint", {}), scene.ahead = unit(direction) * e.number("projdistance", 1);
  scene.right = u * e.number("viewwidth", 1), scene.up = cross(w, u) * e.number("viewheight", 1);
}

Scene readScene(const string& path) {
  std::ifstream in(path);
  if (!in) throw Error("cannot open it");
  Element e = readXml({std::istreambuf_iterator<char>(in), {}});
  const Element* image = e.find("image");
  if (e.tag != "scene" || !image) throw Error("a <scene> with an <image> is expected");
  Scene scene;
  Vec size = image->numbers(2);
  if (size.x < 1 || size.y < 1 || size.x > 1e5 || size.y > 1e5) throw Error("an image of this size?");
  scene.width = static_cast<int>(size.x), scene.height = static_cast<int>(size.y);
  scene.samples = std::max(1, static_cast<int>(std::lround(std::sqrt(e.number("samples", 1)))));
  readCamera({}, scene);  // the defaults
  for (const string tag : {"camera", "shader", "light", "surface"}) e.find(tag);
  for (const Element& c : e.children) {
    if (c.tag == "camera") readCamera(c, scene);
    if (c.tag == "shader") readShader(c);  // only to find its mistakes
    if (c.tag == "light")
      scene.lights.push_back({c.vec("position", {}), c.vec("intensity", c.vec("color", {1, 1, 1}))});
    if (c.tag == "surface")
      readSurface(c, {}, std::make_shared<Shader>(), path.substr(0, path.rfind('/') + 1), scene);
  }
  e.check();
  return scene;
}

// ------------------------------------------------------------------ pictures

string bigEndian(uint32_t v) { return {char(v >> 24), char(v >> 16), char(v >> 8), char(v)}; }

string chunk(const string& body) {  // of a PNG file: length, name and data, checksum
  uint32_t crc = ~0u;
  for (unsigned char byte : body) {
    crc ^= byte;
    for (int k = 0; k < 8; ++k) crc = crc & 1 ? 0xedb88320u ^ (crc >> 1) : crc >> 1;
  }
  return bigEndian(static_cast<uint32_t>(body.size() - 4)) + body + bigEndian(~crc);
}

// `rows` are the rows from the top, each a 0 (no filter) and its pixels. Stored, not compressed.
void writePng(const string& path, int width, int height, const string& rows) {
  string zlib = "\x78\x01";
  uint32_t a = 1, b = 0;
  for (unsigned char byte : rows) a = (a + byte) % 65521, b = (b + a) % 65521;
  for (size_t at = 0; at < rows.size(); at += 65535) {
    size_t n = std::min<size_t>(65535, rows.size() - at);
    zlib += {char(at + n == rows.size()), char(n), char(n >> 8), char(~n), char(~n >> 8)};
    zlib += rows.substr(at, n);
  }
  std::ofstream out(path, std::ios::binary);
  out << "\x89PNG\r\n\x1a\n"
      << chunk("IHDR" + bigEndian(width) + bigEndian(height) + string("\x08\x02\0\0\0", 5))
      << chunk("IDAT" + zlib + bigEndian(b << 16 | a)) << chunk("IEND");
  if (!out.flush()) throw Error("cannot write " + path);
}

void render(const Scene& scene, const string& path) {
  size_t stride = 1 + 3 * static_cast<size_t>(scene.width);
  string rows(stride * scene.height, '\0');
  std::atomic<int> next{0};
  auto work = [&] {
    for (int row; (row = next++) < scene.height;)
      for (int x = 0; x < scene.width; ++x) {
        Vec color = scene.pixel(x, scene.height - 1 - row);
        for (int k = 0; k < 3; ++k) {
          auto c = static_cast<float>(std::min(1.0, std::pow(std::max(0.0, color[k]), 1 / 2.2)));
          rows[row * stride + 1 + 3 * x + k] = static_cast<char>(static_cast<int>(255.0 * c + .5));
        }
      }
  };
  std::vector<std::thread> threads(std::max(1u, std::thread::hardware_concurrency()));
  for (auto& t : threads) t = std::thread(work);
  for (auto& t : threads) t.join();
  writePng(path, scene.width, scene.height, rows);
}

int main(int argc, char** argv) {
  int status = argc > 1 ? 0 : 1;
  for (int i = 1; i < argc; ++i) {
    string path = argv[i];
    try {
      render(readScene(path), path + ".png");
    } catch (const std::exception& e) {
      std::cerr << path << ": " << e.what() << "\n";
      status = 1;
    }
  }
  return status;
}
