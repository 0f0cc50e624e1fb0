#include "experiments/report/svg.h"

#include <gtest/gtest.h>

namespace subdiv {
namespace {

/// What gnuplot writes, without what does not matter here.
std::string drawn(const std::string& body) {
  return "<svg \n width=\"480\"\n>\n\n<title>f</title>\n<desc>Produced by GNUPLOT 5.4 </desc>\n" + body +
         "</svg>\n";
}

const std::string head =
    "<svg role=\"img\" aria-labelledby=\"f-title\" aria-describedby=\"f-desc\"\n width=\"480\"\n>\n"
    "<title id=\"f-title\">A &lt; B</title>\n<desc id=\"f-desc\">Words &amp; more</desc>\n";

std::string finished(const std::string& body) {
  return finished_svg(drawn(body), "f", "A < B", "Words & more");
}

TEST(FinishedSvg, CarriesTitleAndDescription) { EXPECT_EQ(finished(""), head + "</svg>\n"); }

TEST(FinishedSvg, LeavesOutEmptyGroupsFiltersAndNamesOfPlots) {
  EXPECT_EQ(
      finished("<filter id='textbox'>\n <feFlood/>\n</filter>\n<g fill=\"none\" color=\"black\">\n</g>\n"
               "<g id=\"f_plot_1\" ><title>f_plot_1</title>\n</g>\n"),
      head + "<g>\n</g>\n</svg>\n");
}

TEST(FinishedSvg, ShortensPathsAndColours) {
  EXPECT_EQ(finished("\t<path stroke='rgb(  0, 114, 178)'  d='M1.00,2.50 L3.25,4.00\n\t\tM5.00,6.00 "
                     "L7.10,8.00 Z  '/>\n"),
            head + "\t<path stroke='#0072b2'  d='M1 2.5l2.25 1.5M5 6l2.1 2z'/>\n</svg>\n");
}

TEST(FinishedSvg, WritesPolygonsAsPathsInTenthsOfUnits) {
  const std::string group = "\t<g stroke='none' shape-rendering='crispEdges'>\n";
  const std::string red =
      "\t\t<polygon fill = 'rgb(255,  0,  0)' points = '1.00,2.00 3.00,2.00 3.00,1.04 '/>\n";
  const std::string blue = "\t\t<polygon fill = 'rgb(  0,  0, 255)' points = '0.00,0.00 -1.00,-1.00 '/>\n";
  EXPECT_EQ(finished(group + red + red + blue + "\t</g>\n"),
            head +
                "<g fill='currentColor' stroke='currentColor' stroke-width='3' stroke-linejoin='round' "
                "transform='scale(.1)'>\n<path color='#ff0000' d='M10 20l20 0 0-10zM10 20l20 0 0-10z'/>\n"
                "<path color='#0000ff' d='M0 0l-10-10z'/>\n\t</g>\n</svg>\n");
  const std::string glass =
      "\t\t<polygon fill = 'rgb(  0,  0, 255)' fill-opacity = '0.25' points = '0.00,0.00 1.00,1.00 '/>\n";
  EXPECT_NE(finished(group + red + glass + "\t</g>\n").find("fill-opacity = '0.25' points"),
            std::string::npos)
      << "what is not opaque stays";
}

TEST(XmlText, EscapesSigns) { EXPECT_EQ(xml_text("a<b>&\"c\""), "a&lt;b&gt;&amp;&quot;c&quot;"); }

}  // namespace
}  // namespace subdiv
