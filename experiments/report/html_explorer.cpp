#include "experiments/report/html_explorer.h"

#include <algorithm>
#include <optional>
#include <sstream>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "experiments/data.h"
#include "experiments/explorer/assets.h"
#include "experiments/explorer/presets.h"
#include "experiments/report/html_page.h"

namespace subdiv {
namespace {

using Json = nlohmann::ordered_json;

const ClaimRecord* find(const ReportSource& source, const std::string& id) {
  const auto found = std::ranges::find(source.claims, id, &ClaimRecord::id);
  return found == source.claims.end() ? nullptr : &*found;
}

/// The exact value of a proved finding; nothing when there is none.
std::optional<std::string> proved(const ReportSource& source, const std::string& id) {
  const ClaimRecord* claim = find(source, id);
  const bool holds = claim != nullptr && claim->rigour != "approximate" &&
                     (claim->verdict == "established" || claim->verdict == "reproduced");
  return holds ? claim->exact : std::nullopt;
}

/// "(-1, 7)" behind `before` in a text as "-1 7".
std::optional<std::string> ends_behind(const std::string& text, const std::string& before) {
  const std::size_t at = text.find(before + "(");
  if (at == std::string::npos) return std::nullopt;
  const std::size_t open = at + before.size();
  const std::size_t comma = text.find(", ", open);
  const std::size_t close = text.find(')', open);
  if (comma == std::string::npos || close == std::string::npos || close < comma) return std::nullopt;
  return text.substr(open + 1, comma - open - 1) + " " + text.substr(comma + 2, close - comma - 2);
}

std::string range_facts(const ReportSource& source) {
  std::string facts;
  constexpr int highest = 4;
  for (int order = 0; order < highest; ++order) {
    const std::string id = fmt::format("smooth.exact.c{}", order);
    const auto lower = proved(source, id + ".lower");
    const auto upper = proved(source, id + ".upper");
    if (lower && upper) facts += fmt::format("range {} {} {} {}.lower\n", order, *lower, *upper, id);
  }
  const std::string single = "smooth.exact.c4";
  if (const auto s = proved(source, single))
    facts += fmt::format("range {0} {1} {1} {2}\n", highest, *s, single);
  return facts;
}

/// The lines on which shifts are dependent; p a + q b = r as "p q r".
std::string line_facts(const ReportSource& source) {
  const std::vector<std::pair<std::string, std::string>> lines{{"smooth.ab.line.quadratic", "1 0 2"},
                                                               {"smooth.ab.line.even", "1 -1 -1"},
                                                               {"smooth.ab.line.cycle", "2 1 9"}};
  std::string facts;
  for (const auto& [id, line] : lines) {
    const auto text = proved(source, id);
    const auto ends = text ? ends_behind(*text, "") : std::nullopt;
    if (ends) facts += fmt::format("line 1 {} {} {}\n", line, *ends, id);
  }
  const std::string both = "smooth.ab.c2";
  const auto text = proved(source, both);
  const auto ends = text ? ends_behind(*text, "a = 2 and b in ") : std::nullopt;
  if (ends) facts += fmt::format("line 2 1 0 2 {} {}\nc2-decided\n", *ends, both);
  return facts;
}

/// "-2.66796875000000" without the zeros that fill up its digits.
std::string trimmed(std::string number) {
  if (number.find('.') == std::string::npos) return number;
  number.erase(number.find_last_not_of('0') + 1);
  if (number.back() == '.') number.pop_back();
  return number;
}

/// The cells of the maps, from their series: exact, because their ends have few binary digits.
std::string cell_facts(const ReportSource& source) {
  std::string facts;
  if (!source.series) return facts;
  for (const char* order : {"0", "1"}) {
    for (const char* decision : {"in", "out"}) {
      if (!proved(source, fmt::format("smooth.map.c{}.{}", order, decision))) continue;
      std::istringstream table(source.series(fmt::format("smooth-map-c{}-{}", order, decision)));
      std::string line;
      std::getline(table, line);  // the names of the columns
      while (std::getline(table, line)) {
        facts.append("cell ").append(order).append(" ").append(decision);
        std::istringstream cells(line);
        for (std::string cell; std::getline(cells, cell, ',');) facts.append(" ").append(trimmed(cell));
        facts += "\n";
      }
    }
  }
  return facts;
}

Json polygons() {
  Json result = Json::array();
  for (const explorer::StoredPolygon& stored : explorer::stored_polygons()) {
    Json points = Json::array();
    for (const auto& [x, y] : polygon_from_data(stored.name + ".csv")) {
      points.push_back(Json::array({x.to_string(), y.to_string()}));
    }
    result.push_back(
        {{"name", stored.name}, {"title", stored.title}, {"open", stored.open}, {"points", points}});
  }
  return result;
}

/// What the page says of claims that it names.
Json claims(const ReportSource& source) {
  Json result = Json::object();
  const auto add = [&](const std::string& id) {
    const ClaimRecord* claim = find(source, id);
    if (claim == nullptr) return;
    result[id] = {{"printed", claim->printed.value_or("")}, {"verdict", claim->verdict}};
  };
  for (const explorer::Preset& preset : explorer::presets()) {
    for (const std::string& id : preset.claims) add(id);
  }
  for (const ClaimRecord& claim : source.claims) {
    const bool of_facts = claim.id.starts_with("smooth.exact.") || claim.id.starts_with("smooth.ab.") ||
                          claim.id.starts_with("smooth.map.");
    if (of_facts) add(claim.id);
  }
  return result;
}

Json preset_list() {
  Json result = Json::array();
  for (const explorer::Preset& p : explorer::presets()) {
    result.push_back({{"group", p.group},
                      {"name", p.name},
                      {"steps", p.steps},
                      {"claims", p.claims},
                      {"note", p.note},
                      {"retrofit", p.retrofit}});
  }
  return result;
}

/// JSON inside a script element: without any '<', nothing in it can end the element or change how it is read.
std::string script_json(const Json& json) {
  std::string text;
  for (const char c : json.dump()) {
    if (c == '<') {
      text += "\\u003c";
    } else {
      text += c;
    }
  }
  return text;
}

}  // namespace

std::string explorer_facts(const ReportSource& source) {
  return range_facts(source) + line_facts(source) + cell_facts(source);
}

std::string explorer_page(const ReportSource& source) {
  const Json data{{"facts", explorer_facts(source)},
                  {"presets", preset_list()},
                  {"polygons", polygons()},
                  {"claims", claims(source)}};
  HtmlPage page;
  page.title = "Explorer of J-splines";
  page.lead =
      "<p>Drag the points, turn the parameters: J(a, b) of the papers, J(s) = J(s, s). The page computes "
      "with "
      "the library's own code and knows what is proved of the limits.</p>\n"
      "<noscript><p class=\"notice\">This page computes, and needs scripts for that; <a "
      "href=\"index.html\">the "
      "claims</a> can be read without.</p></noscript>\n";
  page.name = "explorer.html";
  page.content = explorer::page_content();
  page.style = explorer::page_style();
  page.policy =
      "default-src 'none'; img-src data: blob:; style-src 'unsafe-inline'; script-src 'unsafe-inline' "
      "'wasm-unsafe-eval'; connect-src data:";
  page.scripts = "<script type=\"application/json\" id=\"data\">" + script_json(data) +
                 "</script>\n<script>\n" + std::string(explorer::core_script()) + "</script>\n<script>\n" +
                 std::string(explorer::page_script()) + "</script>\n";
  return html_page(page);
}

}  // namespace subdiv
