#include "schemes/scheme_description.h"

#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/schemes/input_errors.h"

namespace subdiv {
namespace {

using testing::expect_input_error;
using testing::ScratchFolder;
using Strings = std::vector<std::string>;

/// name=value for every parameter of a step.
Strings arguments(const StepDescription& step) {
  Strings result;
  for (const Argument& a : step.arguments) result.push_back(a.name + "=" + a.value.text());
  return result;
}

TEST(SchemeSyntax, NamesAFamilyWithItsDefaults) {
  const SchemeDescription scheme = parse_scheme("  four-point ");
  EXPECT_EQ(scheme.text, "four-point");
  ASSERT_EQ(scheme.steps.size(), 1U);
  EXPECT_EQ(scheme.steps[0].name(), "four-point");
  EXPECT_EQ(arguments(scheme.steps[0]), Strings{"w=1/16"});
  EXPECT_TRUE(scheme.free_parameters.empty());
}

TEST(SchemeSyntax, JoinsStepsByPlus) {
  const SchemeDescription scheme =
      parse_scheme("jspline:s=-33/26 + jspline : b = 1 , a = 1/2+bspline:degree=4");
  ASSERT_EQ(scheme.steps.size(), 3U);
  EXPECT_EQ(scheme.steps[0].text, "jspline:s=-33/26");
  EXPECT_EQ(arguments(scheme.steps[1]), (Strings{"a=1/2", "b=1"}));  // in the family's order
  EXPECT_EQ(scheme.steps[2].whole, std::vector<long>{4});
}

TEST(SchemeSyntax, SumsInValuesStandInParentheses) {
  EXPECT_EQ(arguments(parse_scheme("jspline:s=(1+1/2)").steps[0]), Strings{"s=(1+1/2)"});
  EXPECT_EQ(arguments(parse_scheme("jspline:s=2-1/2").steps[0]), Strings{"s=2-1/2"});
  EXPECT_EQ(arguments(parse_scheme("jspline:s=sqrt(4+5)").steps[0]), Strings{"s=sqrt(4+5)"});
  EXPECT_EQ(parse_scheme("jspline:a=(1+1),b=((2+1)+1)+jspline:s=1").steps.size(), 2U);
  // The sign of a decimal's exponent joins nothing.
  EXPECT_EQ(arguments(parse_scheme("jspline:s=1.5e+0").steps[0]), Strings{"s=1.5e+0"});
  expect_input_error([] { return parse_scheme("jspline:s=1+1"); }, {"scheme '1'", "unknown scheme"});
}

TEST(SchemeSyntax, NamesInValuesAreFreeByFirstAppearance) {
  EXPECT_EQ(parse_scheme("jspline:s=s").free_parameters, Strings{"s"});
  EXPECT_EQ(parse_scheme("jspline:b=y,a=x+jspline:s=y").free_parameters, (Strings{"y", "x"}));
  EXPECT_EQ(parse_scheme("jspline:a=r,b=(2*r-q)").free_parameters, (Strings{"r", "q"}));
  EXPECT_TRUE(parse_scheme("jspline:s=sqrt(2)").free_parameters.empty());
  expect_input_error(
      [] { return parse_scheme("jspline:a=p,b=q+jspline:a=r,b=t+jspline:a=u,b=v+jspline:s=w"); },
      {"more than 6 free parameters", "p, q, r, t, u, v and w", "give some of them values"});
}

TEST(SchemeSyntax, ReadsFilesWithOverriddenParameters) {
  const ScratchFolder folder;
  const std::string path =
      folder.write("mine.json", R"json({"name": "mine", "arity": 2, "parameters": {"w": "1/16", "v": 2},
                       "mask": {"first": -1, "coefficients": ["1/2+w-w*v/2", 1, "1/2-w+w*v/2"]}})json");
  const SchemeDescription scheme = parse_scheme(path + ":w=u+" + path);
  ASSERT_EQ(scheme.steps.size(), 2U);
  EXPECT_EQ(scheme.steps[0].name(), "mine");
  EXPECT_EQ(arguments(scheme.steps[0]), (Strings{"w=u", "v=2"}));
  EXPECT_EQ(arguments(scheme.steps[1]), (Strings{"w=1/16", "v=2"}));
  EXPECT_EQ(scheme.free_parameters, Strings{"u"});
  expect_input_error([&] { return parse_scheme(path + ":x=1"); },
                     {"mine.json has no parameter 'x'", "The file declares w and v"});
}

TEST(SchemeSyntax, ErrorsNameTheStepAndTheRemedy) {
  struct Case {
    const char* text;
    std::vector<const char*> pieces;
  };
  for (const Case& c : std::vector<Case>{
           {"", {"empty", "jspline:s=3/2"}},
           {" \t ", {"empty"}},
           {"jsplin:s=1", {"scheme 'jsplin:s=1'", "did you mean 'jspline'?", "four-point"}},
           {"jspline:s=1+jsplin:s=1", {"scheme 'jsplin:s=1'"}},
           {"jspline:t=1", {"no parameter 't'", "s, or a and b"}},
           {"jspline", {"missing", "s, or a and b"}},
           {"jspline:", {"gives no value", "s=3/2"}},
           {"jspline:s", {"'s' gives no value", "parameter=value"}},
           {"jspline:s=", {"value of 's'", "empty expression"}},
           {"jspline:=1", {"names no parameter"}},
           {"jspline:s=1,s=2", {"'s' is given twice"}},
           {"jspline:s=1,", {"gives no value"}},
           {"jspline:s=1+", {"name is missing", "one '+'"}},
           {"+jspline:s=1", {"name is missing"}},
           {"jspline:s=1++jspline:s=1", {"name is missing"}},
           {"jspline:s=(1", {"value of 's'", "column 3", "expected ')'"}},
           {"jspline:s=1)", {"value of 's'", "')' without its '('"}},
           {"jspline:s=1/(2-2)", {"'jspline:s=1/(2-2)'", "value of s", "division by zero", "'(2-2)' is 0"}},
           {"jspline:s=sqrt(1-2)", {"value of s", "negative number"}},
           {"jspline:s=nan", {"value of s", "'nan' is neither a finite number"}},
           {"jspline:s=inf", {"'inf'"}},
           {"jspline:s=z", {"'z' is the symbol's indeterminate"}},
           {"jspline:s=1;b=2", {"value of 's'", "expected an operator"}},
           {"bspline", {"bspline takes degree", "bspline:degree=3"}},
           {"bspline:degree=201", {"degree must be a whole number from 0 to 200", "'201'"}},
           {"bspline:degree=-1", {"from 0 to 200", "'-1'"}},
           {"bspline:degree=5/2", {"from 0 to 200", "'5/2'"}},
           {"bspline:degree=99999999999999999999999", {"from 0 to 200"}},
           {"bspline:degree=d", {"cannot be left free as 'd'"}},
           {"bspline:degree=sqrt(2)", {"degree must be a whole number", "column 1", "irrational"}},
           {"deslauriers-dubuc:points=5", {"points must be an even number from 2 to 64", "'5'"}},
           {"deslauriers-dubuc:points=66", {"even number from 2 to 64"}},
           {"nowhere/none.json", {"nowhere/none.json", "no such file"}},
           {"scheme.txt", {"unknown scheme 'scheme.txt'", ".json"}}}) {
    expect_input_error([&] { return parse_scheme(c.text); }, {});
    for (const char* piece : c.pieces) expect_input_error([&] { return parse_scheme(c.text); }, {piece});
  }
}

TEST(SchemeSyntax, StepsMustShareTheArity) {
  const ScratchFolder folder;
  const std::string ternary =
      folder.write("ternary.json", R"json({"name": "t", "arity": 3, "symbol": "3*((1+z+z^2)/3)^2"})json");
  EXPECT_NO_THROW(parse_scheme(ternary + "+" + ternary));
  expect_input_error([&] { return parse_scheme("jspline:s=1+" + ternary); },
                     {"different arity", "'jspline:s=1' has arity 2", "has arity 3"});
}

TEST(SchemeSyntax, LengthIsLimited) {
  std::string many = "jspline:s=1";
  for (int i = 0; i < 1000; ++i) many += "+jspline:s=1";
  expect_input_error([&] { return parse_scheme(many); }, {"more than 1000 steps"});
  expect_input_error([] { return parse_scheme("jspline:s=" + std::string(90'000, '(')); },
                     {"nested parentheses"});
}

TEST(SchemeSyntax, MasksAreCheckedAtTheGivenValues) {
  const ScratchFolder folder;
  const std::string pole =
      folder.write("pole.json", R"json({"name": "pole", "arity": 2, "parameters": {"s": 0},
    "mask": {"first": 0, "coefficients": ["1/2",
      "s/(6+s)", "1/2", "6/(6+s)", 1, "-1+0"]}})json");
  EXPECT_NO_THROW(parse_scheme(pole));
  EXPECT_NO_THROW(parse_scheme(pole + ":s=s"));  // the sum is 2 for every s
  expect_input_error([&] { return parse_scheme(pole + ":s=-6"); },
                     {"pole.json:3: coefficient 2 (of z^1)", "column 2 of 's/(6+s)'", "division by zero",
                      "'(6+s)' is 0", "at s = -6"});
  const std::string one_point =
      folder.write("sum.json", R"json({"name": "sum", "arity": 2, "parameters": {"s": 1},
    "mask": {"first": 0, "coefficients": ["s/3", 1, "2/3"]}})json");
  EXPECT_NO_THROW(parse_scheme(one_point));
  expect_input_error([&] { return parse_scheme(one_point + ":s=1/2"); },
                     {"sum.json", "sum to 11/6 at s = 1/2", "not to the arity 2", "minus 2 is -1/6"});
  expect_input_error([&] { return parse_scheme(one_point + ":s=t"); },
                     {"sum to (t + 5)/3", "minus 2 is (t - 1)/3", "for all values of the free parameters"});
}

TEST(SchemeSyntax, MasksAreNotZeroNotTooLongAndSumToTheArity) {
  const ScratchFolder folder;
  const std::string zero =
      folder.write("zero.json", R"json({"name": "zero", "arity": 2, "parameters": {"s": 0},
    "mask": {"first": 0, "coefficients": ["s", "-s"]}})json");
  expect_input_error([&] { return parse_scheme(zero); }, {"zero.json", "the mask is zero at s = 0"});
  expect_input_error([&] { return parse_scheme(zero + ":s=1"); }, {"sum to 0 at s = 1"});
  const std::string three =
      folder.write("three.json", R"json({"name": "three", "arity": 3, "symbol": "2*((1+z)/2)^4"})json");
  expect_input_error([&] { return parse_scheme(three); }, {"sum to 2", "arity 3"});
  const std::string root = folder.write("root.json", R"json({"name": "r", "arity": 2,
    "mask": {"first": 0, "coefficients": ["sqrt(2)", "1/2"]}})json");
  expect_input_error([&] { return parse_scheme(root); }, {"(1+2*sqrt(2))/2", "(-3+2*sqrt(2))/2"});
  const std::string wide =
      folder.write("wide.json", R"json({"name": "w", "arity": 2, "symbol": "2*z^-600*((1+z^3)/2)^400"})json");
  expect_input_error([&] { return parse_scheme(wide); }, {"1201 coefficients", "at most 1000"});
}

TEST(RoundedMasks, MissTheSumByARoundingErrorUnlessAskedFor) {
  const ScratchFolder folder;
  // Daubechies' order 2, (1+sqrt 3)/4 .., to 6 decimals; the last one rounded the wrong way.
  const std::string off = folder.write("off.json", R"json({"name": "off", "arity": 2,
        "mask": {"first": 0, "coefficients": [0.683013, 1.183013, 0.316987, "-0.183012"]}})json");
  expect_input_error(
      [&] { return parse_scheme(off); },
      {"off.json", "sum to 2.000001,", "minus 2 is 0.000001,",
       "no more than the rounding of the written decimals", "as fractions or with sqrt", "--rounded"});
  const SchemeDescription rounded = parse_scheme(off, {.rounded = true});
  EXPECT_TRUE(rounded.rounded);
  // Too far for rounding: no advice to ask for it, and no pardon.
  const std::string wrong = folder.write("wrong.json", R"json({"name": "wrong", "arity": 2,
        "mask": {"first": 0, "coefficients": ["0.68", "1.18", "0.29", "-0.18"]}})json");
  try {
    static_cast<void>(parse_scheme(wrong));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).find("rounding"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("mend the coefficients"), std::string::npos) << error.what();
  }
  const std::string far = folder.write("far.json", R"json({"name": "far", "arity": 2,
        "mask": {"first": 0, "coefficients": ["0.68", "1.18", "0.21", "-0.18"]}})json");
  expect_input_error([&] { return parse_scheme(far, {.rounded = true}); },
                     {"far.json", "more than the rounding of the decimals explains"});
  // Integers and fractions are exact: nothing to round.
  const std::string exact = folder.write("exact.json", R"json({"name": "exact", "arity": 2,
        "mask": {"first": 0, "coefficients": ["2/3", 1]}})json");
  expect_input_error([&] { return parse_scheme(exact, {.rounded = true}); }, {"exact.json", "sum"});
}

}  // namespace
}  // namespace subdiv
