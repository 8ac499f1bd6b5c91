#include "conformance/judge/workspace.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <set>
#include <system_error>

#include "conformance/judge/copy_tree.h"
#include "renderer/math/input_error.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

void set_writable(const fs::path& folder, bool writable) {
  const auto set = [&](const fs::path& path) {
    const fs::perms all = fs::perms::owner_write | fs::perms::group_write | fs::perms::others_write;
    if (writable)
      fs::permissions(path, fs::perms::owner_all, fs::perm_options::add);
    else
      fs::permissions(path, all, fs::perm_options::remove);
  };
  if (writable) set(folder);
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.is_symlink()) continue;
    if (entry.is_directory())
      set_writable(entry.path(), writable);
    else
      set(entry.path());
  }
  if (!writable) set(folder);
}

/// A submission may leave folders that even their owner cannot list.
void remove_tree(const fs::path& folder) {
  std::error_code error;
  fs::remove_all(folder, error);
  if (!error) return;
  try {
    set_writable(folder, true);
    fs::remove_all(folder);
  } catch (const fs::filesystem_error& failure) {
    fmt::print(stderr, "warning: the working folder could not be removed: {}\n", failure.what());
  }
}

fs::path new_folder() {
  std::string name = (fs::temp_directory_path() / "plumb-XXXXXX").string();
  if (!::mkdtemp(name.data()))
    throw std::system_error(errno, std::generic_category(), "cannot make a working folder " + name);
  return fs::canonical(name);
}

/// Links to what is in `from`, but to no picture that the build may have made.
void link_entries(const fs::path& from, const fs::path& to) {
  for (const auto& entry : fs::directory_iterator(from))
    if (!is_picture(entry.path())) fs::create_symlink(entry.path(), to / entry.path().filename());
}

/// Makes `relative` a chain of real folders below `run`, where it was a link to what was built; the rest of each such
/// folder shows through links as before.
void make_real(const fs::path& run, const fs::path& build, const fs::path& relative) {
  fs::path real = run;
  fs::path built = build;
  for (const fs::path& part : relative.lexically_normal()) {
    if (part.empty() || part == ".") continue;
    real /= part;
    built /= part;
    if (fs::is_symlink(real)) fs::remove(real);
    if (fs::create_directory(real) && fs::is_directory(built)) link_entries(built, real);
  }
}

}  // namespace

Workspace::Workspace() : root_(new_folder()), sealed_root_(new_folder()) {
  build_ = root_ / "build";
  sealed_copy_ = sealed_root_ / "build";
}

Workspace::~Workspace() {
  remove_tree(root_);
  remove_tree(sealed_root_);
}

void Workspace::copy_submission(const fs::path& submission, const Suite& suite) {
  if (!suite.root_marker.empty()) {
    for (const fs::path& root : find_roots(submission, suite.root_marker))
      roots_.push_back(root.lexically_relative(submission).generic_string());
  }
  left_out_ = copy_tree(roots_.empty() ? submission : submission / roots_.front(), build_, Pictures::leave_out);
  if (!suite.overlay.empty()) copy_tree(suite.overlay, build_, Pictures::copy);
}

void Workspace::seal_build() {
  fs::copy(build_, sealed_copy_, fs::copy_options::recursive | fs::copy_options::copy_symlinks);
  set_writable(build_, false);
  sealed_ = state_of(build_);
}

bool Workspace::check_build() {
  if (fs::is_directory(fs::symlink_status(build_)) && state_of(build_) == sealed_) return true;
  remove_tree(build_);
  if (!fs::is_directory(sealed_copy_)) throw LostBuild("the sealed copy of the build is gone");
  fs::copy(sealed_copy_, build_, fs::copy_options::recursive | fs::copy_options::copy_symlinks);
  set_writable(build_, false);
  sealed_ = state_of(build_);
  return false;
}

Workspace::State Workspace::state_of(const fs::path& folder) const {
  State state;
  for (auto it = fs::recursive_directory_iterator(folder, fs::directory_options::skip_permission_denied);
       it != fs::recursive_directory_iterator(); ++it) {
    struct stat facts {};
    if (::lstat(it->path().c_str(), &facts) != 0) continue;
    std::string text = fmt::format("{} {}", facts.st_mode, facts.st_ino);
    if (S_ISREG(facts.st_mode))
      text += fmt::format(" {} {}.{}", facts.st_size, facts.st_ctim.tv_sec, facts.st_ctim.tv_nsec);
    if (S_ISLNK(facts.st_mode)) text += " " + fs::read_symlink(it->path()).string();
    state.emplace(it->path().lexically_relative(folder).string(), text);
  }
  return state;
}

Workspace::CaseFolder Workspace::make_case_folder(const SuiteCase& suite_case, const Runner& runner) {
  const fs::path all = root_ / "cases" / suite_case.id;
  remove_tree(all);
  CaseFolder folder{all, all / "run", all / "home"};
  fs::create_directories(folder.run);
  fs::create_directories(folder.home);

  const CasePaths paths = case_paths(runner, suite_case);
  link_entries(build_, folder.run);
  make_real(folder.run, build_, fs::path(paths.output).parent_path());
  make_real(folder.run, build_, paths.folder);
  const fs::path real = folder.run / paths.folder;
  if (paths.folder != ".") {  // a folder of scenes holds the inputs alone
    fs::remove_all(real);
    fs::create_directory(real);
    make_real(folder.run, build_, fs::path(paths.output).parent_path());
  }
  for (const fs::path& input : suite_case.inputs) {
    fs::remove(real / input.filename());  // an input stands before a file of the submission
    fs::copy_file(input, real / input.filename());
    fs::permissions(real / input.filename(), fs::perms::owner_read | fs::perms::owner_write, fs::perm_options::add);
  }
  return folder;
}

void Workspace::remove_case_folder(const CaseFolder& folder) { remove_tree(folder.all); }

std::vector<fs::path> find_roots(const fs::path& top, const std::string& marker) {
  std::vector<fs::path> level{top};
  while (!level.empty()) {
    std::vector<fs::path> found, next;
    for (const fs::path& folder : level) {
      if (fs::is_regular_file(fs::symlink_status(folder / marker))) found.push_back(folder);
      for (const auto& entry : fs::directory_iterator(folder))
        if (entry.is_directory() && !entry.is_symlink() && !is_hidden(entry.path())) next.push_back(entry.path());
    }
    std::ranges::sort(found);
    if (!found.empty()) return found;
    std::ranges::sort(next);
    level = std::move(next);
  }
  throw InputError({}, "no folder of the submission holds '" + marker + "', by which its root is known");
}

}  // namespace plumb
