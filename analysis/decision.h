#pragma once

#include <string>

namespace subdiv {

/// An answer to a question that may stay open: yes and no are proved, undecided is neither.
enum class Decision { no, yes, undecided };

/// "yes", "no" or "undecided".
[[nodiscard]] inline std::string to_string(Decision decision) {
  if (decision == Decision::undecided) return "undecided";
  return decision == Decision::yes ? "yes" : "no";
}

}  // namespace subdiv
