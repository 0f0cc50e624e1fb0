#include "schemes/scheme_file.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/schemes/input_errors.h"

namespace subdiv {
namespace {

using testing::expect_input_error;
using testing::ScratchFolder;

constexpr const char* four_point_file = R"json({ "name": "generalised four-point", "arity": 2,
  "parameters": { "w": "1/16" },
  "mask": { "first": -3, "coefficients": ["-w", "0", "1/2+w", "1", "1/2+w", "0", "-w"] },
  "source": "Dyn, Levin, Gregory 1987" }
)json";

SchemeFile parse(const std::string& text) { return parse_scheme_file(text, "f.json"); }

/// A file with the given members, in valid JSON otherwise.
std::string file(const std::string& members) { return "{\"name\": \"x\", \"arity\": 2,\n" + members + "}"; }
std::string with_mask(const std::string& coefficients) {
  return file("\"mask\": {\"first\": 0,\n\"coefficients\": " + coefficients + "}");
}

TEST(SchemeFile, ReadsAMask) {
  const SchemeFile f = parse(four_point_file);
  EXPECT_EQ(f.path, "f.json");
  EXPECT_EQ(f.name, "generalised four-point");
  EXPECT_EQ(f.source, "Dyn, Levin, Gregory 1987");
  EXPECT_EQ(f.arity, 2);
  EXPECT_EQ(f.first, -3);
  ASSERT_EQ(f.coefficients.size(), 7U);
  EXPECT_EQ(f.coefficients[2].expression.text(), "1/2+w");
  ASSERT_EQ(f.parameters.size(), 1U);
  EXPECT_EQ(f.parameters[0].name, "w");
  EXPECT_EQ(f.parameters[0].default_value.expression.text(), "1/16");
  EXPECT_FALSE(f.symbol.has_value());
  EXPECT_EQ(f.coefficient_place(2), "f.json:3: coefficient 3 (of z^-1)");
}

TEST(SchemeFile, ReadsASymbol) {
  const SchemeFile f = parse(file("\"parameters\": {\"w\": 0.5}, \"symbol\": \"2*((1+z)/2)^4*(1-w+w*z)\""));
  ASSERT_TRUE(f.symbol.has_value());
  EXPECT_TRUE(f.coefficients.empty());
  EXPECT_EQ(f.symbol_place(), "f.json:2: symbol");
  EXPECT_FALSE(f.has_decimals());  // decimals of parameters are exact
}

TEST(SchemeFile, TakesJsonNumbersAsTheDecimalsTheyShow) {
  const SchemeFile f = parse(with_mask("[0.1, 1, 0.9]"));
  EXPECT_EQ(evaluate_constant<Rational>(f.coefficients[0].expression), Rational(1, 10));
  EXPECT_TRUE(f.has_decimals());
}

