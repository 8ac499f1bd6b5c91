#include "renderer/math/input_error.h"

#include <gtest/gtest.h>

namespace plumb {
namespace {

TEST(InputError, NamesThePlaceOnce) {
  EXPECT_STREQ(InputError({"a.xml", 3, 7}, "unknown tag").what(), "a.xml:3:7: unknown tag");
  EXPECT_STREQ(InputError({"a.xml", 3}, "short").what(), "a.xml:3: short");
  EXPECT_STREQ(InputError({"a.xml"}, "cannot open").what(), "a.xml: cannot open");
  EXPECT_STREQ(InputError({}, "no such option").what(), "no such option");
}

TEST(InputError, StaysOneLineWhateverTheInputHolds) {
  EXPECT_STREQ(InputError({"a\nb.xml", 1, 1}, "tag \x1b[31m").what(), "a?b.xml:1:1: tag ?[31m");
}

}  // namespace
}  // namespace plumb
