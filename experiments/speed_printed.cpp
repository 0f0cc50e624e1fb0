#include "experiments/speed_printed.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include <fmt/format.h>

#include "schemes/adjustable_speed/speed_rules.h"
#include "schemes/expression.h"

namespace subdiv {
namespace {

using Function = RationalFunction;
using Stencil = SectorStencil<Function>;

const Function s = Function::variable(0);
const Function q = Function(1) - s;

constexpr std::array<std::pair<const char*, const char*>, 8> abbreviations{{{"e1", "s^2 + q"},
                                                                            {"e2", "s^2 + 3*q"},
                                                                            {"f1", "q - s"},
                                                                            {"f2", "q + 1"},
                                                                            {"f3", "2*q^2 - 1"},
                                                                            {"f4", "q^3 + q^2 - s"},
                                                                            {"d1", "1 + q"},
                                                                            {"d2", "6 - 4*s + s^2"}}};

using Rules = std::map<std::string, Stencil>;

int mirrored(int label) { return 10 * (label % 10) + label / 10; }
std::string mirrored(const std::string& target) { return {target.rbegin(), target.rend()}; }

/// The rules at sector_places, by the paper's numbers.
Rules by_number(const std::vector<Stencil>& rules) {
  Rules result;
  const std::vector<FanPlace> places = sector_places(4, 3);
  constexpr int last = 13;
  for (int k = 2; k <= last; ++k) {
    for (std::size_t p = 0; p < rules.size(); ++p) {
      if (10 * (3 - places[p].a) + 3 - places[p].b == label_of_number(k))
        result.emplace(std::to_string(k), rules[p]);
    }
  }
  return result;
}

/// Weights of numbers 4, 9 and 10 are those of 6, 13 and 12 with the mirrored label.
std::vector<PrintedIndex> images_of_numbers(const PrintedIndex& entry) {
  const auto& [k, label] = entry;
  std::vector<PrintedIndex> result;
  if (k == "3" || k == "7" || k == "11") result.emplace_back(k, mirrored(label));
  if (k == "4") result.emplace_back("6", mirrored(label));
  if (k == "9") result.emplace_back("13", mirrored(label));
  if (k == "10") result.emplace_back("12", mirrored(label));
  if ((k == "2" || k == "5" || k == "8") && label % 10 == 2) result.emplace_back(k, label + 2);
  return result;
}

/// w^rs_ij = w^sr_ji and w^4s_3j = w^2s_3j, and what follows from both.
std::vector<PrintedIndex> images_in_border(const PrintedIndex& entry) {
  const auto& [target, label] = entry;
  std::vector<PrintedIndex> result{{mirrored(target), mirrored(label)}};
  if (target.front() == '3' && label / 10 == 2) {
    result.emplace_back(target, label + 20);
    result.emplace_back(mirrored(target), mirrored(label + 20));
  }
  return result;
}

/// (1 + q)^2 times the weights of the Bezier coefficients, by their indices.
Rules scaled_border() {
  Rules result;
  const auto border = tensor_border(s);
  const Function factor = (Function(1) + q) * (Function(1) + q);
  for (std::size_t k = 0; k < border.size(); ++k) {
    if (!border[k]) continue;
    Stencil scaled{border[k]->centre * factor, border[k]->terms};
    for (Stencil::Term& term : scaled.terms) term.weight *= factor;
    result.emplace(fmt::format("{}{}", k / 4, k % 4), std::move(scaled));
  }
  return result;
}

}  // namespace

int label_of_number(int k) {
  constexpr std::array labels{33, 23, 22, 21, 13, 12, 11, 3, 2, 1, 0, 10, 20};
  return labels.at(static_cast<std::size_t>(k - 1));
}

Function value_of_text(const std::string& text) {
  return evaluate<Function>(Expression::parse(text), [](const std::string& name, const auto&) -> Function {
    if (name == "s") return s;
    if (name == "q") return q;
    for (const auto& [abbreviation, meaning] : abbreviations) {
      if (name == abbreviation) return value_of_text(meaning);
    }
    throw std::logic_error("the paper has no abbreviation '" + name + "'");
  });
}

std::string greek(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == 's') {
      result += "σ";
    } else if (c == 'q') {
      result += "σ̄";
    } else {
      result += c == '*' ? ' ' : c;
    }
  }
  return result;
}

Function weight_of(const Stencil& stencil, int label) {
  const SectorPlace at = sector_place(3 - label / 10, 3 - label % 10);
  if (at.place < 0) return stencil.centre;
  for (const Stencil::Term& term : stencil.terms) {
    if (term.sector == at.sector && term.place == at.place) return term.weight;
  }
  return {};
}

