#include <array>
#include <utility>

#include <fmt/format.h>

#include "experiments/verifier/certificate.h"

namespace subdiv::verifier {
namespace {

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  if (const std::size_t at = text.rfind(from); at != std::string::npos) text.replace(at, from.size(), to);
  return text;
}

/// "A == B" as "A is B", and the like.
std::string relation_in_words(const std::string& text) {
  static const std::array<std::pair<const char*, const char*>, 6> relations{{{" == ", " equals "},
                                                                             {" != ", " is never "},
                                                                             {" >= ", " is at least "},
                                                                             {" <= ", " is at most "},
                                                                             {" > ", " is greater than "},
                                                                             {" < ", " is less than "}}};
  for (const auto& [sign, words] : relations) {
    if (text.find(sign) != std::string::npos) return replaced(text, sign, words);
  }
  return text;
}

}  // namespace

std::string in_words(const std::string& line) {
  const std::size_t space = std::min(line.find(' '), line.size());
  const std::string verb = line.substr(0, space);
  const std::string rest = line.substr(std::min(space + 1, line.size()));
  if (verb == "#") return "Remark: " + rest;
  if (verb == "let") return "Let " + rest + ".";
  if (verb == "def") return "Let " + rest + " for all arguments.";
  if (verb == "for") return "From here on " + replaced(rest, " in ", " is any number of ") + ".";
  if (verb == "root") return replaced(replaced(rest, " of ", " is the only root of "), " in ", " in ") + ".";
  if (verb == "value") return "The value of the claim is " + rest + ".";
  if (verb == "rows") return "In each row the sum of absolute values of " + relation_in_words(rest) + ".";
  if (verb == "peak")
    return "At every point some entry in absolute value of " + relation_in_words(rest) + ".";
  if (verb == "radius") return "The joint spectral radius of " + relation_in_words(rest) + ".";
  if (verb == "least") {
    const bool is_max = rest.starts_with("max ");
    return std::string("The least value of the ") +
           (is_max ? "largest absolute value" : "sum of absolute values") + " in " +
           replaced(replaced(rest.substr(std::min<std::size_t>(4, rest.size())), " over ", " over all "),
                    " == ", " is ") +
           ".";
  }
  if (verb == "minimum") {
    return "The least value of the largest absolute value in " +
           replaced(replaced(rest.substr(std::min<std::size_t>(4, rest.size())), " == ", " is "), " at ",
                    ", attained only at ") +
           ".";
  }
  return relation_in_words(line) + ".";
}

std::string in_words(const Certificate& certificate) {
  std::string text = certificate.claim + "\n";
  for (const std::string& line : certificate.head) {
    const std::string rest = line.substr(std::min(line.find(' ') + 1, line.size()));
    const std::string name = rest.substr(0, rest.find(' '));
    const std::string what = rest.substr(std::min(rest.find(' ') + 1, rest.size()));
    text += line.starts_with("scheme")
                ? fmt::format("  {} is the symbol of {}\n", name, what)
                : fmt::format("  {} are the numbers of {}\n", name, what.substr(0, what.find(' ')));
  }
  for (const std::string& line : certificate.statement) text += fmt::format("  {}\n", in_words(line));
  return text;
}

}  // namespace subdiv::verifier
