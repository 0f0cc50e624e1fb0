#include "experiments/report/svg.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
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

/// A number of hundredths, shortest.
std::string short_number(long hundredths) {
  std::string text = fmt::format("{}{}", hundredths < 0 ? "-" : "", std::abs(hundredths) / 100);
  const long rest = std::abs(hundredths) % 100;
  if (rest == 0) return text;
  text += fmt::format(".{:02}", rest);
  return text.ends_with('0') ? text.substr(0, text.size() - 1) : text;
}

/// A pair of numbers, with a space where their signs do not part them.
std::string short_pair(long x, long y) { return short_number(x) + (y < 0 ? "" : " ") + short_number(y); }

/// "M1.00,2.50 L3.25,4.00 Z" as "M1 2.5l2.25 1.5z": lines by their steps. Empty for a path with other
/// commands.
std::string short_path(const std::string& path) {
  std::string result;
  long x = 0;
  long y = 0;
  bool in_lines = false;
  for (std::size_t i = 0; i < path.size();) {
    const char command = path[i++];
    if (command == ' ' || command == '\t') continue;
    if (command == 'Z') {
      result += 'z';
      in_lines = false;
      continue;
    }
    double next_x = 0;
    double next_y = 0;
    int read = 0;
    if ((command != 'M' && command != 'L') ||
        std::sscanf(path.c_str() + i, "%lf,%lf%n", &next_x, &next_y, &read) != 2)  // NOLINT(cert-err34-c)
      return "";
    i += static_cast<std::size_t>(read);
    const long to_x = std::lround(100 * next_x);
    const long to_y = std::lround(100 * next_y);
    if (command == 'M') {
      result += "M" + short_pair(to_x, to_y);
    } else {
      result += (!in_lines ? "l" : to_x < x ? "" : " ") + short_pair(to_x - x, to_y - y);
    }
    in_lines = command == 'L';
    x = to_x;
    y = to_y;
  }
  return result;
}

/// Whether a path goes on in the next line.
bool path_is_open(const std::string& line) {
  const std::size_t begin = line.find(" d='M");
  return begin != std::string::npos && line.find('\'', begin + 4) == std::string::npos;
}

std::string with_short_path(const std::string& line) {
  constexpr std::string_view before = " d='";
  const std::size_t found = line.find(" d='M");
  if (found == std::string::npos) return line;
  const std::size_t begin = found + before.size();
  const std::size_t end = line.find('\'', begin);
  if (end == std::string::npos) return line;
  const std::string path = short_path(line.substr(begin, end - begin));
  return path.empty() ? line : line.substr(0, begin) + path + line.substr(end);
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
  if (result.find(" dy=\"") != std::string::npos)  // parts whose first space counts
    result = replaced(std::move(result), "<text>", "<text xml:space=\"preserve\">");
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
      std::string line = lines[i];
      while (path_is_open(line) && i + 1 < lines.size()) line += lines[++i];
      result += finished_line(line) + "\n";
    }
  }
  return result;
}

}  // namespace subdiv
