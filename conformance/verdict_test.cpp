#include "conformance/verdict.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace plumb {
namespace {

struct Named {
  Verdict verdict;
  const char* name;
  bool right;
  int status;
};

const Named kAll[] = {
    {Verdict::pass, "pass", true, 0},
    {Verdict::quality_warning, "quality_warning", true, 0},
    {Verdict::fail, "fail", false, 1},
    {Verdict::timeout, "timeout", false, 1},
    {Verdict::memory_limit, "memory_limit", false, 1},
    {Verdict::output_limit, "output_limit", false, 1},
    {Verdict::crash, "crash", false, 1},
    {Verdict::security, "security", false, 1},
    {Verdict::unsupported, "unsupported", false, 1},
    {Verdict::skipped, "skipped", false, 1},
    {Verdict::internal_error, "internal_error", false, 3},
};

TEST(Verdict, EachHasItsNameAndMeaning) {
  for (const Named& v : kAll) {
    EXPECT_EQ(to_string(v.verdict), v.name);
    EXPECT_EQ(is_right(v.verdict), v.right) << v.name;
    EXPECT_EQ(exit_status({&v.verdict, 1}), v.status) << v.name;
  }
}

TEST(Verdict, TheWorstOfSeveralIsTheExitStatus) {
  EXPECT_EQ(exit_status({}), 0);
  for (const Named& a : kAll)
    for (const Named& b : kAll) {
      const std::vector<Verdict> both{Verdict::pass, a.verdict, b.verdict};
      EXPECT_EQ(exit_status(both), std::max(a.status, b.status)) << a.name << " and " << b.name;
    }
}

TEST(Verdict, ACheckThatSaysNothingIsOurFault) { EXPECT_EQ(CheckResult{}.verdict, Verdict::internal_error); }

}  // namespace
}  // namespace plumb
