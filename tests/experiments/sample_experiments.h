#pragma once

#include <array>
#include <stdexcept>

#include "experiments/experiment.h"

namespace subdiv {

// Experiments made for tests: two that work, one that throws, one that forgets a claim.

inline std::span<const ClaimHead> letters_heads() {
  static const std::array heads{
      ClaimHead{"letters.a", "jsplines", "1", "0.33", ClaimKind::rounded, "one third"},
      ClaimHead{"letters.b", "jsplines", "1", "so", ClaimKind::exact, "a statement"}};
  return heads;
}

inline Results run_letters() {
  const auto heads = letters_heads();
  return {{settle_statement(heads[1], false, "false", "it is *otherwise*"),
           settle(heads[0], exact(Rational(1, 3)))},
          {{"letters-series", {"x", "y"}, {{"0", "1.5"}, {"1", "2.5"}}}},
          {{"letters-figure", "Letters", "x", "y", {{"letters-series", "x", "y", "a line"}}, ""}}};
}

inline std::span<const ClaimHead> numbers_heads() {
  static const std::array heads{
      ClaimHead{"numbers.one", "subdivlab", "2", std::nullopt, ClaimKind::exact, "one"}};
  return heads;
}

inline Results run_numbers() { return {{settle(numbers_heads()[0], exact(Rational(1)))}, {}, {}}; }

[[noreturn]] inline Results run_broken() { throw std::runtime_error("out of luck"); }
inline Results run_forgetful() { return {{settle_statement(letters_heads()[1], true, "true")}, {}, {}}; }
inline Results run_twice() {
  const Claim claim = settle(numbers_heads()[0], exact(Rational(1)));
  return {{claim, claim}, {}, {}};
}
inline Results run_with_bad_file_name() {
  return {{settle(numbers_heads()[0], exact(Rational(1)))}, {{"../escape", {"x"}, {}}}, {}};
}

inline const Experiment letters{"letters", "Letters (jsplines 1)", letters_heads, run_letters};
inline const Experiment numbers{"numbers", "Numbers", numbers_heads, run_numbers};

}  // namespace subdiv
