#pragma once

#include <filesystem>
#include <memory>

#include "conformance/subject/kernel_facts.h"

namespace plumb {

/// A kernel's shared library, loaded into this very process: its code runs here, with all that may come of it.
class KernelLibrary {
 public:
  /// Throws InputError, at the library, where it cannot be loaded, has no entry, or read_facts refuses its table.
  explicit KernelLibrary(const std::filesystem::path& library);

  const plumb_kernel& table() const { return *table_; }
  const KernelFacts& facts() const { return facts_; }

 private:
  struct Close {
    void operator()(void* handle) const;
  };
  std::unique_ptr<void, Close> handle_;
  const plumb_kernel* table_;
  KernelFacts facts_;
};

}  // namespace plumb
