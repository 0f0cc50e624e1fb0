#include "experiments/certificates/statement_file.h"

#include <map>
#include <optional>
#include <set>
#include <string_view>

#include <fmt/format.h>

#include "experiments/file_reader.h"
#include "schemes/input_error.h"
#include "schemes/text.h"

namespace subdiv {
namespace {

void add_line(Statement& statement, bool& in_proof, const std::string& line) {
  if (line == "proof") {
    in_proof = true;
  } else if (in_proof) {
    statement.proof.push_back(line);
  } else if (line.starts_with("scheme ") || line.starts_with("data ")) {
    statement.head.push_back(line);
  } else {
    statement.lines.push_back(line);
  }
}

void replace_all(std::string& line, const std::string& name, const std::optional<std::string>& value,
                 const std::string& claim) {
  for (std::size_t at = line.find(name); at != std::string::npos; at = line.find(name, at + 1)) {
    if (!value)
      throw InputError(fmt::format("the statement of {} asks for {}, which the claim lacks", claim, name));
    line.replace(at, name.size(), *value);
  }
}

}  // namespace

std::vector<WrittenStatement> read_statements(const std::filesystem::path& path) {
  FileReader reader(path);
  std::map<std::string, std::vector<std::string>> common;
  std::set<std::string> claims;
  std::vector<WrittenStatement> result;
  std::vector<std::string>* shared = nullptr;
  bool in_block = false;
  bool in_proof = false;
  std::string_view raw;
  while (reader.next_line(raw)) {
    const std::string line(trimmed(raw));
    if (line.empty()) {
      in_block = false;
      continue;
    }
    const std::string word = line.substr(0, line.find(' '));
    const std::string rest(trimmed(std::string_view(line).substr(word.size())));
    if (word == "claim" || word == "common") {
      if (rest.empty()) reader.reject("'" + word + "' needs a name");
      in_block = true;
      in_proof = false;
      shared = word == "common" ? &common[rest] : nullptr;
      if (word == "common") continue;
      if (!claims.insert(rest).second) reader.reject("the claim " + rest + " stands here twice");
      result.push_back({{rest, {}, {}, {}}, reader.line()});
    } else if (!in_block) {
      if (!line.starts_with('#'))
        reader.reject("expected 'claim ID' or 'common NAME', found " + in_quotes(line));
    } else if (word == "use") {
      const auto found = common.find(rest);
      if (found == common.end() || &found->second == shared)
        reader.reject("there is no block 'common " + rest + "' above");
      for (const std::string& pasted : found->second) {
        if (shared != nullptr) {
          shared->push_back(pasted);
        } else {
          add_line(result.back().statement, in_proof, pasted);
        }
      }
    } else if (shared != nullptr) {
      shared->push_back(line);
    } else {
      add_line(result.back().statement, in_proof, line);
    }
  }
  return result;
}

Statement filled(Statement statement, const ClaimRecord& claim) {
  for (std::vector<std::string>* lines : {&statement.head, &statement.lines, &statement.proof}) {
    for (std::string& line : *lines) {
      replace_all(line, "$exact", claim.exact, claim.id);
      replace_all(line, "$lower", claim.lower, claim.id);
      replace_all(line, "$upper", claim.upper, claim.id);
    }
  }
  return statement;
}

}  // namespace subdiv
