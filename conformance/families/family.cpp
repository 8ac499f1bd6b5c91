#include "conformance/families/family.h"

#include <string>

#include "renderer/math/input_error.h"
#include "renderer/math/nearest_name.h"

namespace plumb {

const FamilyKind& family_kind(std::string_view id) {
  std::vector<std::string_view> ids;
  for (const FamilyKind* kind : family_kinds()) {
    if (kind->id == id) return *kind;
    ids.push_back(kind->id);
  }
  throw InputError({}, "there is no family '" + std::string(id) + "'" + did_you_mean(id, ids));
}

}  // namespace plumb
