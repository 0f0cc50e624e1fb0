#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "experiments/experiment.h"
#include "experiments/report/figure_style.h"
#include "experiments/report/files.h"
#include "experiments/report/json.h"

/// What holds of every figure in results/.
namespace subdiv {
namespace {

namespace fs = std::filesystem;

const fs::path results = fs::path(SUBDIVLAB_SOURCE_DIR) / "results";

struct Drawn {
  std::string name;
  std::string svg;
};

std::vector<Drawn> figures() {
  std::vector<Drawn> all;
  for (const fs::directory_entry& file : fs::directory_iterator(results / "figures"))
    all.push_back({file.path().stem().string(), read_file(file.path())});
  return all;
}

/// All first groups of a pattern.
std::vector<std::string> found(const std::string& text, const char* pattern) {
  const std::regex expression(pattern);
  std::vector<std::string> all;
  for (auto i = std::sregex_iterator(text.begin(), text.end(), expression); i != std::sregex_iterator(); ++i)
    all.push_back((*i)[1]);
  return all;
}

/// What is drawn: without the definitions of markers and the surfaces, which are shaded polygons.
std::string drawing_of(const std::string& svg) {
  std::string lines;
  bool definitions = false;
  std::size_t begin = 0;
  while (begin < svg.size()) {
    const std::size_t end = std::min(svg.find('\n', begin), svg.size());
    const std::string line = svg.substr(begin, end - begin);
    definitions = (definitions || line == "<defs>") && line != "</defs>";
    const bool surface = line.starts_with("<path color=") || line.find("scale(.1)") != std::string::npos;
    if (!definitions && !surface) lines += line + "\n";
    begin = end + 1;
  }
  return lines;
}

TEST(Figures, SayWhatTheyShow) {
  const std::regex plot("A plot of [^ ][^.]* against [^ ].*");
  for (const auto& [name, svg] : figures()) {
    EXPECT_NE(svg.find("role=\"img\""), std::string::npos) << name;
    EXPECT_EQ(found(svg, "<title id=\"[^\"]*-title\">([^<]+)</title>").size(), 1U) << name;
    const std::vector<std::string> described = found(svg, "<desc id=\"[^\"]*-desc\">([^<]+)</desc>");
    ASSERT_EQ(described.size(), 1U) << name;
    EXPECT_TRUE(described[0].starts_with("A picture of shapes.") || std::regex_match(described[0], plot))
        << name << ": " << described[0] << " (axes need labels)";
  }
}

TEST(Figures, AreMadeForAColumnOf85Millimetres) {
  for (const auto& [name, svg] : figures()) {
    const std::string drawn = drawing_of(svg);
    EXPECT_NE(svg.find(fmt::format(" width=\"{}\"", style::canvas_width)), std::string::npos) << name;
    for (const std::string& size : found(drawn, "font-size=\"([0-9.]+)"))
      EXPECT_GE(std::stod(size), 13) << name;
    for (const std::string& width : found(drawn, "stroke-width=\"([0-9.]+)"))
      EXPECT_GE(std::stod(width), 1) << name;
  }
}

TEST(Figures, HaveTheColoursOfThePalette) {
  std::set<std::string, std::less<>> palette{"#ffffff"};
  for (const std::string_view colour :
       {style::blue, style::vermilion, style::green, style::purple, style::orange, style::sky, style::yellow,
        style::black, style::dark, style::grey, style::pale, style::faint})
    palette.emplace(colour);
  for (const auto& [name, svg] : figures()) {
    for (const std::string& colour : found(drawing_of(svg), "(#[0-9a-fA-F]{6})"))
      EXPECT_TRUE(palette.contains(colour)) << name << ": " << colour;
  }
}

TEST(Figures, AreVectorsAndSmall) {
  std::size_t together = 0;
  for (const auto& [name, svg] : figures()) {
    for (const char* raster : {"<image", "<filter", "data:"})
      EXPECT_EQ(svg.find(raster), std::string::npos) << name << ": " << raster;
    together += svg.size();
  }
  EXPECT_LT(together, 2'500'000U);
}

TEST(Figures, NameClaimsOfTheRegistry) {
  std::vector<std::string> ids;
  for (const Experiment& experiment : experiments()) {
    for (const ClaimHead& head : experiment.heads()) ids.push_back(head.id);
  }
  const fs::path file = results / "manifest.json";
  for (const FileEntry& figure : manifest_from_json(read_file(file), file.string()).figures) {
    EXPECT_FALSE(figure.claims.empty()) << figure.name << " belongs to no claim";
    for (const std::string& claim : figure.claims) {
      EXPECT_TRUE(std::ranges::any_of(ids,
                                      [&](const std::string& id) {
                                        return id == claim || (claim.ends_with('.') && id.starts_with(claim));
                                      }))
          << figure.name << ": no claim " << claim;
    }
  }
}

}  // namespace
}  // namespace subdiv
