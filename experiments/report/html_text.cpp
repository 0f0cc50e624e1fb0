#include "experiments/report/html_text.h"

#include <cctype>

#include "experiments/report/svg.h"

namespace subdiv {
namespace {

bool is_id_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '.' || c == '-';
}

bool is_word_character(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '/';
}

}  // namespace

std::string html_text(std::string_view text) {
  std::string result;
  for (const char c : xml_text(text)) {
    if (c == '\'') {
      result += "&#39;";
    } else {
      result += c;
    }
  }
  return result;
}

std::string html_with_ids(std::string_view text, const std::set<std::string>& ids,
                          const std::function<std::string(const std::string& id)>& html) {
  std::string result;
  std::size_t done = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    if (!is_id_character(text[begin]) || (begin > 0 && is_word_character(text[begin - 1]))) {
      ++begin;
      continue;
    }
    std::size_t end = begin;
    while (end < text.size() && is_id_character(text[end])) ++end;
    const std::size_t next = end;
    while (end > begin && (text[end - 1] == '.' || text[end - 1] == '-')) --end;
    const std::string word(text.substr(begin, end - begin));
    if (ids.contains(word) && (next == text.size() || !is_word_character(text[next]))) {
      result += html_text(text.substr(done, begin - done));
      result += html(word);
      done = end;
    }
    begin = next;
  }
  return result + html_text(text.substr(done));
}

std::string html_with_links(std::string_view text, const std::set<std::string>& ids) {
  return html_with_ids(text, ids, [](const std::string& id) { return html_link("#" + id, id); });
}

std::string url_text(std::string_view text) {
  constexpr std::string_view hex = "0123456789ABCDEF";
  std::string result;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain = (byte < 0x80 && std::isalnum(byte) != 0) || c == '-' || c == '.' || c == '_';
    if (plain) {
      result += c;
    } else {
      result += '%';
      result += hex[byte / 16];
      result += hex[byte % 16];
    }
  }
  return result;
}

std::string html_link(const std::string& address, const std::string& text) {
  return "<a href=\"" + html_text(address) + "\">" + html_text(text) + "</a>";
}

std::string svg_address(std::string_view svg) {
  std::string result = "data:image/svg+xml,";
  result.reserve(svg.size() + svg.size() / 8);
  for (const char c : svg) {
    switch (c) {
      case '\n':
      case '\r':
      case '\t':
      case ' ':
        if (result.back() != ' ') result += ' ';
        break;
      case '%':
        result += "%25";
        break;
      case '#':
        result += "%23";
        break;
      case '&':
        result += "&amp;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  while (result.back() == ' ') result.pop_back();
  return result;
}

}  // namespace subdiv
