#pragma once

#include <span>
#include <string_view>

namespace plumb {

/// The years' versions of the scene format and of the pictures' rules.
enum class Dialect { pa3_2011 };

/// The names that `--dialect` takes.
std::span<const std::string_view> dialect_names();

/// Throws InputError naming the nearest known dialect.
Dialect dialect_named(std::string_view name);

}  // namespace plumb
