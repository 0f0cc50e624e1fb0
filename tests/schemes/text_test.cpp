#include "schemes/text.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace subdiv {
namespace {

TEST(Text, QuotesHideWhatATerminalWouldActOn) {
  EXPECT_EQ(in_quotes("w=1/16"), "'w=1/16'");
  EXPECT_EQ(in_quotes("a\x1b[31m\n.\xff"), "'a?[31m?.?'");
  EXPECT_EQ(in_quotes(std::string(60, 'a')), "'" + std::string(60, 'a') + "'");
  EXPECT_EQ(in_quotes(std::string(61, 'a')), "'" + std::string(60, 'a') + "...'");
}

TEST(Text, TrimsWhiteSpaceAtBothEnds) {
  EXPECT_EQ(trimmed("  a b\t\n"), "a b");
  EXPECT_EQ(trimmed(" \n "), "");
  EXPECT_EQ(trimmed(""), "");
}

TEST(Text, JoinsAsInASentence) {
  const std::vector<std::string> words{"a", "b", "c"};
  EXPECT_EQ(joined(words), "a, b or c");
  EXPECT_EQ(joined(words, "and"), "a, b and c");
  EXPECT_EQ(joined(std::vector<std::string>{"a"}), "a");
  EXPECT_EQ(joined(std::vector<std::string>{}), "");
}

TEST(Text, FindsTheNearestWord) {
  const std::vector<std::string> known{"jspline", "bspline", "four-point", "deslauriers-dubuc"};
  EXPECT_EQ(nearest("jsplin", known), "jspline");
  EXPECT_EQ(nearest("BSPLINE", known), "bspline");
  EXPECT_EQ(nearest("fuor-point", known), "four-point");  // neighbours swapped: one error
  EXPECT_EQ(nearest("deslaurier-dubuque", known), "deslauriers-dubuc");
  EXPECT_EQ(nearest("catmull-clark", known), "");
  EXPECT_EQ(nearest("", known), "");
  EXPECT_EQ(nearest("x", std::vector<std::string>{"w"}), "");
  EXPECT_EQ(nearest(std::string(100'000, 'j'), known), "");
}

TEST(Text, SuggestionsEndASentence) {
  const std::vector<std::string> known{"degree"};
  EXPECT_EQ(suggestion("degre", known), "; did you mean 'degree'?");
  EXPECT_EQ(suggestion("zzz", known), ".");
}

TEST(Text, LocatesAColumn) {
  EXPECT_EQ(located("1/(6+s)", 1, "no"), "column 2 of '1/(6+s)': no");
  const std::string shown = located(std::string(200, 'a') + "X" + std::string(200, 'b'), 200, "no");
  EXPECT_EQ(shown, "column 201 of '..." + std::string(30, 'a') + "X" + std::string(19, 'b') + "...': no");
  EXPECT_EQ(located("abc", 3, "ends"), "column 4 of 'abc': ends");
}

}  // namespace
}  // namespace subdiv
