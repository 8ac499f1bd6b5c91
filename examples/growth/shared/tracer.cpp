// A ray tracer for scenes of one kind: a camera, lights, matt and shiny shaders, triangle meshes and spheres.
//   g++ -O2 -std=c++17 -pthread -o tracer tracer.cpp
//   ./tracer scene.xml ...        writes scene.xml.png beside each scene
// How the nearest hit is found stands in search.h:
//   struct Search {
//     static constexpr int kThreads;
//     void build(std::vector<Primitive>);
//     bool closest(const Ray&, Hit&) const;   // shortens hit.t, which is the end of the ray at first
//   };
#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <map>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "primitives.h"
#include "search.h"

using std::string;
using Error = std::runtime_error;

struct Light {
  Vec position, intensity;
};
struct Shader {
  Vec diffuse{1, 1, 1}, specular{0, 0, 0};
  double exponent = 1;
};
struct Look {  // of a primitive
  const Shader* shader;
  int normals[3];  // of its corners, in the scene's list; -1: it is flat, or a sphere
};

// ------------------------------------------------------------------ shading
struct Scene {
  Vec eye, ahead, right, up;  // `ahead` leads to the middle of the window, the others along its sides
  int width = 0, height = 0;
  std::vector<Light> lights;
  std::deque<Shader> shaders{1};  // the first is white
  std::map<string, const Shader*> named;
  std::vector<Primitive> primitives;  // until the search takes them
  std::vector<Look> looks;            // by the primitive's place
  std::vector<Vec> normals;
  int objects = 0;
  Search search;

  Vec normal(const Hit& hit, Vec point) const {
    const Primitive& p = *hit.primitive;
    const int* n = looks[p.place].normals;
    if (p.radius >= 0) return unit(point - p.a);
    if (n[0] < 0) return unit(cross(p.edge1, p.edge2));
    return unit(normals[n[0]] * (1 - hit.beta - hit.gamma) + normals[n[1]] * hit.beta + normals[n[2]] * hit.gamma);
  }

  Vec trace(const Ray& ray) const {
    Hit hit;
    if (!search.closest(ray, hit)) return {};
    const Vec point = ray.origin + ray.direction * hit.t, n = normal(hit, point), v = unit(ray.direction * -1);
    const Shader& s = *looks[hit.primitive->place].shader;
    Vec color;
    for (const Light& light : lights) {
      Hit blocker;
      blocker.t = 1;  // the light
      if (search.closest({point, light.position - point}, blocker)) continue;
      const Vec l = unit(light.position - point), h = unit(l + v);
      color = color + s.diffuse * light.intensity * std::max(0.0, dot(n, l));
      if (dot(s.specular, s.specular) > 0)
        color = color + s.specular * light.intensity * std::pow(std::max(0.0, dot(n, h)), s.exponent);
    }
    return color;
  }

  // The colour of pixel (x, y), in linear light; row 0 is the bottom one.
  Vec pixel(int x, int y) const {
    return trace({eye, unit(ahead + right * ((x + .5) / width - .5) + up * ((y + .5) / height - .5))});
  }
};

// ------------------------------------------------------------------ reading
string read_file(const string& path) {
  std::FILE* file = std::fopen(path.c_str(), "rb");
  if (!file) throw Error("cannot open " + path);
  string all;
  char part[1 << 16];
  for (size_t n; (n = std::fread(part, 1, sizeof part, file)) > 0;) all.append(part, n);
  std::fclose(file);
  return all;
}

struct Element {
  string tag, type, name, ref, text;  // the tag in lower case, the type without its package
  std::vector<Element> children;
  const Element* find(const char* child) const {
    for (const Element& c : children)
      if (c.tag == child) return &c;
    return nullptr;
  }
  Vec vec(const char* child, Vec value) const {
    const Element* c = find(child);
    if (!c) return value;
    char* at = const_cast<char*>(c->text.c_str());
    value.x = std::strtod(at, &at), value.y = std::strtod(at, &at), value.z = std::strtod(at, &at);
    return value;
  }
  double number(const char* child, double value) const { return vec(child, {value, 0, 0}).x; }
};

// Reads the part of XML that scenes use, one element at a time.
struct XmlReader {
  const string& text;
  size_t at = 0;

  // The next tag, without its brackets; what stands before it is appended to `before`.
  string next_tag(string* before = nullptr) {
    for (;;) {
      const size_t open = text.find('<', at);
      if (open == string::npos) throw Error("an element is not closed");
      if (before) before->append(text, at, open - at);
      const bool comment = text.compare(open, 4, "<!--") == 0;
      const size_t close = text.find(comment ? "-->" : ">", open);
      if (close == string::npos) throw Error("a tag is not closed");
      at = close + (comment ? 3 : 1);
      if (!comment && text[open + 1] != '?') return text.substr(open + 1, close - open - 1);
    }
  }

