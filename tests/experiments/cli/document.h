#pragma once

#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace subdiv {

/// The words of a command as a shell has them: parts in single quotes belong together, # ends it.
inline std::vector<std::string> shell_words(const std::string& command) {
  std::vector<std::string> words;
  bool quoted = false;
  bool inside = false;
  for (const char c : command) {
    if (c == '\'') {
      quoted = !quoted;
    } else if (!quoted && c == ' ') {
      inside = false;
      continue;
    } else if (!quoted && !inside && c == '#') {
      break;
    }
    if (!inside) words.emplace_back();
    inside = true;
    if (c != '\'') words.back() += c;
  }
  return words;
}

inline std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// A block "```info .. ```" of a document: its first word is the language, what follows a name.
struct FencedBlock {
  std::string language;
  std::string name;
  std::string text;  // without its last line break
};

inline std::vector<FencedBlock> fenced_blocks(const std::string& document) {
  std::vector<FencedBlock> blocks;
  bool inside = false;
  for (const std::string& line : lines_of(document)) {
    if (line.starts_with("```")) {
      inside = !inside;
      if (!inside) continue;
      const std::string info = line.substr(3);
      const std::size_t space = info.find(' ');
      blocks.push_back({info.substr(0, space), space == std::string::npos ? "" : info.substr(space + 1), ""});
    } else if (inside) {
      blocks.back().text += (blocks.back().text.empty() ? "" : "\n") + line;
    }
  }
  return blocks;
}

/// The text of the first block in a language.
inline std::string fenced_block(const std::string& document, const std::string& language) {
  for (const FencedBlock& block : fenced_blocks(document)) {
    if (block.language == language) return block.text;
  }
  throw std::runtime_error("the document has no block ```" + language);
}

}  // namespace subdiv
