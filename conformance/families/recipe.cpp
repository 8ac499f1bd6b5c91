#include "conformance/families/recipe.h"

namespace plumb {
namespace {

class RecipeFamily : public Family {
 public:
  RecipeFamily(std::string_view id, Recipe recipe, std::uint64_t seed, plumb_precision precision)
      : id_(id), recipe_(recipe), seed_(seed), rounded_(precision) {}

  FamilyCase next() override {
    Random random(seed_, id_, index_++);
    return recipe_(random, rounded_);
  }

 private:
  std::string_view id_;
  Recipe recipe_;
  std::uint64_t seed_;
  Rounding rounded_;
  std::uint64_t index_ = 0;
};

}  // namespace

std::unique_ptr<Family> family_of(std::string_view id, Recipe recipe, std::uint64_t seed, plumb_precision precision) {
  return std::make_unique<RecipeFamily>(id, recipe, seed, precision);
}

}  // namespace plumb
