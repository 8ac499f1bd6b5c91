#include "conformance/pareto/contender.h"

#include <fnmatch.h>

#include <algorithm>
#include <ranges>

#include "conformance/pareto/tolerant_kernel.h"
#include "conformance/subject/shipped_kernels.h"
#include "renderer/math/input_error.h"
#include "renderer/math/nearest_name.h"

namespace plumb {

bool Contender::attempt(std::string_view what, const std::function<void()>& ask) {
  try {
    ask();
    return true;
  } catch (const SubjectFailure& failure) {
    failures.push_back(name + ": " + std::string(what) + ": " + std::string(to_string(failure.verdict())) + ": " +
                       failure.what());
  } catch (const UnsupportedBySubject& refusal) {
    failures.push_back(name + ": " + std::string(what) + ": " + refusal.what());
  }
  return false;
}

std::vector<Contender*> with_inputs(std::vector<Contender>& contenders, plumb_precision inputs) {
  std::vector<Contender*> chosen;
  for (Contender& contender : contenders)
    if (contender.inputs == inputs) chosen.push_back(&contender);
  return chosen;
}

std::vector<std::string> selected_kernels(const std::vector<std::string>& names, std::string_view filter,
                                          std::string_view always) {
  if (filter.empty()) return names;
  std::vector<bool> chosen(names.size());
  for (const auto range : std::views::split(filter, ',')) {
    const std::string part(range.begin(), range.end());
    bool found = false;
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (::fnmatch(part.c_str(), names[i].c_str(), 0) != 0) continue;
      found = chosen[i] = true;
    }
    if (!found) {
      const std::vector<std::string_view> known(names.begin(), names.end());
      throw InputError({}, "--filter: no shipped kernel matches '" + part + "'" + did_you_mean(part, known));
    }
  }
  std::vector<std::string> selected;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (chosen[i] || names[i] == always) selected.push_back(names[i]);
  return selected;
}

std::vector<Contender> shipped_contenders(const std::vector<std::string>& names, unsigned shape,
                                          unsigned capabilities) {
  std::vector<Contender> of_floats, of_doubles, with_all_bits;
  for (const std::string& name : names) {
    if (name == "empty") continue;
    const auto opened = [&](std::string as, plumb_precision inputs) {
      Contender contender{std::move(as), inputs, nullptr, {}};
      contender.subject = std::make_unique<TolerantKernel>(shipped_kernel(name), contender.not_finite);
      return contender;
    };
    Contender contender = opened(name, PLUMB_FLOAT);
    const Contract& contract = contender.subject->contract();
    if (!(contract.shapes & shape) || (contract.capabilities & capabilities) != capabilities) continue;
    const bool has_doubles = contract.precision == PLUMB_DOUBLE;
    (has_doubles ? of_doubles : of_floats).push_back(std::move(contender));
    if (has_doubles) with_all_bits.push_back(opened(name + "/53", PLUMB_DOUBLE));
  }
  std::vector<Contender> all;
  for (std::vector<Contender>* part : {&of_floats, &of_doubles, &with_all_bits})
    std::ranges::move(*part, std::back_inserter(all));
  return all;
}

}  // namespace plumb