bool holds(const PrintedTable& table, const PrintedWeight& printed) {
  const auto rule = table.rules.find(printed.target);
  return rule != table.rules.end() && weight_of(rule->second, printed.source) == value_of_text(printed.text);
}

bool is_complete(const PrintedTable& table) {
  std::map<PrintedIndex, Function> all;
  for (const PrintedWeight& w : table.weights) {
    all.emplace(PrintedIndex{w.target, w.source}, value_of_text(w.text));
    for (const PrintedIndex& image : table.images({w.target, w.source}))
      all.emplace(image, value_of_text(w.text));
  }
  std::size_t computed = 0;
  for (const auto& [target, rule] : table.rules)
    computed += rule.terms.size() + (rule.centre.is_zero() ? 0 : 1);
  return computed == all.size() && std::ranges::all_of(all, [&](const auto& entry) {
           const auto rule = table.rules.find(entry.first.first);
           return rule != table.rules.end() && weight_of(rule->second, entry.first.second) == entry.second;
         });
}

const Rules& refined_by_number() {
  static const Rules rules = by_number(refined_places(s));
  return rules;
}

const PrintedTable& printed_refinement() {
  static const PrintedTable table{
      "4",
      "w",
      "II, equation (4)",
      "Weights of the third ring over Q(sigma): tensor products of the insertion of q a into the knots 0, a, "
      "a/q, a/q^2, q = 1 - sigma.",
      {{"8", 12, "s*q/2"},
       {"8", 13, "e1"},
       {"9", 12, "q"},
       {"9", 13, "s"},
       {"10", 11, "q^3"},
       {"10", 12, "s*e2"},
       {"11", 11, "1"}},
      [] {
        Rules rules = refined_by_number();
        std::erase_if(rules, [](const auto& rule) { return std::stoi(rule.first) < 8; });
        return rules;
      }(),
      images_of_numbers};
  return table;
}

const PrintedTable& recovered_refinement() {
  static const PrintedTable table{"3",
                                  "w",
                                  "II, equation (3)",
                                  printed_refinement().definition,
                                  {{"2", 23, "q*e1"},
                                   {"2", 33, "s*e1"},
                                   {"2", 22, "s*q^2/2"},
                                   {"2", 32, "s^2*q/2"},
                                   {"3", 22, "q^2"},
                                   {"3", 23, "s*q"},
                                   {"3", 33, "s^2"},
                                   {"4", 21, "q^4"},
                                   {"4", 31, "s*q^3"},
                                   {"4", 22, "s*q*e2"},
                                   {"4", 32, "s^2*e2"},
                                   {"5", 13, "q^3*e1"},
                                   {"5", 23, "s*e1*e2"},
                                   {"5", 12, "s*q^4/2"},
                                   {"5", 22, "s^2*q*e2/2"},
                                   {"7", 11, "q^6"},
                                   {"7", 12, "s*q^3*e2"},
                                   {"7", 22, "s^2*e2^2"}},
                                  [] {
                                    Rules rules = refined_by_number();
                                    std::erase_if(rules,
                                                  [](const auto& rule) { return std::stoi(rule.first) > 7; });
                                    return rules;
                                  }(),
                                  images_of_numbers};
  return table;
}

const PrintedTable& printed_conversion() {
  static const PrintedTable table{
      "11",
      "ẇ",
      "V-A, equation (11)",
      "Weights over Q(sigma) of the change from the knots 0, 1, 2, 3 to 0, 1, 1/q, 1/q^2 that keeps the "
      "polynomials on [0, 1] to second order at 1, and the vertex.",
      {{"1", 33, "1"},
       {"2", 23, "f2/(3*q)"},
       {"2", 33, "f1/(3*q)"},
       {"3", 22, "f2^2/(9*q^2)"},
       {"3", 23, "f1*f2/(9*q^2)"},
       {"3", 33, "f1^2/(9*q^2)"},
       {"4", 21, "f2/(18*q^4)"},
       {"4", 31, "f1/(18*q^4)"},
       {"4", 22, "f2*f4/(9*q^4)"},
       {"4", 32, "f1*f4/(9*q^4)"},
       {"4", 23, "f1*f2*f3/(18*q^4)"},
       {"4", 33, "f1^2*f3/(18*q^4)"},
       {"5", 13, "1/(6*q^3)"},
       {"5", 23, "f4/(3*q^3)"},
       {"5", 33, "f1*f3/(6*q^3)"},
       {"7", 11, "1/(36*q^6)"},
       {"7", 21, "f4/(18*q^6)"},
       {"7", 31, "f1*f3/(36*q^6)"},
       {"7", 22, "f4^2/(9*q^6)"},
       {"7", 32, "f1*f3*f4/(18*q^6)"},
       {"7", 33, "f1^2*f3^2/(36*q^6)"}},
      [] {
        Rules rules = by_number(changed_places(uniform_knots<Function>(), unit_speed_knots(s)));
        rules.emplace("1", Stencil{Function(1), {}});
        return rules;
      }(),
      images_of_numbers};
  return table;
}

