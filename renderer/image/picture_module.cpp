#include "renderer/image/picture_module.h"

#include <dlfcn.h>

#include <stdexcept>

namespace plumb {
namespace {

const PictureModule& load() {
  namespace fs = std::filesystem;
  const fs::path file = fs::read_symlink("/proc/self/exe").parent_path().parent_path() / "lib/plumb/pictures.so";
  // Never closed: OpenImageIO keeps threads and tables of its own.
  void* const library = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  const void* const found = library != nullptr ? ::dlsym(library, "plumb_picture_module") : nullptr;
  if (found == nullptr) {
    throw std::runtime_error(std::string("EXR and PPM pictures cannot be read or written, because their module is "
                                         "missing: ") +
                             ::dlerror());
  }
  return *static_cast<const PictureModule*>(found);
}

}  // namespace

const PictureModule& picture_module() {
  static const PictureModule& module = load();
  return module;
}

}  // namespace plumb
