#include "conformance/subject/shipped_kernels.h"

#include <algorithm>

#include "renderer/math/input_error.h"
#include "renderer/math/nearest_name.h"

namespace plumb {

namespace fs = std::filesystem;

fs::path shipped_kernels_folder() {
  return fs::read_symlink("/proc/self/exe").parent_path().parent_path() / "lib/plumb/kernels";
}

std::vector<std::string> shipped_kernel_names() {
  std::vector<std::string> names;
  std::error_code absent;
  for (const fs::directory_entry& entry : fs::directory_iterator(shipped_kernels_folder(), absent))
    if (entry.path().extension() == ".so") names.push_back(entry.path().stem().string());
  std::ranges::sort(names);
  return names;
}

fs::path shipped_kernel(std::string_view name) {
  const std::vector<std::string> names = shipped_kernel_names();
  if (std::ranges::find(names, name) != names.end()) return shipped_kernels_folder() / (std::string(name) + ".so");
  const std::vector<std::string_view> known(names.begin(), names.end());
  throw InputError({}, "no kernel of the name " + std::string(name) + " comes with plumb" + did_you_mean(name, known));
}

}  // namespace plumb
