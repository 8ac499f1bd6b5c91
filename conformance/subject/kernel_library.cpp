#include "conformance/subject/kernel_library.h"

#include <dlfcn.h>

#include "renderer/math/input_error.h"

namespace plumb {
namespace {

std::string last_error() {
  const char* text = ::dlerror();
  return text ? text : "unknown error";
}

}  // namespace

void KernelLibrary::Close::operator()(void* handle) const { ::dlclose(handle); }

KernelLibrary::KernelLibrary(const std::filesystem::path& library)
    // A name without a slash would be looked up in the system's folders. The code stays: a kernel may have left threads
    // behind, and whoever traces memory wants to know whose it was.
    : handle_(::dlopen(std::filesystem::absolute(library).c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE)) {
  const SourceLocation where{library.string(), 0, 0};
  if (!handle_) throw InputError(where, "the library cannot be loaded: " + last_error());
  void* entry = ::dlsym(handle_.get(), PLUMB_KERNEL_ENTRY);
  if (!entry) throw InputError(where, "the library has no function " PLUMB_KERNEL_ENTRY ", expected a kernel");
  table_ = reinterpret_cast<plumb_kernel_entry>(entry)();
  facts_ = read_facts(table_, library);
}

}  // namespace plumb
