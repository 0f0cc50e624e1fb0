#include "experiments/report/gnuplot.h"

#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace subdiv {
namespace {

const std::vector<Series> squares{
    {"squares", {"x", "y", "name"}, {{"1", "1.0", "a"}, {"2", "4.0", "b"}, {"", "", ""}, {"3", "9.0", "c"}}}};

Figure figure_of(const std::string& x, const std::string& y) {
  return {"figure", "It's φ", "x", "y", {{"squares", x, y, "squares"}}, ""};
}

TEST(FigureScript, TakesColumnsByNameAndBreaksCurvesAtEmptyCells) {
  const std::string script = figure_script(figure_of("x", "y"), squares);
  EXPECT_NE(script.find("1 1.0\n2 4.0\n\n3 9.0\n"), std::string::npos) << script;
  EXPECT_NE(script.find("set title 'It''s φ'"), std::string::npos) << script;
  EXPECT_NE(script.find("plot $data0 using 1:2 with lines lw 2 title 'squares'"), std::string::npos)
      << script;
}

TEST(FigureScript, TakesMoreColumnsForStylesThatNeedThem) {
  Figure figure = figure_of("x", "y");
  figure.curves[0].style = "boxxyerror";
  figure.curves[0].more = {"x", "y"};
  const std::string script = figure_script(figure, squares);
  EXPECT_NE(script.find("1 1.0 1 1.0\n2 4.0 2 4.0\n\n3 9.0 3 9.0\n"), std::string::npos) << script;
  EXPECT_NE(script.find("using 1:2:3:4 with boxxyerror"), std::string::npos) << script;
  figure.curves[0].more = {"z"};
  EXPECT_THROW((void)figure_script(figure, squares), std::logic_error);
}

TEST(FigureScript, RejectsWhatIsMissing) {
  EXPECT_THROW((void)figure_script(figure_of("x", "z"), squares), std::logic_error);
  EXPECT_THROW((void)figure_script(figure_of("x", "name"), squares), std::logic_error);
  EXPECT_THROW((void)figure_script(figure_of("x", "y"), {}), std::logic_error);
}

TEST(DrawSvg, IsTheSameOnEveryRunAndCarriesNoDate) {
  const std::string svg = draw_svg(figure_of("x", "y"), squares);
  EXPECT_EQ(svg, draw_svg(figure_of("x", "y"), squares));
  EXPECT_TRUE(svg.starts_with("<?xml")) << svg.substr(0, 80);
  EXPECT_NE(svg.find("It's φ"), std::string::npos);
  EXPECT_EQ(svg.find("202"), std::string::npos) << "a year?";
}

TEST(DrawSvg, ReportsWhatGnuplotSays) {
  Figure figure = figure_of("x", "y");
  figure.setup = "set nonsense";
  try {
    (void)draw_svg(figure, squares);
    FAIL() << "accepted";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("figure 'figure': gnuplot failed"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace subdiv