  static string attribute(const string& tag, const string& key) {
    const size_t found = tag.find(" " + key + "=");
    if (found == string::npos) return "";
    const size_t begin = found + key.size() + 3;
    return tag.substr(begin, tag.find(tag[begin - 1], begin) - begin);
  }

  static Element opened(const string& tag) {
    Element e;
    for (char c : tag.substr(0, tag.find_first_of(" \t\r\n/"))) e.tag += static_cast<char>(std::tolower(c));
    e.type = attribute(tag, "type"), e.name = attribute(tag, "name"), e.ref = attribute(tag, "ref");
    e.type = e.type.substr(e.type.rfind('.') + 1);
    return e;
  }

  // The element that `tag` opens, read to its end.
  Element element(const string& tag) {
    Element e = opened(tag);
    if (tag.back() == '/') return e;
    for (string next = next_tag(&e.text); next[0] != '/'; next = next_tag(&e.text)) e.children.push_back(element(next));
    return e;
  }
};

const Shader* read_shader(const Element& e, Scene& scene) {
  if (!e.ref.empty()) return scene.named.at(e.ref);
  Shader s;
  s.diffuse = e.vec("diffusecolor", {1, 1, 1});
  if (e.type == "Phong") s.specular = e.vec("specularcolor", {1, 1, 1}), s.exponent = e.number("exponent", 1);
  scene.shaders.push_back(s);
  if (!e.name.empty()) scene.named[e.name] = &scene.shaders.back();
  return &scene.shaders.back();
}

void add(Primitive p, const Look& look, Scene& scene) {
  p.place = static_cast<int>(scene.primitives.size()), p.object = scene.objects;
  scene.primitives.push_back(p);
  scene.looks.push_back(look);
}

void read_mesh(const string& path, const Shader* shader, Scene& scene) {
  const string all = read_file(path);
  char* at = const_cast<char*>(all.c_str());
  auto word = [&] {
    at += std::strspn(at, " \t\r\n");
    const size_t n = std::strcspn(at, " \t\r\n");
    return string((at += n) - n, n);
  };
  auto vector = [&] {  // 32 bits, as the course's program keeps them
    const float x = std::strtof(at, &at), y = std::strtof(at, &at), z = std::strtof(at, &at);
    return Vec{x, y, z};
  };
  const long vertex_count = std::strtol(at, &at, 10), triangle_count = std::strtol(at, &at, 10);
  std::vector<Vec> vertices;
  std::vector<long> corners;
  const int first_normal = static_cast<int>(scene.normals.size());
  for (string keyword = word(); !keyword.empty(); keyword = word()) {
    if (keyword == "triangles")
      for (long i = 0; i < 3 * triangle_count; ++i) corners.push_back(std::strtol(at, &at, 10));
    else if (keyword == "texcoords")
      for (long i = 0; i < 2 * vertex_count; ++i) std::strtod(at, &at);
    else
      for (long i = 0; i < vertex_count; ++i) (keyword == "normals" ? scene.normals : vertices).push_back(vector());
  }
  for (long c : corners)
    if (c < 0 || c >= static_cast<long>(vertices.size())) throw Error(path + ": there is no such vertex");
  const bool flat = scene.normals.size() != first_normal + vertices.size();
  for (size_t i = 0; i + 2 < corners.size(); i += 3) {
    Look look{shader, {-1, -1, -1}};
    for (int k = 0; k < 3 && !flat; ++k) look.normals[k] = first_normal + static_cast<int>(corners[i + k]);
    Primitive p;
    p.a = vertices[corners[i]], p.edge1 = vertices[corners[i + 1]] - p.a, p.edge2 = vertices[corners[i + 2]] - p.a;
    add(p, look, scene);
  }
}

void read_surface(const Element& e, const string& folder, Scene& scene) {
  const Element* own = e.find("shader");
  const Shader* shader = own ? read_shader(*own, scene) : &scene.shaders.front();
  if (e.type == "Sphere") {
    Primitive p;
    p.a = e.vec("center", {}), p.radius = e.number("radius", 1);
    add(p, {shader, {-1, -1, -1}}, scene);
  } else if (const Element* data = e.find("data"); e.type == "Mesh" && data) {
    const size_t begin = data->text.find_first_not_of(" \t\r\n"), end = data->text.find_last_not_of(" \t\r\n");
    read_mesh(folder + data->text.substr(begin, end - begin + 1), shader, scene);
  } else {
    throw Error("a surface of unknown type '" + e.type + "'");
  }
  ++scene.objects;
}

