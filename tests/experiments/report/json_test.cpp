#include "experiments/report/json.h"

#include <gtest/gtest.h>

#include "schemes/input_error.h"

namespace subdiv {
namespace {

std::vector<ClaimRecord> sample() {
  const ClaimHead number{"area.r",  "js-report",        "8",
                         "-0.0299", ClaimKind::rounded, "Linf, \"quoted\"\nsecond line"};
  const ClaimHead finding{"area.minimum", "subdivlab", "8", std::nullopt, ClaimKind::exact, "φ_s"};
  return {to_record(settle(number, certified(Rational(-299, 10000), Rational(-298, 10000), ""), "a note")),
          to_record(settle_statement(finding, true, "(1, 2)/3"))};
}

/// The message with which the text is rejected; empty when it is accepted.
std::string rejection(const std::string& text) {
  try {
    (void)claims_from_json(text, "results/claims.json");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string with(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

void expect_contains(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << "'" << part << "' is not in: " << text;
}

TEST(ClaimsJson, RoundTrip) {
  const auto claims = sample();
  EXPECT_EQ(claims_from_json(claims_to_json(claims), "claims.json"), claims);
  EXPECT_EQ(claims_to_json(claims_from_json(claims_to_json(claims), "claims.json")), claims_to_json(claims));
}

TEST(ClaimsJson, HasTheKeysThatOthersRead) {
  const std::string text = claims_to_json(sample());
  for (const char* key : {"claims", "id", "document", "section", "printed", "kind", "definition", "value",
                          "exact", "lower", "upper", "rigour", "verdict", "note"}) {
    expect_contains(text, "\"" + std::string(key) + "\":");
  }
  expect_contains(text, "\"printed\": null");
}

TEST(ClaimsJson, NamesLineAndColumnOfASyntaxError) {
  expect_contains(rejection("{\n  \"claims\": [}\n"), "results/claims.json:2:14:");
  expect_contains(rejection("{\n  \"claims\": [}\n"), "subdivlab reproduce");
  expect_contains(rejection(""), "results/claims.json:1:1:");
  const std::string whole = claims_to_json(sample());
  expect_contains(rejection(whole.substr(0, whole.size() / 2)), "not valid JSON");
}

TEST(ClaimsJson, NamesWhatIsMissingOrOfTheWrongType) {
  const std::string text = claims_to_json(sample());
  expect_contains(rejection("[]"), "expected an object");
  expect_contains(rejection("{}"), "key 'claims' is missing");
  expect_contains(rejection("{\"claims\": 3}"), "key 'claims' must be an array");
  expect_contains(rejection("{\"claims\": [3]}"), "claim 1: expected an object");
  expect_contains(rejection(with(text, "\"verdict\"", "\"verdikt\"")),
                  "claim 1 ('area.r'): key 'verdict' is missing");
  expect_contains(rejection(with(text, "\"lower\"", "\"lowest\"")), "key 'value': key 'lower' is missing");
  expect_contains(rejection(with(text, "\"upper\": \"-0.0298", "\"upper\": \"about -0.0298")),
                  "decimal string");
  expect_contains(rejection(with(text, "\"rounded\"", "7")), "key 'kind' must be a string");
  expect_contains(rejection(with(text, "\"rounded\"", "\"rouded\"")), "must be one of exact, rounded");
  expect_contains(rejection(with(text, "area.minimum", "area.r")),
                  "claim 2 ('area.r'): key 'id' occurs twice");
}

TEST(ManifestJson, RoundTripAndFileNames) {
  const Manifest manifest{{{"norms", "smoothness", ""}},
                          {{"basis", "fit", "Basis functions φ", "Curves: \"a\"", {"fit.a", "fit.b."}}},
                          {"fit.a"},
                          {"README.md"}};
  const Manifest again = manifest_from_json(manifest_to_json(manifest), "manifest.json");
  EXPECT_EQ(again.series, manifest.series);
  EXPECT_EQ(again.figures, manifest.figures);
  EXPECT_EQ(again.certificates, manifest.certificates);
  EXPECT_EQ(again.pages, manifest.pages);
  const std::string outside = "{\"series\": [{\"name\": \"../x\", \"experiment\": \"a\"}], \"figures\": []}";
  EXPECT_THROW((void)manifest_from_json(outside, "manifest.json"), InputError);
}

}  // namespace
}  // namespace subdiv
