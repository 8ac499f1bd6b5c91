#include "conformance/subject/kernel_facts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <string_view>

#include "renderer/math/input_error.h"

namespace plumb {
namespace {

constexpr std::size_t kLongestName = 100;
constexpr std::size_t kLongestDescription = 1000;
constexpr std::uint32_t kAllShapes = PLUMB_MESHES | PLUMB_SPHERES | PLUMB_BOXES | PLUMB_CYLINDERS | PLUMB_CONES;
constexpr std::uint32_t kAllCapabilities =
    PLUMB_TRANSFORMS | PLUMB_ANY_HIT | PLUMB_ALL_HITS | PLUMB_BOUNDS | PLUMB_THREAD_SAFE;

class Refusal {
 public:
  explicit Refusal(const std::filesystem::path& library) : library_(library) {}
  [[noreturn]] void operator()(const std::string& what) const { throw InputError({library_.string(), 0, 0}, what); }

 private:
  const std::filesystem::path& library_;
};

/// The text, or its beginning with one character too many.
std::string bounded(const char* text, std::size_t longest) {
  return text ? std::string(text, ::strnlen(text, longest + 1)) : "";
}

bool is_name(std::string_view name) {
  constexpr std::string_view kAllowed = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_.";
  return !name.empty() && name.size() <= kLongestName && name.find_first_not_of(kAllowed) == std::string_view::npos;
}

bool is_line(std::string_view text) {
  return text.size() <= kLongestDescription && std::ranges::none_of(text, [](unsigned char c) { return c < 0x20; });
}

void check_value(std::uint32_t value, std::uint32_t largest, std::uint32_t smallest, const char* what,
                 const Refusal& refuse) {
  if (value < smallest || value > largest)
    refuse(fmt::format("the contract's {} is {}, expected {} to {}", what, value, smallest, largest));
}

}  // namespace

bool operator==(const KernelFacts& a, const KernelFacts& b) {
  const auto values = [](const plumb_contract& c) {
    return std::array{c.precision, c.t_precision, c.culling, c.edge_rule, c.range, c.inside, c.shapes, c.capabilities};
  };
  return a.name == b.name && a.description == b.description && values(a.contract) == values(b.contract) &&
         a.contract.largest == b.contract.largest;
}

KernelFacts read_facts(const plumb_kernel* table, const std::filesystem::path& library) {
  const Refusal refuse(library);
  if (!table) refuse(PLUMB_KERNEL_ENTRY " returned null, expected a table");
  if (table->version != PLUMB_KERNEL_VERSION)
    refuse(fmt::format("the kernel's table is of version {}, expected {}", table->version, PLUMB_KERNEL_VERSION));
  if (table->size != sizeof(plumb_kernel))
    refuse(fmt::format("the kernel's table has {} bytes, expected {}", table->size, sizeof(plumb_kernel)));
  if (!table->build || !table->destroy || !table->closest_hit)
    refuse("one of the functions build, destroy and closest_hit is null");
  const std::uint32_t can = table->contract.capabilities;
  if (((can & PLUMB_ANY_HIT) && !table->any_hit) || ((can & PLUMB_ALL_HITS) && !table->all_hits) ||
      ((can & PLUMB_BOUNDS) && !table->bounds))
    refuse("the contract declares a capability whose function is null");
  return {bounded(table->name, kLongestName), bounded(table->description, kLongestDescription), table->contract};
}

Contract checked_contract(const KernelFacts& facts, const std::filesystem::path& library) {
  const Refusal refuse(library);
  if (!is_name(facts.name))
    refuse("the kernel's name is empty, long, or has other characters than letters, digits, '-', '_' and '.'");
  if (!is_line(facts.description)) refuse("the kernel's description is not one line of at most 1000 characters");
  const plumb_contract& said = facts.contract;
  check_value(said.precision, PLUMB_DOUBLE, PLUMB_FLOAT, "precision", refuse);
  check_value(said.t_precision, PLUMB_DOUBLE, PLUMB_FLOAT, "t_precision", refuse);
  check_value(said.culling, PLUMB_CULL_BACK, PLUMB_CULL_NONE, "culling", refuse);
  check_value(said.edge_rule, PLUMB_EDGE_NONE, PLUMB_EDGE_CLOSED, "edge_rule", refuse);
  check_value(said.range, PLUMB_RANGE_OPEN, PLUMB_RANGE_CLOSED, "range", refuse);
  check_value(said.inside, PLUMB_INSIDE_MISSES, PLUMB_INSIDE_HITS_EXIT, "inside", refuse);
  check_value(said.shapes, kAllShapes, 1, "shapes", refuse);
  check_value(said.capabilities, kAllCapabilities, 0, "capabilities", refuse);
  if (!(said.largest >= 0)) refuse(fmt::format("the contract's largest is {}, expected 0 or more", said.largest));

  Contract contract;
  contract.precision = static_cast<plumb_precision>(said.precision);
  contract.t_precision = static_cast<plumb_precision>(said.t_precision);
  contract.culling = static_cast<plumb_culling>(said.culling);
  contract.edge_rule = static_cast<plumb_edge_rule>(said.edge_rule);
  contract.range = static_cast<plumb_range>(said.range);
  contract.inside = static_cast<plumb_inside>(said.inside);
  contract.shapes = said.shapes;
  contract.capabilities = said.capabilities;
  if (said.largest > 0) contract.largest = said.largest;
  return contract;
}

}  // namespace plumb
