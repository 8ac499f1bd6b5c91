#include <gmock/gmock.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <string>

#include "conformance/checks/check.h"
#include "conformance/checks/testing/planted_fault.h"
#include "conformance/subject/kernel_subject.h"

namespace plumb::planted {
namespace {

std::vector<Fault> all_faults() {
  std::vector<Fault> all;
  for (const auto& some : {triangle_faults(), box_faults(), round_solid_faults(), transform_faults(), bounds_faults(),
                           search_faults(), optics_faults()})
    all.insert(all.end(), some.begin(), some.end());
  return all;
}

const CheckKind& check_named(std::string_view id) {
  const auto found = std::ranges::find(check_kinds(), id, &CheckKind::id);
  if (found == check_kinds().end()) throw std::out_of_range("no check " + std::string(id));
  return **found;
}

std::unique_ptr<Subject> right_subject(Right right) {
  if (right == Right::tracer) return std::make_unique<LocalKernelSubject>(PLUMB_TRACER_KERNEL);
  return std::make_unique<FormulaSubject>(right_formulas());
}

CheckResult asked(const Fault& fault, Subject& subject) {
  CheckOptions options;
  options.intensity = fault.intensity;
  options.seed = 7;
  return run_check(check_named(fault.check), subject, options);
}

std::string said(const CheckResult& result) {
  std::string text = std::string(to_string(result.verdict)) + " (" + result.cause + "): " + result.summary;
  for (const auto& [name, value] : result.evidence)
    if (const auto* sentence = std::get_if<std::string>(&value)) text += "\n  " + name + ": " + *sentence;
  return text;
}

class PlantedFault : public ::testing::TestWithParam<Fault> {};

TEST_P(PlantedFault, IsFoundAndTheRightSubjectPasses) {
  const Fault& fault = GetParam();
  const CheckResult wrong = asked(fault, *fault.wrong());
  EXPECT_EQ(to_string(wrong.verdict), to_string(fault.verdict)) << fault.mistake << "\n" << said(wrong);
  EXPECT_EQ(wrong.cause, fault.cause) << fault.mistake << "\n" << said(wrong);
  EXPECT_FALSE(wrong.summary.empty());
  const CheckResult right = asked(fault, *right_subject(fault.right));
  EXPECT_EQ(to_string(right.verdict), "pass") << said(right);
  EXPECT_EQ(right.cause, "");
}

std::string test_name(const ::testing::TestParamInfo<Fault>& info) {
  std::string name = std::string(info.param.check) + "_" + std::string(info.param.mistake);
  std::ranges::replace_if(
      name, [](unsigned char c) { return !std::isalnum(c); }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(All, PlantedFault, ::testing::ValuesIn(all_faults()), test_name);

TEST(PlantedFaults, EveryCheckHasOne) {
  std::set<std::string_view> with_fault, all;
  for (const Fault& fault : all_faults()) with_fault.insert(fault.check);
  for (const CheckKind* check : check_kinds()) all.insert(check->id);
  EXPECT_EQ(with_fault, all);
  EXPECT_GE(all.size(), 43u);
}

/// What the wrong ones are made of is itself right: what they fail for is the mistake that was put in.
TEST(PlantedFaults, TheFormulasThemselvesPassEveryCheck) {
  FormulaSubject subject(right_formulas());
  for (const CheckKind* check : check_kinds()) {
    CheckOptions options;
    options.intensity = 0.001;
    options.seed = 7;
    const CheckResult result = run_check(*check, subject, options);
    EXPECT_EQ(to_string(result.verdict), "pass") << check->id << ": " << said(result);
  }
}

}  // namespace
}  // namespace plumb::planted
