#include "conformance/judge/copy_tree.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "renderer/math/input_error.h"
#include "renderer/math/nearest_name.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMostBytes = std::uintmax_t{1} << 30;
constexpr int kMostEntries = 100'000;
constexpr int kDeepest = 64;

class TreeCopier {
 public:
  explicit TreeCopier(Pictures pictures) : pictures_(pictures) {}

  void copy(const fs::path& from, const fs::path& to, const fs::path& name, int depth) {
    if (depth > kDeepest)
      throw InputError({}, "the submission's folders are nested more than " + std::to_string(kDeepest) + " deep");
    fs::create_directories(to);
    for (const auto& entry : fs::directory_iterator(from)) {
      if (++entries_ > kMostEntries) throw InputError({}, "the submission has more than 100,000 files and folders");
      const fs::path target = to / entry.path().filename();
      const fs::path entry_name = name / entry.path().filename();
      const fs::file_status status = entry.symlink_status();
      if (fs::is_directory(status))
        copy(entry.path(), target, entry_name, depth + 1);
      else if (!fs::is_regular_file(status))
        left_out_.not_ordinary.push_back(entry_name.generic_string());
      else if (pictures_ == Pictures::leave_out && is_picture(entry_name))
        ++left_out_.pictures;
      else
        copy_file(entry.path(), target);
    }
  }

  LeftOut take() { return std::move(left_out_); }

 private:
  void copy_file(const fs::path& from, const fs::path& to) {
    bytes_ += fs::file_size(from);
    if (bytes_ > kMostBytes) throw InputError({}, "the submission is larger than 1 GiB");
    fs::copy_file(from, to, fs::copy_options::overwrite_existing);
    fs::permissions(to, fs::perms::owner_read | fs::perms::owner_write, fs::perm_options::add);
  }

  Pictures pictures_;
  LeftOut left_out_;
  std::uintmax_t bytes_ = 0;
  int entries_ = 0;
};

}  // namespace

LeftOut copy_tree(const fs::path& from, const fs::path& to, Pictures pictures) {
  TreeCopier copier(pictures);
  copier.copy(from, to, "", 0);
  return copier.take();
}

bool is_picture(const fs::path& file) {
  constexpr std::array<std::string_view, 9> kEndings{".png", ".ppm", ".exr", ".jpg", ".jpeg",
                                                     ".bmp", ".gif", ".tif", ".tiff"};
  return std::ranges::any_of(
      kEndings, [&](std::string_view ending) { return equal_ignoring_case(file.extension().string(), ending); });
}

}  // namespace plumb
