// Whatever the bytes, reading ends in a value or in an InputError; never in a crash, a hang or another
// exception.

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "schemes/expression.h"
#include "schemes/instantiate.h"
#include "schemes/json_document.h"
#include "schemes/scheme_file.h"
#include "tests/schemes/algebra/random_elements.h"
#include "tests/schemes/input_errors.h"

namespace subdiv {
namespace {

using testing::Generator;
using testing::random_int;

const std::string mask_file = R"json({ "name": "x", "arity": 2, "parameters": { "w": "1/16", "v": 0.5 },
  "mask": { "first": -3, "coefficients": ["-w", "0", "1/2+w", 1, "sqrt(1/4)+w", 0.0, "-w*v/(1-v)"]
}
, "source" : "a \"quoted\" \u00e9 source"
})json";
const std::string symbol_file =
    R"json({"name": "y", "arity": 3, "symbol": "3*((1+z+z^2)/3)^3*(2-z)/z^4"})json";

/// Runs a reader; true when it accepted.
template <class Action>
bool accepts(const Action& action, const std::string& input) {
  try {
    static_cast<void>(action(input));
    return true;
  } catch (const InputError& error) {
    EXPECT_FALSE(std::string(error.what()).empty());
    return false;
  }
}

std::string random_text(Generator& generator, const std::string& alphabet, int longest) {
  std::string text;
  for (int i = random_int(generator, 0, longest); i > 0; --i) {
    text +=
        alphabet[static_cast<std::size_t>(random_int(generator, 0, static_cast<int>(alphabet.size()) - 1))];
  }
  return text;
}

/// A copy with a few bytes changed, dropped or doubled.
std::string mutated(Generator& generator, std::string text) {
  for (int n = random_int(generator, 1, 4); n > 0 && !text.empty(); --n) {
    const auto at = static_cast<std::size_t>(random_int(generator, 0, static_cast<int>(text.size()) - 1));
    switch (random_int(generator, 0, 2)) {
      case 0:
        text[at] = static_cast<char>(random_int(generator, 0, 255));
        break;
      case 1:
        text.erase(at, static_cast<std::size_t>(random_int(generator, 1, 5)));
        break;
      default:
        text.insert(at, text.substr(at, static_cast<std::size_t>(random_int(generator, 1, 8))));
    }
  }
  return text;
}

const auto read_file = [](const std::string& text) { return parse_scheme_file(text, "f.json"); };
const auto read_expression = [](const std::string& text) {
  return evaluate_constant<Algebraic>(Expression::parse(text));
};

TEST(Robustness, EveryTruncationOfAValidFileIsRefused) {
  for (const std::string& text : {mask_file, symbol_file}) {
    ASSERT_TRUE(accepts(read_file, text));
    for (std::size_t length = 0; length < text.size(); ++length) {
      EXPECT_FALSE(accepts(read_file, text.substr(0, length))) << length;
    }
  }
}

TEST(Robustness, EveryTruncationOfAnExpressionIsReadOrRefused) {
  const std::string text = "-(1/16+0.5e-3*sqrt(2))^2/(3-7)^-1";
  ASSERT_TRUE(accepts(read_expression, text));
  for (std::size_t length = 0; length < text.size(); ++length)
    accepts(read_expression, text.substr(0, length));
}

TEST(Robustness, RandomBytesAreRefused) {
  Generator generator(91);
  std::string bytes;
  for (int c = 0; c < 256; ++c) bytes += static_cast<char>(c);
  for (int i = 0; i < 2000; ++i) {
    const std::string text = random_text(generator, bytes, 60);
    EXPECT_FALSE(accepts(read_file, text));
    accepts(read_expression, text);
    accepts([](const std::string& s) { return parse_scheme(s); }, text);
  }
}

TEST(Robustness, RandomTextOfTheRightCharactersIsReadOrRefused) {
  Generator generator(92);
  int accepted = 0;
  for (int i = 0; i < 10'000; ++i) {
    if (accepts(read_expression, random_text(generator, "0123456789.+-*/^()eE sqrt", 12))) ++accepted;
    accepts([](const std::string& s) { return parse_scheme(s); },
            "jspline:s=" + random_text(generator, "01ab+-*/^(),:=sqrt", 12));
  }
  EXPECT_GT(accepted, 100);
}

TEST(Robustness, DamagedFilesAreReadOrRefused) {
  Generator generator(93);
  int accepted = 0;
  for (int i = 0; i < 5000; ++i) {
    if (accepts(read_file, mutated(generator, i % 2 == 0 ? mask_file : symbol_file))) ++accepted;
  }
  EXPECT_GT(accepted, 10);
}

TEST(Robustness, DamagedSymbolsAreEvaluatedOrRefused) {
  Generator generator(94);
  const auto evaluate_damaged = [](const std::string& text) {
    return factored_symbol(Expression::parse(text), 2, Bindings<Rational>{}, ExactLiteral<Rational>{});
  };
  for (int i = 0; i < 5000; ++i) {
    accepts(evaluate_damaged, mutated(generator, "2*((1+z)/2)^4*(5/4-z/2+0.25*z^2)/z^3*sqrt(4)"));
  }
}

}  // namespace
}  // namespace subdiv