void read_camera(const Element& e, Scene& scene) {
  const Vec gaze = e.vec("viewdir", {0, 0, -1}), normal = e.vec("projnormal", gaze), up = e.vec("viewup", {0, 1, 0});
  const Vec w = unit(normal * (dot(normal, gaze) > 0 ? -1 : 1)), u = unit(cross(up, w));
  scene.eye = e.vec("viewpoint", {}), scene.ahead = unit(gaze) * e.number("projdistance", 1);
  scene.right = u * e.number("viewwidth", 1), scene.up = cross(w, u) * e.number("viewheight", 1);
}

void read_scene(const string& path, Scene& scene) {
  const string text = read_file(path), folder = path.substr(0, path.rfind('/') + 1);
  XmlReader xml{text};
  if (XmlReader::opened(xml.next_tag()).tag != "scene") throw Error("a <scene> is expected");
  read_camera({}, scene);  // the defaults
  for (string tag = xml.next_tag(); tag[0] != '/'; tag = xml.next_tag()) {
    const Element e = xml.element(tag);
    if (e.tag == "camera") read_camera(e, scene);
    if (e.tag == "shader") read_shader(e, scene);
    if (e.tag == "light")
      scene.lights.push_back({e.vec("position", {}), e.vec("intensity", e.vec("color", {1, 1, 1}))});
    if (e.tag == "surface") read_surface(e, folder, scene);
    if (e.tag == "image" && std::sscanf(e.text.c_str(), "%d %d", &scene.width, &scene.height) != 2)
      throw Error("<image> needs two numbers");
  }
  if (scene.width < 1 || scene.height < 1) throw Error("there is no <image>");
  scene.search.build(std::move(scene.primitives));
}

// ------------------------------------------------------------------ pictures
string big_endian(unsigned v) { return {char(v >> 24), char(v >> 16), char(v >> 8), char(v)}; }
string chunk(const string& body) {  // of a PNG file: length, name and data, checksum
  unsigned table[256], crc = ~0u;
  for (unsigned i = 0; i < 256; ++i) {
    table[i] = i;
    for (int k = 0; k < 8; ++k) table[i] = table[i] & 1 ? 0xedb88320u ^ (table[i] >> 1) : table[i] >> 1;
  }
  for (unsigned char byte : body) crc = table[(crc ^ byte) & 255] ^ (crc >> 8);
  return big_endian(static_cast<unsigned>(body.size() - 4)) + body + big_endian(~crc);
}

// `rows` are the rows from the top, each a 0 (no filter) and its pixels. Stored, not compressed.
void write_png(const string& path, int width, int height, const string& rows) {
  string zlib = "\x78\x01";
  unsigned a = 1, b = 0;
  for (unsigned char byte : rows) a = (a + byte) % 65521, b = (b + a) % 65521;
  for (size_t at = 0; at < rows.size(); at += 65535) {
    const size_t n = std::min<size_t>(65535, rows.size() - at);
    zlib += string{char(at + n == rows.size()), char(n), char(n >> 8), char(~n), char(~n >> 8)} + rows.substr(at, n);
  }
  const string size = big_endian(static_cast<unsigned>(width)) + big_endian(static_cast<unsigned>(height));
  const string file = "\x89PNG\r\n\x1a\n" + chunk("IHDR" + size + string("\x08\x02\0\0\0", 5)) +
                      chunk("IDAT" + zlib + big_endian(b << 16 | a)) + chunk("IEND");
  std::FILE* out = std::fopen(path.c_str(), "wb");
  const bool written = out && std::fwrite(file.data(), 1, file.size(), out) == file.size();
  if (!out || std::fclose(out) != 0 || !written) throw Error("cannot write " + path);
}

void render(const Scene& scene, const string& path) {
  const size_t stride = 1 + 3 * static_cast<size_t>(scene.width);
  string rows(stride * static_cast<size_t>(scene.height), '\0');
  auto work = [&](int first) {  // every `kThreads`th row
    for (int row = first; row < scene.height; row += Search::kThreads)
      for (int x = 0; x < scene.width; ++x) {
        const Vec color = scene.pixel(x, scene.height - 1 - row);
        for (int k : {0, 1, 2}) {
          const auto c = static_cast<float>(std::min(1.0, std::pow(std::max(0.0, color[k]), 1 / 2.2)));
          rows[row * stride + 1 + 3 * x + k] = static_cast<char>(static_cast<int>(255.0 * c + .5));
        }
      }
  };
  std::vector<std::thread> others;
  for (int i = 1; i < Search::kThreads; ++i) others.emplace_back(work, i);
  work(0);
  for (std::thread& t : others) t.join();
  write_png(path, scene.width, scene.height, rows);
}

int main(int argc, char** argv) {
  int status = argc > 1 ? 0 : 1;
  for (int i = 1; i < argc; ++i) try {
      Scene scene;
      read_scene(argv[i], scene);
      render(scene, string(argv[i]) + ".png");
    } catch (const std::exception& e) {
      std::fprintf(stderr, "%s: %s\n", argv[i], e.what());
      status = 1;
    }
  return status;
}
