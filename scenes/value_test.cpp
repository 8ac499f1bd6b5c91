#include "scenes/value.h"

#include <gmock/gmock.h>

#include <cmath>

namespace plumb {
namespace {

const SourceLocation kHere{"a.xml", 4, 7};

Parameter parameter(ValueType type, Range range = Range::any) {
  return {.name = "thing", .type = type, .meaning = "", .range = range};
}

/// The text of the error, or nothing if the text is a value.
std::string refusal(const Parameter& what, std::string_view text) {
  try {
    parse_value(what, text, kHere);
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    return error.what();
  }
  return "";
}

double number(std::string_view text) {
  return std::get<double>(parse_value(parameter(ValueType::number), text, kHere));
}

TEST(Value, NumbersOfEveryNotation) {
  EXPECT_EQ(number("3"), 3);
  EXPECT_EQ(number("-.5"), -0.5);
  EXPECT_EQ(number("+2.5"), 2.5);
  EXPECT_EQ(number("1e-3"), 1e-3);
  EXPECT_EQ(number("2.E2"), 200);
  EXPECT_EQ(number("0.1"), 0.1) << "the nearest double";
  EXPECT_EQ(number("4.9406564584124654e-324"), 4.9406564584124654e-324) << "the smallest double";
  EXPECT_TRUE(std::signbit(number("-0")));
}

TEST(Value, AnyWhiteSpaceSeparates) {
  const Value value = parse_value(parameter(ValueType::vector), "\r\n\t 1 \f 2\v\n3\r\n", kHere);
  EXPECT_EQ(std::get<Vec3>(value), (Vec3{1, 2, 3}));
}

TEST(Value, PointVectorAndColorAreThreeNumbers) {
  for (const ValueType type : {ValueType::point, ValueType::vector, ValueType::color}) {
    EXPECT_EQ(std::get<Vec3>(parse_value(parameter(type), "1 -2 .5", kHere)), (Vec3{1, -2, 0.5}));
  }
}

TEST(Value, SizeIsTwoWholeNumbersAndIntegerOne) {
  EXPECT_EQ(std::get<Size2>(parse_value(parameter(ValueType::size), "640 480", kHere)), (Size2{640, 480}));
  EXPECT_EQ(std::get<int>(parse_value(parameter(ValueType::integer), "-12", kHere)), -12);
}

TEST(Value, FileKeepsInnerSpaces) {
  EXPECT_EQ(std::get<std::string>(parse_value(parameter(ValueType::file), "\n a b.msh \t", kHere)), "a b.msh");
}

struct Refusal {
  ValueType type;
  Range range;
  const char* text;
  const char* expected;
};

TEST(Value, RefusalsSayWhatWasFoundAndExpected) {
  constexpr Range kAny = Range::any;
  const Refusal rows[] = {
      {ValueType::number, kAny, "", "a.xml:4:7: <thing>: found nothing, expected one number"},
      {ValueType::number, kAny, " \n ", "found nothing, expected one number"},
      {ValueType::number, kAny, "1 2", "found 2 values, expected one number"},
      {ValueType::point, kAny, "1 2", "found 2 values, expected three numbers (x y z)"},
      {ValueType::point, kAny, "1", "found 1 value, expected three numbers (x y z)"},
      {ValueType::color, kAny, "1 2 3 4", "found 4 values, expected three numbers (red green blue)"},
      {ValueType::size, kAny, "100", "found 1 value, expected two whole numbers (width height)"},
      {ValueType::number, kAny, "one", "'one' is no such number"},
      {ValueType::number, kAny, "1,5", "'1,5' is no such number"},
      {ValueType::number, kAny, "1.5f", "'1.5f' is no such number"},
      {ValueType::number, kAny, "0x10", "'0x10' is no such number"},
      {ValueType::number, kAny, "+-1", "'+-1' is no such number"},
      {ValueType::number, kAny, "+", "'+' is no such number"},
      {ValueType::number, kAny, "--1", "'--1' is no such number"},
      {ValueType::vector, kAny, "1 2 3,", "'3,' is no such number"},
      {ValueType::number, kAny, "nan", "'nan' is not a finite number"},
      {ValueType::number, kAny, "NaN", "'NaN' is not a finite number"},
      {ValueType::number, kAny, "-inf", "'-inf' is not a finite number"},
      {ValueType::number, kAny, "Infinity", "'Infinity' is not a finite number"},
      {ValueType::vector, kAny, "0 inf 0", "'inf' is not a finite number"},
      {ValueType::number, kAny, "1e400", "'1e400' is out of range"},
      {ValueType::number, kAny, "-1e400", "'-1e400' is out of range"},
      {ValueType::integer, kAny, "1.0", "'1.0' is no such number, expected one whole number"},
      {ValueType::integer, kAny, "99999999999", "'99999999999' is out of range"},
      {ValueType::number, Range::not_negative, "-1e-300", "<thing> must not be negative, but it is -1e-300"},
      {ValueType::number, Range::positive, "0", "<thing> must be greater than zero, but it is 0"},
      {ValueType::number, Range::positive, "-0", "<thing> must be greater than zero, but it is -0"},
      {ValueType::size, Range::positive, "0 5", "<thing> must be greater than zero, but it is 0"},
      {ValueType::size, Range::positive, "5 0", "<thing> must be greater than zero"},
      {ValueType::integer, Range::not_negative, "-1", "<thing> must not be negative, but it is -1"},
      {ValueType::vector, Range::not_negative, "1 1 -1", "<thing> must not be negative"},
      {ValueType::file, kAny, " \n", "<thing> is empty, expected a file name"},
  };
  for (const Refusal& row : rows) {
    const std::string message = refusal(parameter(row.type, row.range), row.text);
    EXPECT_THAT(message, ::testing::HasSubstr(row.expected)) << "text '" << row.text << "'";
    EXPECT_TRUE(message.starts_with("a.xml:4:7: ")) << message;
  }
}

TEST(Value, RangesAcceptTheirEnds) {
  EXPECT_EQ(refusal(parameter(ValueType::number, Range::not_negative), "0"), "");
  EXPECT_EQ(refusal(parameter(ValueType::number, Range::not_negative), "-0"), "");
  EXPECT_EQ(refusal(parameter(ValueType::number, Range::positive), "4.9406564584124654e-324"), "");
}

TEST(Value, ControlCharactersOfTheTextAreMadeHarmless) {
  EXPECT_EQ(refusal(parameter(ValueType::number), "\x1b[31m").find('\x1b'), std::string::npos);
}

TEST(Value, AnObjectIsNoText) { EXPECT_THROW(parse_value(parameter(ValueType::object), "1", kHere), std::logic_error); }

TEST(Value, NothingAboveTheLargestIsAccepted) {
  Parameter samples = parameter(ValueType::integer);
  samples.largest = 8;
  EXPECT_EQ(refusal(samples, "8"), "");
  EXPECT_EQ(refusal(samples, "9"), "a.xml:4:7: <thing> must be at most 8, but it is 9");
}

}  // namespace
}  // namespace plumb
