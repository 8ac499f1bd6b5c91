#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "conformance/judge/suite.h"

namespace plumb {

class TomlFields;

/// The fields of a [runner] that say how a program is built and run; checks them, unknown placeholders included. Throws
/// InputError.
Runner read_runner_fields(TomlFields& fields);

/// Throws InputError at the key unless `path` is relative and stays below where it starts.
void require_inner_path(const TomlFields& fields, std::string_view key, const std::string& path);

}  // namespace plumb
