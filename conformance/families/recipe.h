#pragma once

#include "conformance/families/family.h"
#include "conformance/families/random.h"
#include "conformance/families/rounding.h"

namespace plumb {

/// How many rays a case has.
constexpr std::size_t kRaysPerCase = 12;

/// Makes one case out of random numbers; every number that it puts into the case has gone through `rounded`.
using Recipe = FamilyCase (*)(Random& random, const Rounding& rounded);

/// The family whose n-th case is the recipe's with the n-th random source of the stream `id`.
std::unique_ptr<Family> family_of(std::string_view id, Recipe recipe, std::uint64_t seed, plumb_precision precision);

}  // namespace plumb
