#include "experiments/report/figure_text.h"

#include <gtest/gtest.h>

namespace subdiv {
namespace {

TEST(GnuplotText, MakesIndicesAndPowersAndKeepsOtherSigns) {
  EXPECT_EQ(gnuplot_text("J_{3/8}, C^m"), "'J_{/*1.1 3/8}, C^{/*1.1 m}'");
  EXPECT_EQ(gnuplot_text("*J_0.5, and J_-7/4,59/52."), "'*J_{/*1.1 0.5}, and J_{/*1.1 -7/4,59/52}.'");
  EXPECT_EQ(gnuplot_text("{J_r, *J_s}"), "'\\{J_{/*1.1 r}, *J_{/*1.1 s}\\}'");
  EXPECT_EQ(gnuplot_text("It's a_ b@c & ~5%"), "'It''s a\\_ b\\@c \\& \\~5%'");
}

TEST(PlainText, IsWhatIsReadAloud) {
  EXPECT_EQ(plain_text("{J_{-7/4,59/52}, *J_3/2}"), "{J-7/4,59/52, *J3/2}");
  EXPECT_EQ(plain_text("C^m"), "C^m");
}

TEST(Wrapped, BreaksAtSpacesWhereTheDrawnLineIsFull) {
  EXPECT_EQ(wrapped("one two three", 7), (std::vector<std::string>{"one two", "three"}));
  EXPECT_EQ(wrapped("J_{1/2} J_{1/3}", 9), (std::vector<std::string>{"J_{1/2} J_{1/3}"}))
      << "signs take no room";
  EXPECT_EQ(wrapped("unbreakable", 3), (std::vector<std::string>{"unbreakable"}));
  EXPECT_TRUE(wrapped("", 3).empty());
}

}  // namespace
}  // namespace subdiv
