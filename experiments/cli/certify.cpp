#include <algorithm>
#include <iostream>
#include <set>
#include <stdexcept>
#include <utility>

#include <nlohmann/json.hpp>

#include "analysis/continuity_certificate.h"
#include "analysis/sum_rules.h"
#include "experiments/cli/over.h"
#include "experiments/cli/verbs.h"
#include "experiments/report/record.h"
#include "experiments/report/utf8.h"
#include "schemes/input_error.h"
#include "schemes/instantiate.h"
#include "schemes/text.h"

namespace subdiv::cli {
namespace {

using Json = nlohmann::ordered_json;
using Names = std::vector<std::string>;

std::string status_text(Decision smooth) {
  if (smooth == Decision::undecided) return "undecided";
  return smooth == Decision::yes ? "proved" : "refuted";
}

std::string status_text(const std::optional<Decision>& status) {
  return status ? status_text(*status) : "mixed";
}

std::string decimal(const Algebraic& x, std::string DecimalEnds::* side) {
  const Interval value = x.to_interval();
  return decimal_ends(value.lower(), value.upper(), Rigour::certified).*side;
}

constexpr int shown_digits = 3;

/// An upper bound, as it is printed.
std::string volume_text(const Rational& volume) {
  return volume.sign() == 0 ? "0" : to_significant(volume, shown_digits, 1);
}

Json words_json(const std::vector<Word>& words) {
  Json json = Json::array();
  for (const Word& word : words) json.push_back(word_text(word));
  return json;
}

Json cell_json(const CertificateCell& cell) {
  Json json = {{"status", status_text(cell.smooth)}};
  for (const char* key : {"lower", "upper", "lower_closed", "upper_closed"}) json[key] = Json::array();
  for (const RealInterval& side : cell.sides) {
    json["lower"].push_back(side.lower->to_string());
    json["upper"].push_back(side.upper->to_string());
    json["lower_closed"].push_back(side.lower_closed);
    json["upper_closed"].push_back(side.upper_closed);
  }
  if (cell.ground == Ground::polytope) {
    json["ground"] = "polytope";
    json["vertices"] = cell.vertices;
    json["sequences"] = cell.sequences;
  } else if (cell.ground == Ground::product) {
    json["ground"] = "product";
    json["words"] = words_json(cell.words);
  } else if (cell.ground != Ground::none) {
    json["ground"] = cell.ground == Ground::value ? "value" : "sum rule";
  }
  return json;
}

/// The ends at which the answer changes inside the range of the only parameter.
Json ends_json(const std::string& name, const std::vector<CertificateCell>& cells) {
  Json ends = Json::array();
  for (std::size_t i = 1; i < cells.size(); ++i) {
    if (cells[i].smooth == cells[i - 1].smooth) continue;
    if (cells[i].smooth == Decision::undecided || cells[i - 1].smooth == Decision::undecided) continue;
    const Algebraic& end = *cells[i].sides[0].lower;
    ends.push_back({{"parameter", name},
                    {"exact", end.to_string()},
                    {"lower", decimal(end, &DecimalEnds::lower)},
                    {"upper", decimal(end, &DecimalEnds::upper)},
                    {"below", status_text(cells[i - 1].smooth)},
                    {"above", status_text(cells[i].smooth)}});
  }
  return ends;
}

std::string continuity_text(int continuity) { return "C^" + std::to_string(continuity); }

std::string limits_text(const DependentValue& value, int continuity) {
  if (value.limits_smooth == Decision::undecided) return "undecided for the limits";
  return (value.limits_smooth == Decision::yes ? "the limits are " : "nor are the limits ") +
         continuity_text(continuity);
}

/// What the answer means, and what it does not.
std::vector<std::string> notes(const ContinuityCertificate& certificate, int continuity, const Names& names) {
  const auto has = [&](auto member, auto value) {
    return std::ranges::find(certificate.cells, value, member) != certificate.cells.end();
  };
  std::vector<std::string> result;
  if (has(&CertificateCell::smooth, Decision::yes)) {
    result.emplace_back("proved: scheme and limits, for each single parameter value at all levels");
  }
  if (has(&CertificateCell::sequences, true)) {
    result.emplace_back(
        "where one polytope serves a whole cell, also for values that change from level to level within "
        "this one cell");
  }
  if (!certificate.exceptions.empty()) {
    Names equations;
    for (const Polynomial& e : certificate.exceptions) equations.push_back(e.to_string(names) + " = 0");
    result.push_back("undecided where a further sum rule holds: " + joined(equations, "and"));
  }
  if (!has(&CertificateCell::smooth, Decision::no)) return result;
  result.push_back(
      "refuted: the scheme's differences exclude " + continuity_text(continuity) +
      "; limits may be smoother where shifts of the basis function are dependent" +
      (certificate.dependent && certificate.dependent->empty() ? ", which is nowhere here" : "") +
      (certificate.dependent ? "" : " (these values are not determined)"));
  if (!certificate.dependent) return result;
  for (const DependentValue& value : *certificate.dependent) {
    result.push_back("dependent at " + value.value.to_string() + ": " + limits_text(value, continuity));
  }
  return result;
}

Json certificate_json(const CertifyOptions& options, const std::vector<ParameterRange>& over,
                      const ContinuityCertificate& certificate, const Names& names) {
  Json box = Json::array();
  for (const ParameterRange& range : over) {
    box.push_back(
        {{"parameter", range.name}, {"lower", range.lower.to_string()}, {"upper", range.upper.to_string()}});
  }
  Json cells = Json::array();
  for (const CertificateCell& cell : certificate.cells) cells.push_back(cell_json(cell));
  Json json = {{"scheme", options.scheme},  {"continuity", options.continuity},
               {"over", std::move(box)},    {"status", status_text(certificate.status())},
               {"cells", std::move(cells)}, {"undecided_volume", volume_text(certificate.undecided)}};
  if (over.size() == 1) json["ends"] = ends_json(over[0].name, certificate.cells);
  if (!certificate.exceptions.empty()) {
    json["exceptions"] = Json::array();
    for (const Polynomial& e : certificate.exceptions) json["exceptions"].push_back(e.to_string(names));
  }
  if (certificate.dependent) {
    json["dependent"] = Json::array();
    for (const DependentValue& value : *certificate.dependent) {
      json["dependent"].push_back(
          {{"value", value.value.to_string()}, {"limits", status_text(value.limits_smooth)}});
    }
  }
  json["notes"] = notes(certificate, options.continuity, names);
  return json;
}

void print_line(const std::string& name, const std::string& value) {
  constexpr std::size_t name_width = 16;
  std::cout << padded(name, name_width) << value << "\n";
}

std::string ground_text(const CertificateCell& cell) {
  switch (cell.ground) {
    case Ground::polytope:
      return std::to_string(cell.vertices) + " vertices" + (cell.sequences ? " of one polytope" : " at most");
    case Ground::product: {
      Names words;
      for (const Word& word : cell.words) words.push_back(word_text(word));
      return (words.size() == 1 ? "product " : "products ") + joined(words, "and");
    }
    case Ground::sum_rule:
      return "a sum rule fails";
    case Ground::value:
      return "by its joint spectral radius";
    case Ground::none:
      break;
  }
  return "";
}

void print_cells(const std::vector<ParameterRange>& over, const std::vector<CertificateCell>& cells) {
  for (const CertificateCell& cell : cells) {
    Names sides;
    for (std::size_t k = 0; k < cell.sides.size(); ++k)
      sides.push_back(over[k].name + " in " + RealSet{{cell.sides[k]}}.to_string());
    std::string text = joined(sides, "and");
    if (const std::string ground = ground_text(cell); !ground.empty())
      text.append("  (").append(ground).append(")");
    print_line(status_text(cell.smooth), text);
  }
}

/// Sums of many cells of boxes.
void print_sums(const std::vector<CertificateCell>& cells) {
  for (const Decision smooth : {Decision::yes, Decision::no, Decision::undecided}) {
    Rational sum(0);
    std::size_t count = 0;
    for (const CertificateCell& cell : cells) {
      if (cell.smooth != smooth) continue;
      ++count;
      Rational volume(1);
      for (const RealInterval& side : cell.sides) {
        if (!side.is_point()) volume *= side.upper->to_rational() - side.lower->to_rational();
      }
      sum += volume;
    }
    if (count == 0) continue;
    print_line(status_text(smooth),
               std::to_string(count) + " cells, volume " + to_significant(sum, shown_digits));
  }
}

void print(const CertifyOptions& options, const std::vector<ParameterRange>& over,
           const ContinuityCertificate& certificate, const Names& names) {
  print_line("scheme", options.scheme);
  for (const ParameterRange& range : over) {
    print_line("over", range.name + " in [" + range.lower.to_string() + ", " + range.upper.to_string() + "]");
  }
  print_line(continuity_text(options.continuity), status_text(certificate.status()));
  constexpr std::size_t most_lines = 20;
  if (over.size() == 1 || certificate.cells.size() <= most_lines) {
    print_cells(over, certificate.cells);
  } else {
    print_sums(certificate.cells);
  }
  for (const Json& end : over.size() == 1 ? ends_json(over[0].name, certificate.cells) : Json::array()) {
    const auto lower = end["lower"].get<std::string>();
    const auto upper = end["upper"].get<std::string>();
    const auto exact = end["exact"].get<std::string>();
    if (exact.find_first_not_of("-/0123456789") == std::string::npos) continue;  // the cells show all of it
    const auto differ = std::mismatch(lower.begin(), lower.end(), upper.begin(), upper.end()).first;
    print_line("end", over[0].name + " = " + std::string(lower.begin(), differ) + "..");
  }
  if (certificate.undecided.sign() != 0)
    print_line("undecided", "volume " + volume_text(certificate.undecided) + " at most");
  for (const std::string& note : notes(certificate, options.continuity, names)) print_line("note", note);
}

Scheme<RationalFunction> certifiable_scheme(const SchemeDescription& description) {
  Scheme<RationalFunction> scheme = symbolic_scheme(description);
  for (std::size_t i = 0; i < scheme.steps.size(); ++i) {
    if (const auto violation = violated_affine_invariance(scheme.steps[i])) {
      throw InputError(description.steps[i].text + ": the step violates the first sum rule: " + *violation +
                       "; each of the " + std::to_string(scheme.arity()) + " rules must sum to 1");
    }
  }
  return scheme;
}

}  // namespace

int certify(const CertifyOptions& options) {
  const SchemeDescription description = parse_scheme(options.scheme);
  const std::vector<ParameterRange> over =
      parse_over(options.over, description.free_parameters, RangeEnds::may_coincide);
  const Scheme<RationalFunction> scheme = certifiable_scheme(description);
  ParameterBox box;
  for (const ParameterRange& range : over) {
    box.lower.push_back(range.lower);
    box.upper.push_back(range.upper);
  }
  CertificateOptions budget;
  budget.seconds = options.budget;
  ContinuityCertificate certificate;
  try {
    if (over.size() == 1) {
      for (const Mask<RationalFunction>& step : scheme.steps) require_no_pole(step, box);
    }
    certificate = certify_continuity(scheme.last(), options.continuity, box, budget);
  } catch (const std::domain_error& error) {
    throw InputError(options.scheme + " over " + options.over + ": " + error.what());
  }
  if (options.json) {
    std::cout << certificate_json(options, over, certificate, description.free_parameters).dump(2) << "\n";
  } else {
    print(options, over, certificate, description.free_parameters);
  }
  return certificate.status() == Decision::undecided ? ExitCode::undecided : ExitCode::done;
}

}  // namespace subdiv::cli
