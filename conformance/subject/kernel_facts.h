#pragma once

#include <filesystem>
#include <string>

#include "conformance/kernel/plumb_kernel.h"
#include "conformance/subject/contract.h"

namespace plumb {

/// What a kernel's table says of itself, as it stands there.
struct KernelFacts {
  std::string name, description;
  plumb_contract contract{};
  friend bool operator==(const KernelFacts& a, const KernelFacts& b);
};

/// Reads a table that a library returned. Throws InputError, at the library, for null, another version or size, a
/// missing function, and a function whose capability is declared.
KernelFacts read_facts(const plumb_kernel* table, const std::filesystem::path& library);

/// The contract, once every value is one of its enumeration, and name and description are text of one line. Throws
/// InputError at the library.
Contract checked_contract(const KernelFacts& facts, const std::filesystem::path& library);

}  // namespace plumb
