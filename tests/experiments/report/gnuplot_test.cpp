#include "experiments/report/gnuplot.h"

#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "experiments/report/figure_script.h"

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
  EXPECT_NE(script.find("set label 'It''s φ' at screen 0.5, "), std::string::npos) << script;
  EXPECT_NE(script.find("plot $data0 using 1:2 with lines lw 2 dt 1 lc rgb '#0072b2' title 'squares'"),
            std::string::npos)
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

TEST(FigureScript, GivesFurtherCurvesOtherColoursAndDashes) {
  Figure figure = figure_of("x", "y");
  figure.curves.push_back({"squares", "y", "x", "roots"});
  const std::string script = figure_script(figure, squares);
  EXPECT_NE(script.find("dt (9,3) lc rgb '#d55e00' title 'roots'"), std::string::npos) << script;
}

/// The number behind a word.
double number_after(const std::string& text, const std::string& word) {
  return std::stod(text.substr(text.find(word) + word.size()));
}

TEST(FigureScript, BreaksLongTitlesAndMakesRoomForThemAndForTheKey) {
  Figure figure = figure_of("x", "y");
  const double with_key = number_after(figure_script(figure, squares), "size 480,");
  figure.curves[0].label = "";
  const std::string plain = figure_script(figure, squares);
  EXPECT_NE(plain.find("unset key"), std::string::npos);
  EXPECT_LT(number_after(plain, "size 480,"), with_key - 20);
  figure.title = "A title of more than fifty characters, which stands in two lines";
  const std::string script = figure_script(figure, squares);
  EXPECT_NEAR(number_after(script, "size 480,"), number_after(plain, "size 480,") + 19, 1);
  for (const char* line :
       {"set label 'A title of more than fifty' at", "set label 'characters, which stands in two lines' at"})
    EXPECT_NE(script.find(line), std::string::npos) << script;
}

TEST(FigureScript, PicturesHaveOneScaleAndNoAxes) {
  Figure figure = figure_of("x", "y");  // a box of 2 by 8
  figure.picture = true;
  const std::string script = figure_script(figure, squares);
  EXPECT_NE(script.find("unset border; unset tics"), std::string::npos);
  const double width =
      480 * (number_after(script, "rmargin at screen ") - number_after(script, "lmargin at screen "));
  const double canvas = number_after(script, "size 480,");
  const double height =
      canvas * (number_after(script, "tmargin at screen ") - number_after(script, "bmargin at screen "));
  const double left = number_after(script, "xrange [");
  const double bottom = number_after(script, "yrange [");
  const double right = number_after(script.substr(script.find("xrange [")), ":");
  const double top = number_after(script.substr(script.find("yrange [")), ":");
  EXPECT_LE(left, 1);
  EXPECT_GE(right, 3);
  EXPECT_LT(bottom, 1);
  EXPECT_GT(top, 9);
  EXPECT_NEAR(width / (right - left), height / (top - bottom), 0.01);
}

TEST(FigureScript, PicturesHaveRoomForNames) {
  Figure figure = figure_of("x", "y");
  figure.picture = true;
  figure.texts.push_back({"a name above", 2, 20});
  EXPECT_GE(number_after(
                figure_script(figure, squares).substr(figure_script(figure, squares).find("yrange [")), ":"),
            20);
}

TEST(FigureDescription, SaysAxesCurvesAndNames) {
  Figure figure = figure_of("x", "y");
  figure.x_label = "parameter s";
  figure.y_label = "error of J_{3/8}";
  figure.texts.push_back({"C^1 ends", 0, 0});
  EXPECT_EQ(figure_description(figure),
            "A plot of error of J3/8 against parameter s. Key: squares. Names: C^1 ends.");
  figure.picture = true;
  EXPECT_EQ(figure_description(figure), "A picture of shapes. Key: squares. Names: C^1 ends.");
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
  EXPECT_NE(svg.find("<title id=\"figure-title\">It's φ</title>"), std::string::npos);
  EXPECT_NE(svg.find("<desc id=\"figure-desc\">A plot of y against x. Key: squares.</desc>"),
            std::string::npos);
  EXPECT_NE(svg.find("role=\"img\""), std::string::npos);
  EXPECT_EQ(svg.find("GNUPLOT"), std::string::npos) << "its version";
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
