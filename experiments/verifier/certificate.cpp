#include "experiments/verifier/certificate.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <sstream>
#include <utility>

#include <fmt/format.h>
#include <openssl/evp.h>

#include "schemes/input_error.h"
#include "schemes/instantiate.h"
#include "schemes/scheme_description.h"

namespace subdiv::verifier {
namespace {

constexpr const char* first_line = "subdivlab certificate 1";

std::string sha256(const std::string& text) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> bytes{};
  unsigned int size = 0;
  if (EVP_Digest(text.data(), text.size(), bytes.data(), &size, EVP_sha256(), nullptr) != 1)
    throw std::runtime_error("SHA-256 failed");
  std::string result;
  for (unsigned int i = 0; i < size; ++i) {
    const unsigned int byte = bytes.at(i);
    result += {"0123456789abcdef"[byte >> 4U], "0123456789abcdef"[byte & 15U]};
  }
  return result;
}

std::string joined_lines(const std::vector<std::string>& lines) {
  std::string result;
  for (const std::string& line : lines) result += line + "\n";
  return result;
}

std::string stated(const Certificate& c) {
  return "claim " + c.claim + "\n" + joined_lines(c.head) + "statement\n" + joined_lines(c.statement);
}

std::string read(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  need(static_cast<bool>(file), "cannot read " + path.string());
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> result;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) result.push_back(part);
  return result;
}

/// Rows of numbers; a file whose first column is `polygon` gives a list of points for each of its values.
Value table(const std::string& text) {
  std::vector<std::vector<Value>> groups;
  std::string group;
  bool grouped = false;
  bool is_first = true;
  for (std::string line : split(text, '\n')) {
    if (line.ends_with('\r')) line.pop_back();
    if (line.empty() || line.starts_with('#')) continue;
    std::vector<std::string> cells = split(line, ',');
    if (std::exchange(is_first, false) && line[0] >= 'a' && line[0] <= 'z') {
      grouped = cells[0] == "polygon";
      continue;
    }
    if (groups.empty() || (grouped && cells[0] != group)) groups.emplace_back();
    if (grouped) {
      group = cells[0];
      cells.erase(cells.begin());
    }
    std::vector<Value> row;
    for (const std::string& cell : cells) row.emplace_back(Quotient(Rational::parse(cell)));
    groups.back().emplace_back(std::move(row));
  }
  if (!grouped) return groups.empty() ? std::vector<Value>{} : groups[0];
  return std::vector<Value>(groups.begin(), groups.end());
}

/// Remarks, definitions and ranges state nothing.
bool says_something(const std::string& line) {
  const std::string word = line.substr(0, line.find(' '));
  return word != "#" && word != "let" && word != "def" && word != "for";
}

/// The symbol that the program makes of a scheme's name.
std::string symbol_of(const std::string& scheme) {
  const SchemeDescription description = parse_scheme(scheme);
  if (description.steps.size() != 1)
    throw InputError(scheme + ": a certificate names each step of a mixed scheme by itself");
  const Scheme<RationalFunction> known = symbolic_scheme(description);
  const Laurent<RationalFunction>& symbol = known.last().symbol;
  std::string text;
  for (int i = symbol.first(); i <= symbol.last(); ++i) {
    if (symbol[i].is_zero()) continue;
    text += (text.empty() ? "(" : " + (") + symbol[i].to_string(description.free_parameters) + ")*z^" +
            std::to_string(i);
  }
  return text;
}

}  // namespace

std::string to_text(const Certificate& c) {
  const std::string body = stated(c);
  const std::size_t claim_end = body.find('\n') + 1;
  return std::string(first_line) + "\n" + body.substr(0, claim_end) + "digest " + sha256(body) + "\n" +
         body.substr(claim_end) + "proof\n" + joined_lines(c.proof) + "end\n";
}

Certificate parse_certificate(const std::string& text) {
  const std::vector<std::string> lines = split(text, '\n');
  const auto statement = std::find(lines.begin(), lines.end(), "statement");
  const auto proof = std::find(lines.begin(), lines.end(), "proof");
  need(text.ends_with("\nend\n") && lines.size() > 5 && lines[0] == first_line &&
           lines[1].starts_with("claim ") && statement - lines.begin() >= 3 && statement < proof &&
           proof != lines.end() && proof - statement > 1,
       "this is no whole certificate");
  Certificate c{lines[1].substr(6),
                {lines.begin() + 3, statement},
                {statement + 1, proof},
                {proof + 1, lines.end() - 1}};
  need(lines[2] == "digest " + sha256(stated(c)), "the digest is that of another scheme or statement");
  return c;
}

std::string scheme_line(const std::string& name, const std::string& scheme) {
  return "scheme " + name + " " + scheme + " = " + symbol_of(scheme);
}

std::string data_line(const std::string& name, const std::string& file, const std::filesystem::path& data) {
  return "data " + name + " " + file + " " + sha256(read(data / file));
}

Context read_head(const std::vector<std::string>& head, const std::filesystem::path& data) {
  Context context;
  for (const std::string& line : head) {
    std::istringstream words(line);
    std::string kind;
    std::string name;
    std::string what;
    words >> kind >> name >> what;
    need(!context.names.values.contains(name), name + " is named twice");
    if (kind == "scheme") {
      const std::size_t mask = line.find(" = ");
      need(mask != std::string::npos && line.substr(0, mask) == fmt::format("scheme {} {}", name, what),
           "a mask is missing: " + line);
      const Value symbol = evaluate(line.substr(mask + 3), {});
      const Value known = evaluate(symbol_of(what), {});
      need((scalar(symbol) - scalar(known)).above.empty(), "this is not the mask of " + what);
      context.names.values[name] = symbol;
    } else if (kind == "data") {
      need(what.find('/') == std::string::npos, "a data file is NAME.csv");
      need(line == data_line(name, what, data), "the data file " + what + " is another one");
      context.names.values[name] = table(read(data / what));
    } else {
      throw Rejected("unknown line of the head: " + line);
    }
  }
  return context;
}

Context check(const Certificate& certificate, const std::filesystem::path& data) {
  Context context;
  try {
    context = read_head(certificate.head, data);
  } catch (const std::exception& error) {
    throw Rejected(error.what());
  }
  auto next = certificate.proof.begin();
  const Witness from_proof = [&](const Question& question) {
    need(next != certificate.proof.end() && next->starts_with(question.word + " "),
         "the proof lacks '" + question.word + "'");
    return (next++)->substr(question.word.size() + 1);
  };
  need(std::any_of(certificate.statement.begin(), certificate.statement.end(), says_something),
       "nothing is stated");
  for (const std::string& line : certificate.statement) {
    try {
      check_line(line, context, from_proof);
    } catch (const std::exception& error) {
      throw Rejected(std::string(error.what()) + " (" + line + ")");
    }
  }
  need(next == certificate.proof.end(), "the proof says more than is stated");
  return context;
}

}  // namespace subdiv::verifier
