#include "conformance/envelopes/textbook/textbook.h"

#include <gtest/gtest.h>

#include <ctime>
#include <cstdio>

#include "renderer/scene_for_tests.h"

namespace plumb {
namespace {

TEST(Textbook, Report) {
  std::vector<std::filesystem::path> files;
  for (const char* folder : {PLUMB_SOURCE_DIR "/scenes/library", PLUMB_SHARED_DIR "/course/pa3-2011", PLUMB_SHARED_DIR "/course/cs461-2012"})
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      if (entry.path().extension() == ".xml") files.push_back(entry.path());
  std::ranges::sort(files);
  const auto cpu = [] { return double(std::clock()) / CLOCKS_PER_SEC; };
  std::printf("%-28s %8s %6s %6s | f1e-5 f1e-4 f1e-9 | rev oth noise shift dt-9 dt-4 oth+f| cpu\n", "scene", "pixels", ">1e-9", "level");
  for (const auto& file : files) {
    const ReadScene read = read_and_build(file);
    const MeshTable meshes = load_meshes(read.description);
    const Image expected = render(read.scene, {}).image;
    const TextbookOptions options = textbook_options(read.description);
    const double start = cpu();
    const Image usual = textbook_picture(textbook_samples(read.description, meshes, options, 1), options);
    const double seconds = cpu() - start;
    int off = 0, level = 0;
    for (std::size_t i = 0; i < usual.pixels().size(); ++i) {
      const Color &a = usual.pixels()[i], &b = expected.pixels()[i];
      off += !(std::fabs(a.r - b.r) < 1e-9 && std::fabs(a.g - b.g) < 1e-9 && std::fabs(a.b - b.b) < 1e-9);
      level += level_of(a.r) != level_of(b.r) || level_of(a.g) != level_of(b.g) || level_of(a.b) != level_of(b.b);
    }
    const auto differ = [&](TextbookOptions o, int by) {
      const Image other = textbook_picture(textbook_samples(read.description, meshes, o, 1), o);
      int n = 0;
      const auto a = levels_of(usual), b = levels_of(other);
      for (std::size_t i = 0; i < a.size(); i += 3) {
        bool d = false;
        for (std::size_t k = 0; k < 3; ++k) d = d || std::abs(a[i + k] - b[i + k]) > by;
        n += d;
      }
      return n;
    };
    auto with = [&](auto change) { TextbookOptions o = options; change(o); return o; };
    std::printf("%-28s %8zu %6d %6d | %5d %5d %5d | %d %d %d %d %d %d %d | %.2f\n", file.stem().c_str(), usual.pixels().size(), off, level,
      differ(with([](auto& o) { o.single = true; o.t_min = 1e-5; }), 2),
      differ(with([](auto& o) { o.single = true; o.t_min = 1e-4; }), 2),
      differ(with([](auto& o) { o.single = true; o.t_min = 1e-9; }), 2),
      differ(with([](auto& o) { o.reverse_sums = true; }), 0),
      differ(with([](auto& o) { o.other_formulas = true; }), 0),
      differ(with([](auto& o) { o.vertex_noise = 1e-7; }), 0),
      differ(with([](auto& o) { o.shift_x = 1e-5; }), 0),
      differ(with([](auto& o) { o.t_min = 1e-9; }), 0),
      differ(with([](auto& o) { o.t_min = 1e-4; }), 0),
      differ(with([](auto& o) { o.single = true; o.t_min = 1e-5; o.other_formulas = true; }), 2),
       seconds);
  }
}

}  // namespace
}  // namespace plumb
