#include "schemes/json_document.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/schemes/input_errors.h"

namespace subdiv {
namespace {

using testing::expect_input_error;
using Kind = JsonValue::Kind;

JsonValue parse(const std::string& text) { return parse_json(text, "f.json"); }

TEST(JsonDocument, KeepsNumbersAsTheyAreWritten) {
  const JsonValue list =
      parse("[0.1, -0.10, 1e-3, 2E+5, 12345678901234567890123, 0.1234567890123456789, 7, -7]");
  std::vector<std::string> written;
  for (const JsonValue& v : list.elements) {
    EXPECT_EQ(v.kind, Kind::number);
    written.push_back(v.text);
  }
  EXPECT_EQ(written, (std::vector<std::string>{"0.1", "-0.10", "1e-3", "2E+5", "12345678901234567890123",
                                               "0.1234567890123456789", "7", "-7"}));
}

TEST(JsonDocument, BuildsTheTreeInOrder) {
  const JsonValue root = parse(R"({"b": [true, null, {"x": "y\n\u00e9"}], "a": {}})");
  ASSERT_EQ(root.kind, Kind::object);
  ASSERT_EQ(root.members.size(), 2U);
  EXPECT_EQ(root.members[0].first, "b");
  const JsonValue& b = *root.find("b");
  ASSERT_EQ(b.elements.size(), 3U);
  EXPECT_EQ(b.elements[0].kind, Kind::boolean);
  EXPECT_EQ(b.elements[1].kind, Kind::null);
  EXPECT_EQ(b.elements[2].find("x")->text, "y\n\xc3\xa9");
  EXPECT_EQ(root.find("a")->kind, Kind::object);
  EXPECT_EQ(root.find("c"), nullptr);
}

TEST(JsonDocument, EveryValueKnowsItsLine) {
  const JsonValue root = parse("{\n\"a\": 1,\n\"b\":\n2\n,\"c\": [\n\"x\",\n0.5\n],\n\"d\": true\n}\n");
  EXPECT_EQ(root.line, 1);
  EXPECT_EQ(root.find("a")->line, 2);
  EXPECT_EQ(root.find("b")->line, 4);
  EXPECT_EQ(root.find("c")->line, 5);
  EXPECT_EQ(root.find("c")->elements[0].line, 6);
  EXPECT_EQ(root.find("c")->elements[1].line, 7);
  EXPECT_EQ(root.find("d")->line, 9);
}

TEST(JsonDocument, MalformedTextHasLineAndColumn) {
  struct Case {
    const char* text;
    const char* place;
  };
  for (const Case& c : std::vector<Case>{{"{\"a\": 1,\n \"b\" 2}", "f.json:2: column 6"},
                                         {"[1, 2", "f.json:1: column 6"},
                                         {"{\n\n", "f.json:3: column 1"},
                                         {"[NaN]", "f.json:1: column 2"},
                                         {"[1,]", "f.json:1: column 4"},
                                         {"[01]", "f.json:1: column 3"},
                                         {"[1] [2]", "f.json:1: column 5"},
                                         {"['a']", "f.json:1: column 2"},
                                         {"\"\xff\"", "f.json:1: column 2"},
                                         {"[1e999]", "f.json:1: column 6"}}) {
    expect_input_error([&] { return parse(c.text); }, {c.place, "not valid JSON"});
  }
}

TEST(JsonDocument, MessagesHoldNoControlCharacters) {
  try {
    static_cast<void>(parse("[\"\x1b[31m\"]"));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).find('\x1b'), std::string::npos);
  }
}

TEST(JsonDocument, RefusesDoubledNamesDepthAndSize) {
  expect_input_error([] { return parse("{\"a\": 1,\n\"a\": 2}"); }, {"f.json:2", "'a' occurs twice"});
  expect_input_error([] { return parse(std::string(100'000, '[')); }, {"nested levels"});
  std::string many = "{";
  for (int i = 0; i < 1001; ++i) many += (i > 0 ? "," : "") + ("\"" + std::to_string(i) + "\":0");
  expect_input_error([&] { return parse(many + "}"); }, {"more than 1000 entries"});
}

}  // namespace
}  // namespace subdiv
