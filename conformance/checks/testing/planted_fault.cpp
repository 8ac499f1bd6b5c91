#include "conformance/checks/testing/planted_fault.h"

namespace plumb::planted {

std::function<std::unique_ptr<Subject>()> spoiled(std::function<void(Formulas&)> spoil) {
  return [spoil = std::move(spoil)] {
    Formulas formulas = right_formulas();
    spoil(formulas);
    return std::make_unique<FormulaSubject>(std::move(formulas));
  };
}

std::function<std::unique_ptr<Subject>()> kernel_with(
    std::function<std::vector<LocalHit>(const Shape&, const Ray&)> hits) {
  return spoiled([hits = std::move(hits)](Formulas& f) {
    f.contract.matrices = false;
    f.hits = hits;
  });
}

}  // namespace plumb::planted
