#include "experiments/report/utf8.h"

#include <algorithm>

namespace subdiv {
namespace {

bool starts_code_point(char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }

/// U+0300 .. U+036F, the combining diacritical marks, are CC 80 .. CD AF.
bool is_combining(std::string_view text, std::size_t i) {
  if (i + 1 >= text.size()) return false;
  const auto first = static_cast<unsigned char>(text[i]);
  const auto second = static_cast<unsigned char>(text[i + 1]);
  return first == 0xCC || (first == 0xCD && second <= 0xAF);
}

bool takes_column(std::string_view text, std::size_t i) {
  return starts_code_point(text[i]) && !is_combining(text, i);
}

}  // namespace

std::size_t display_width(std::string_view text) {
  std::size_t width = 0;
  for (std::size_t i = 0; i < text.size(); ++i) width += takes_column(text, i) ? 1 : 0;
  return width;
}

std::string clipped(std::string_view text, std::size_t width) {
  std::string result(text);
  std::replace(result.begin(), result.end(), '\n', ' ');
  if (display_width(result) <= width) return result;
  std::size_t columns = 0;
  std::size_t end = 0;
  for (; end < result.size(); ++end) {
    if (!takes_column(result, end)) continue;
    if (columns + 1 >= width) break;
    ++columns;
  }
  return result.substr(0, end) + "\u2026";
}

std::string padded(std::string text, std::size_t width) {
  const std::size_t used = display_width(text);
  if (used < width) text.append(width - used, ' ');
  return text;
}

}  // namespace subdiv
