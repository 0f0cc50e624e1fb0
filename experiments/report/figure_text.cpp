#include "experiments/report/figure_text.h"

#include <algorithm>
#include <cctype>
#include <utility>

#include "experiments/report/utf8.h"

namespace subdiv {
namespace {

/// The index or power that begins at `begin`, and where the text goes on behind it.
std::pair<std::string_view, std::size_t> script_at(std::string_view text, std::size_t begin) {
  if (begin < text.size() && text[begin] == '{') {
    const std::size_t end = text.find('}', begin);
    if (end != std::string_view::npos) return {text.substr(begin + 1, end - begin - 1), end + 1};
  }
  std::size_t end = begin;
  while (end < text.size() && (std::isalnum(static_cast<unsigned char>(text[end])) != 0 ||
                               std::string_view("-+./,").find(text[end]) != std::string_view::npos))
    ++end;
  while (end > begin && (text[end - 1] == ',' || text[end - 1] == '.')) --end;
  return {text.substr(begin, end - begin), end};
}

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '\'') result += '\'';
    if (std::string_view("{}_^@&~\\").find(c) != std::string_view::npos) result += '\\';
    result += c;
  }
  return result;
}

/// Calls plain(text) and script(sign, text) for the parts of a text in turn.
template <class Plain, class Script>
void for_parts(std::string_view text, const Plain& plain, const Script& script) {
  std::size_t done = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '_' && text[i] != '^') continue;
    const auto [inner, next] = script_at(text, i + 1);
    if (inner.empty()) continue;
    plain(text.substr(done, i - done));
    script(text[i], inner);
    done = next;
    i = next - 1;
  }
  plain(text.substr(done));
}

std::vector<std::string> filled_lines(const std::string& text, std::size_t width) {
  std::vector<std::string> lines;
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    begin = end + 1;
    if (!lines.empty() && display_width(plain_text(lines.back() + " " + word)) <= width) {
      lines.back() += " " + word;
    } else {
      lines.push_back(word);
    }
  }
  return lines;
}

}  // namespace

std::string gnuplot_text(std::string_view text) {
  std::string result = "'";
  for_parts(
      text, [&](std::string_view part) { result += escaped(part); },
      [&](char sign, std::string_view part) {
        result += std::string(1, sign) + "{/*1.1 " + escaped(part) + "}";
      });
  return result + "'";
}

std::string plain_text(std::string_view text) {
  std::string result;
  for_parts(
      text, [&](std::string_view part) { result += part; },
      [&](char sign, std::string_view part) { result += (sign == '^' ? "^" : "") + std::string(part); });
  return result;
}

std::vector<std::string> wrapped(const std::string& text, std::size_t width) {
  const std::vector<std::string> filled = filled_lines(text, width);
  std::vector<std::string> balanced = filled;
  while (width > 1) {
    std::vector<std::string> narrower = filled_lines(text, --width);
    if (narrower.size() > filled.size()) break;
    balanced = std::move(narrower);
  }
  return balanced;
}

}  // namespace subdiv
