#include "scenes/dialect.h"

#include <array>
#include <string>

#include "renderer/math/input_error.h"
#include "renderer/math/nearest_name.h"

namespace plumb {
namespace {
constexpr std::array<std::string_view, 1> kNames{"pa3-2011"};
}

std::span<const std::string_view> dialect_names() { return kNames; }

Dialect dialect_named(std::string_view name) {
  for (std::size_t i = 0; i < kNames.size(); ++i)
    if (kNames[i] == name) return static_cast<Dialect>(i);
  throw InputError({}, "unknown dialect '" + std::string(name) + "', expected pa3-2011" + did_you_mean(name, kNames));
}

}  // namespace plumb
