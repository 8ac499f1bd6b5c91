#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "conformance/judge/suite.h"
#include "conformance/verdict.h"

namespace plumb {

/// A program with the verbs `render` and `probe` of plumb, graded as a submission is: each of the cases by itself,
/// whatever it requires. `variants` are those that the cases have envelopes for. Returns the results by case id.
/// `progress` is told what is run. An interrupt (interrupt_flag) leaves the remaining cases skipped.
std::map<std::string, CheckResult> grade_program(const std::filesystem::path& program,
                                                 const std::vector<Variant>& variants, std::vector<SuiteCase> cases,
                                                 const std::function<void(const std::string&)>& progress);

}  // namespace plumb