const PrintedTable& printed_border() {
  static const PrintedTable table{
      "13",
      "w̄",
      "V-C, equation (13)",
      "(1 + q)^2 times the weights over Q(sigma) of the Bezier coefficients on [0, a]^2, values of the polar "
      "form over the knots 0, a, a/q, a/q^2.",
      {{"00", 11, "q^6*d1^2"},
       {"00", 21, "s*q^4*d1*d2"},
       {"00", 31, "s^2*q^3*d1"},
       {"00", 22, "s^2*q^2*d2^2"},
       {"00", 32, "s^3*q*d2"},
       {"00", 33, "s^4"},
       {"10", 21, "2*q^4*d1"},
       {"10", 31, "s*q^3*d1"},
       {"10", 22, "2*s*q^2*d2"},
       {"10", 32, "s^2*q*d2"},
       {"10", 23, "2*s^2*q"},
       {"10", 33, "s^3"},
       {"20", 21, "q^4*d1"},
       {"20", 31, "q^3*d1"},
       {"20", 22, "s*q^2*d2"},
       {"20", 32, "s*q*d2"},
       {"20", 23, "s^2*q"},
       {"20", 33, "s^2"},
       {"30", 21, "(1/2)*q^4*d1"},
       {"30", 31, "q^3*d1"},
       {"30", 22, "(1/2)*s*q^2*d2"},
       {"30", 32, "s*q*d2"},
       {"30", 23, "(1/2)*s^2*q"},
       {"30", 33, "s^2"},
       {"11", 22, "4*q^2"},
       {"11", 32, "2*s*q"},
       {"11", 33, "s^2"},
       {"21", 22, "2*q^2"},
       {"21", 32, "2*q"},
       {"21", 23, "s*q"},
       {"21", 33, "s"},
       {"31", 22, "q^2"},
       {"31", 32, "2*q"},
       {"31", 23, "(1/2)*s*q"},
       {"31", 33, "s"},
       {"22", 22, "q^2"},
       {"22", 32, "q"},
       {"2", 33, "1"},
       {"32", 22, "(1/2)*q^2"},
       {"32", 32, "q"},
       {"32", 23, "(1/2)*q"},
       {"32", 33, "1"}},
      scaled_border(),
      images_in_border};
  return table;
}

namespace {

/// "speed.eq13.w33-22".
std::string id_of(const PrintedTable& table, const PrintedWeight& w) {
  return fmt::format("speed.eq{}.w{}-{}", table.equation, w.source, w.target);
}

std::array<const PrintedTable*, 3> tables() {
  return {&printed_refinement(), &printed_conversion(), &printed_border()};
}

}  // namespace

std::vector<ClaimHead> printed_weight_heads() {
  std::vector<ClaimHead> heads;
  for (const PrintedTable* table : tables()) {
    for (const PrintedWeight& w : table->weights)
      heads.push_back({id_of(*table, w), "speed", table->section,
                       fmt::format("{}^{}_{} = {}", table->symbol, w.source, w.target, greek(w.text)),
                       ClaimKind::exact, table->definition});
  }
  return heads;
}

void add_printed_weights(Results& results, std::span<const ClaimHead> heads) {
  const std::vector<std::string> names{"σ"};
  for (const PrintedTable* table : tables()) {
    for (const PrintedWeight& w : table->weights) {
      const ClaimHead& claim = head(heads, id_of(*table, w));
      const auto rule = table->rules.find(w.target);
      const bool index = rule != table->rules.end();
      const Function found = weight_of(index ? rule->second : table->rules.at("22"), w.source);
      results.claims.push_back(
          settle_statement(claim, holds(*table, w),
                           index ? found.to_factored_string(names) : "w̄^33_22 = " + found.to_string(names),
                           index ? ""
                                 : "A misprint: 2 is no pair of indices. The entry stands in the row of t22 "
                                   "and is the weight of "
                                   "p33 there; with it the weights of t22 have the sum (1 + σ̄)^2."));
    }
  }
}

}  // namespace subdiv