TEST(SchemeFile, ErrorsNameThePlaceAndTheRemedy) {
  struct Case {
    std::string text;
    std::vector<const char*> pieces;
  };
  const std::string mask = "\"mask\": {\"first\": 0, \"coefficients\": [1, 1]}";
  for (const Case& c : std::vector<Case>{
           {"", {"f.json", "empty"}},
           {"  \n", {"f.json", "empty"}},
           {"[1]", {"f.json:1", "a scheme file must be an object"}},
           {"{}", {"\"name\" is missing", "\"name\": \"my scheme\""}},
           {"{\"name\": \"x\"}", {"\"arity\" is missing", "\"arity\": 2"}},
           {file(mask + ", \"sorce\": \"\""), {"f.json:2", "'sorce'", "did you mean 'source'?", "arity"}},
           {file("\"source\": \"y\""), {"neither \"mask\" nor \"symbol\"", "coefficients"}},
           {file(mask + ", \"symbol\": \"1+z\""), {"both given"}},
           {"{\"name\": 3, \"arity\": 2}", {"\"name\" must be a string"}},
           {"{\"name\": \" \", \"arity\": 2}", {"\"name\" is empty"}},
           {"{\"name\": \"" + std::string(201, 'n') + "\", \"arity\": 2}", {"more than 200 characters"}},
           {"{\"name\": \"x\", \"arity\": 4, " + mask + "}", {"arity 4 is not supported", "2 or 3"}},
           {"{\"name\": \"x\", \"arity\": 1, " + mask + "}", {"arity 1", "2 or 3"}},
           {"{\"name\": \"x\", \"arity\": 2.5, " + mask + "}", {"\"arity\" must be a whole number", "'2.5'"}},
           {"{\"name\": \"x\", \"arity\": 1e400, " + mask + "}", {"not valid JSON"}},
           {"{\"name\": \"x\", \"arity\": \"2\", " + mask + "}",
            {"\"arity\" must be a number, not a string"}},
           {file("\"mask\": [1, 1]"), {"f.json:2", "\"mask\" must be an object"}},
           {file("\"mask\": {}"), {"\"first\" is missing"}},
           {file("\"mask\": {\"first\": 0}"), {"\"coefficients\" is missing"}},
           {file("\"mask\": {\"first\": 0.5, \"coefficients\": [2]}"), {"\"first\" must be a whole number"}},
           {file("\"mask\": {\"first\": 99999999999, \"coefficients\": [2]}"), {"from -10000 to 10000"}},
           {file("\"mask\": {\"first\": 0, \"coefs\": [2]}"),
            {"unknown key 'coefs'", "first and coefficients"}},
           {with_mask("[]"), {"f.json:3", "\"coefficients\" is empty"}},
           {with_mask("2"), {"\"coefficients\" must be a list"}},
           {with_mask("[1, null]"), {"coefficient 2", "must be a number or an expression", "null"}},
           {with_mask("[1, [1]]"), {"coefficient 2", "not a list"}},
           {with_mask("[1, \"\"]"), {"coefficient 2", "empty expression"}},
           {with_mask("[1, \"1/\"]"), {"f.json:3", "coefficient 2", "column 3"}},
           {with_mask("[1, \"NaN\"]"),
            {"f.json:3: coefficient 2 (of z^1)", "'NaN' is no finite number", "write one"}},
           {with_mask("[1, NaN]"), {"f.json:3", "not valid JSON"}},
           {with_mask("[1, \"w\"]"), {"unknown name 'w'", "\"parameters\""}},
           {with_mask("[1, \"z\"]"), {"unknown name 'z'"}},
           {file("\"symbol\": \"(1+z\""), {"f.json:2", "\"symbol\"", "expected ')'"}},
           {file("\"symbol\": \"1+y\""), {"f.json:2: symbol", "unknown name 'y'", "Known here: z"}},
           {file("\"symbol\": [1, 1]"), {"\"symbol\" must be a number or an expression"}},
           {file("\"parameters\": [\"w\"], " + mask), {"\"parameters\" must be an object"}},
           {file("\"parameters\": {\"w\": null}, " + mask), {"parameter w", "null"}},
           {file("\"parameters\": {\"w\": \"2*v\"}, " + mask), {"parameter w", "without names", "'v'"}},
           {file("\"parameters\": {\"2w\": 1}, " + mask), {"'2w' cannot name a parameter", "letter"}},
           {file("\"parameters\": {\"\": 1}, " + mask), {"cannot name a parameter"}},
           {file("\"parameters\": {\"z\": 1}, " + mask), {"'z' is the symbol's indeterminate"}},
           {file("\"parameters\": {\"sqrt\": 1}, " + mask), {"'sqrt' is the square root"}},
           {file("\"parameters\": {\"Inf\": 1}, " + mask), {"'Inf' is neither a finite number"}},
           {file("\"source\": 3, " + mask), {"\"source\" must be a string"}}}) {
    try {
      static_cast<void>(parse(c.text));
      ADD_FAILURE() << "accepted: " << c.text;
    } catch (const InputError& error) {
      const std::string message = error.what();
      EXPECT_EQ(message.rfind("f.json", 0), 0U) << message;
      for (const char* piece : c.pieces)
        EXPECT_NE(message.find(piece), std::string::npos) << message << "\n" << piece;
    }
  }
}

TEST(SchemeFile, HasAtMostAThousandCoefficients) {
  std::string list = "[2";
  for (int i = 1; i < 1000; ++i) list += ",0";
  EXPECT_EQ(parse(with_mask(list + "]")).coefficients.size(), 1000U);
  expect_input_error([&] { return parse(with_mask(list + ",0]")); },
                     {"f.json:3", "1001 coefficients", "at most 1000"});
}

TEST(SchemeFile, IsReadFromARegularFileOfModerateSize) {
  const ScratchFolder folder;
  const std::string good = folder.write("good.json", four_point_file);
  EXPECT_EQ(read_scheme_file(good).path, good);
  expect_input_error([&] { return read_scheme_file(folder.path("none.json")); },
                     {"none.json", "no such file"});
  expect_input_error([&] { return read_scheme_file(folder.path("")); }, {"is a folder"});
  const std::string large = folder.write("large.json", std::string(10'000'000, ' ') + four_point_file);
  expect_input_error([&] { return read_scheme_file(large); }, {"large.json", "larger than 1 MB"});
  expect_input_error([] { return read_scheme_file("/dev/null"); }, {"no regular file"});
}

TEST(ParameterName, IsAnIdentifierWithoutAMeaningOfItsOwn) {
  for (const char* name : {"w", "omega", "s_old", "x2", "_a"}) {
    EXPECT_NO_THROW(require_parameter_name(name, "here")) << name;
  }
  for (const char* name :
       {"", "2x", "a-b", "a b", "z", "sqrt", "nan", "NaN", "inf", "Infinity", "\xc3\xa9"}) {
    expect_input_error([&] { require_parameter_name(name, "here"); }, {"here: "});
  }
}

}  // namespace
}  // namespace subdiv
