#include "experiments/report/svg.h"

#include <cmath>
#include <cstdio>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace subdiv {
namespace {

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

/// 'rgb(  0, 114, 178)' as '#0072b2'.
std::string with_short_colours(const std::string& line) {
  constexpr std::string_view begins = "rgb(";
  std::string result;
  std::size_t done = 0;
  for (std::size_t at = line.find(begins); at != std::string::npos; at = line.find(begins, done)) {
    int red = 0;
    int green = 0;
    int blue = 0;
    const std::size_t end = line.find(')', at);
    if (end == std::string::npos ||
        std::sscanf(line.c_str() + at, "rgb(%d,%d,%d)", &red, &green, &blue) != 3)  // NOLINT(cert-err34-c)
      break;
    result += line.substr(done, at - done) + fmt::format("#{:02x}{:02x}{:02x}", red, green, blue);
    done = end + 1;
  }
  return result + line.substr(done);
}

/// A path without the signs and zeros that say nothing.
std::string with_short_path(const std::string& line) {
  const std::size_t begin = line.find(" d='M");
  if (begin == std::string::npos) return line;
  const std::size_t end = line.find('\'', begin + 5);
  std::string result;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const bool inside = i > begin && i < end;
    if (inside && line[i] == 'L') continue;  // what follows a move are lines
    if (inside && line[i] == ' ' && (line[i + 1] == ' ' || line[i + 1] == '\'')) continue;
    if (inside && line.compare(i, 3, ".00") == 0) {
      i += 2;
      continue;
    }
    result += line[i];
  }
  return result;
}

struct Polygon {
  std::string colour;
  std::vector<std::pair<long, long>> points;  // in tenths of units
};

/// A line of gnuplot's that is an opaque polygon and nothing else.
std::optional<Polygon> polygon_of(const std::string& line) {
  constexpr std::string_view fill = "<polygon fill = 'rgb(";
  constexpr std::string_view points = "' points = '";
  const std::size_t begin = line.find(fill);
  const std::size_t at = line.find(points);
  if (begin == std::string::npos || at == std::string::npos) return std::nullopt;
  Polygon polygon;
  const std::size_t colour = begin + fill.size() - 4;
  polygon.colour = with_short_colours(line.substr(colour, at - colour));
  double x = 0;
  double y = 0;
  int read = 0;
  const char* rest = line.c_str() + at + points.size();
  while (std::sscanf(rest, "%lf,%lf %n", &x, &y, &read) == 2) {  // NOLINT(cert-err34-c)
    polygon.points.emplace_back(std::lround(10 * x), std::lround(10 * y));
    rest += read;
  }
  constexpr std::size_t short_colour = 7;
  if (std::string_view(rest) != "'/>" || polygon.points.empty() || polygon.colour.size() != short_colour)
    return std::nullopt;
  return polygon;
}

std::string path_of(const Polygon& polygon) {
  std::string path;
  for (std::size_t i = 0; i < polygon.points.size(); ++i) {
    const auto& [x, y] = polygon.points[i];
    if (i == 0) {
      path += fmt::format("M{} {}", x, y);
      continue;
    }
    const long dx = x - polygon.points[i - 1].first;
    const long dy = y - polygon.points[i - 1].second;
    path += fmt::format("{}{}{}{}", i == 1 ? "l" : (dx < 0 ? "" : " "), dx, dy < 0 ? "" : " ", dy);
  }
  return path + "z";
}

/// The polygons in lines[begin .. end) as paths, those of one colour that follow each other as one.
std::optional<std::string> shortened(const std::vector<std::string>& lines, std::size_t begin,
                                     std::size_t end) {
  std::string result =
      "<g fill='currentColor' stroke='currentColor' stroke-width='3' stroke-linejoin='round' "
      "transform='scale(.1)'>\n";
  std::string colour;
  for (std::size_t i = begin; i < end; ++i) {
    const std::optional<Polygon> polygon = polygon_of(lines[i]);
    if (!polygon) return std::nullopt;
    if (polygon->colour != colour)
      result += fmt::format("{}<path color='{}' d='", colour.empty() ? "" : "'/>\n", polygon->colour);
    colour = polygon->colour;
    result += path_of(*polygon);
  }
  return colour.empty() ? result : result + "'/>\n";
}

std::string finished_line(const std::string& line) {
  std::string result = with_short_path(with_short_colours(line));
  result = replaced(std::move(result), "<tspan font-family=\"Helvetica\" ", "<tspan");
  result = replaced(std::move(result), "font-family=\"Helvetica\"",
                    "font-family=\"Helvetica, Arial, 'Liberation Sans', sans-serif\"");
  return replaced(std::move(result), "stroke=\"none\" fill=\"black\"",
                  "stroke=\"#ffffff\" stroke-width=\"3\" stroke-linejoin=\"round\" paint-order=\"stroke\" "
                  "fill=\"black\"");
}

}  // namespace

std::string xml_text(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

std::string finished_svg(const std::string& text, const std::string& id, const std::string& title,
                         const std::string& description) {
  const std::vector<std::string> lines = lines_of(text);
  std::string result;
  const auto begins = [&](std::size_t i, std::string_view start) {
    const std::size_t at = i < lines.size() ? lines[i].find_first_not_of("\t ") : std::string::npos;
    return at != std::string::npos && lines[i].compare(at, start.size(), start) == 0;
  };
  bool named = false;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (begins(i, "<svg")) {
      result +=
          fmt::format("<svg role=\"img\" aria-labelledby=\"{0}-title\" aria-describedby=\"{0}-desc\"\n", id);
    } else if (!named && begins(i, "<title>")) {
      result += fmt::format("<title id=\"{}-title\">{}</title>\n", id, xml_text(title));
    } else if (!named && begins(i, "<desc>")) {
      result += fmt::format("<desc id=\"{}-desc\">{}</desc>\n", id, xml_text(description));
      named = true;
    } else if (begins(i, "<filter")) {
      while (!begins(i, "</filter>")) ++i;
    } else if (begins(i, "<g fill=\"none\"") && begins(i + 1, "</g>")) {
      ++i;
    } else if (begins(i, "<g id=\"") && lines[i].find("<title>") != std::string::npos) {
      result += "<g>\n";
    } else if (begins(i, "<g stroke='none' shape-rendering='crispEdges'>")) {
      std::size_t end = i + 1;
      while (end < lines.size() && !begins(end, "</g>")) ++end;
      const std::optional<std::string> paths = shortened(lines, i + 1, end);
      result += paths ? *paths : lines[i] + "\n";
      if (paths) i = end - 1;
    } else if (lines[i].find_first_not_of("\t ") != std::string::npos) {
      result += finished_line(lines[i]) + "\n";
    }
  }
  return result;
}

}  // namespace subdiv
