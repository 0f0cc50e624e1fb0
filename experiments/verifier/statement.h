#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/verifier/cover.h"
#include "experiments/verifier/evaluator.h"

namespace subdiv::verifier {

/// What a statement asks of the proof: the line that begins with `word`. A cover says what has to be covered;
/// `values` are what the other witnesses are about (radius: matrices, bound; least: norm (max: 1, sum: 0),
/// entries, names, value, place; minimum: entries, value, place).
struct Question {
  std::string word;
  const Cover* cover = nullptr;
  const Cell* cell = nullptr;
  std::vector<Value> values{};
  std::string name{};  // of the variable of a minimum
};
/// Answers with the rest of the line; throws Rejected when there is none.
using Witness = std::function<std::string(const Question&)>;

/// What the lines so far have defined.
struct Context {
  Names names;
  Ranges ranges;
  std::map<std::string, std::map<long, Rational>> roots;  // the equation by powers; the root has a range, too
  std::vector<Value> values;                              // of the claim
};

/// Checks a line of a statement (experiments/certificates/README.md) in exact arithmetic, with the witness;
/// Rejected when it is not proved, or malformed.
void check_line(const std::string& line, Context& context, const Witness& witness);

/// The line as a sentence.
[[nodiscard]] std::string in_words(const std::string& line);

}  // namespace subdiv::verifier
