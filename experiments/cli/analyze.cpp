#include <iostream>

#include <nlohmann/json.hpp>

#include "experiments/cli/scheme_analysis.h"
#include "experiments/cli/verbs.h"
#include "experiments/report/utf8.h"
#include "schemes/text.h"

namespace subdiv::cli {
namespace {

using Json = nlohmann::ordered_json;

std::string continuity_name(int order) { return order < 0 ? "none" : "C" + std::to_string(order); }

Json to_json(const MaskText& mask) { return {{"first", mask.first}, {"coefficients", mask.coefficients}}; }

Json to_json(const MaskAnswer& answer) { return answer.mask ? to_json(*answer.mask) : Json(nullptr); }

Json to_json(const StepText& step) {
  Json parameters = Json::object();
  for (const auto& [name, value] : step.parameters) parameters[name] = value;
  return {{"name", step.name}, {"parameters", std::move(parameters)}, {"mask", to_json(step.mask)}};
}

Json to_json(const DecimalEnds& ends) { return {{"lower", ends.lower}, {"upper", ends.upper}}; }

Json to_json(const EigenvalueText& eigenvalue) {
  Json json = Json::object();
  if (eigenvalue.value) json["value"] = *eigenvalue.value;
  if (eigenvalue.roots_of) json["roots_of"] = *eigenvalue.roots_of;
  if (eigenvalue.imaginary) {
    json["real"] = to_json(*eigenvalue.real);
    json["imaginary"] = to_json(*eigenvalue.imaginary);
  } else if (eigenvalue.real) {
    json.update(to_json(*eigenvalue.real));
  }
  json["multiplicity"] = eigenvalue.multiplicity;
  return json;
}

Json scheme_json(const SchemeAnalysis& analysis) {
  Json scheme = {{"name", analysis.text}, {"arity", analysis.arity}};
  if (analysis.steps.size() == 1) {
    const Json step = to_json(analysis.steps[0]);
    scheme["parameters"] = step["parameters"];
    scheme["mask"] = step["mask"];
  } else {
    scheme["steps"] = Json::array();
    for (const StepText& step : analysis.steps) scheme["steps"].push_back(to_json(step));
  }
  if (!analysis.free_parameters.empty()) scheme["free_parameters"] = analysis.free_parameters;
  return scheme;
}

Json to_json(const EnclosureText& x) {
  Json json = Json::object();
  if (!x.exact.empty()) json["value"] = x.exact;
  json.update(to_json(x.ends));
  json["rigour"] = to_string(x.rigour);
  json["status"] = to_string(x.status);
  return json;
}

Json smp_json(const SmoothnessText& smoothness) {
  return smoothness.words.empty() ? Json(nullptr) : Json(smoothness.words[0]);
}

/// `continuity` is what is proved; `continuity_at_most` bounds it where the two differ.
Json to_json(const SmoothnessText& smoothness) {
  Json json = {{"continuity", continuity_name(smoothness.continuity)}};
  if (smoothness.continuity_limit != smoothness.continuity) {
    json["continuity_at_most"] = continuity_name(smoothness.continuity_limit);
  }
  json["converges"] = to_string(smoothness.converges);
  json["hoelder"] = nullptr;
  if (smoothness.converges != Decision::no) {
    json["hoelder"] = to_json(smoothness.exponent);
    json["hoelder"]["attained"] = to_string(smoothness.attained);
  }
  json["smp"] = smp_json(smoothness);
  json["smoothing_factors"] = smoothness.factors;
  json["joint_spectral_radius"] = to_json(smoothness.radius);
  json["joint_spectral_radius"]["words"] = smoothness.words;
  json["first_difference_growth"] = to_json(smoothness.growth);
  return json;
}

Json certified_json(const ContinuityText& c) {
  Json entry = {{"continuity", continuity_name(c.order)}, {"power", c.power}};
  if (c.interval) entry["interval"] = to_json(*c.interval);
  if (c.norm) entry["norm"] = to_json(*c.norm);
  if (!c.exact_norm.empty()) entry["norm"]["value"] = c.exact_norm;
  return entry;
}

/// The first keys speak of the limits; `limits` and `scheme` tell all of both apart.
Json regularity_json(const RegularityText& regularity) {
  const bool parametric = !regularity.parameter.empty();
  Json json = Json::object();
  if (regularity.limits) {
    const Json limits = to_json(*regularity.limits);
    for (const char* key : {"continuity", "hoelder", "smp"}) json[key] = limits[key];
    json["status"] = regularity.closed() ? "closed" : "undecided";
    json["limits"] = limits;
    json["scheme"] = to_json(*regularity.scheme);
    json["independent_shifts"] = to_string(regularity.independent_shifts);
    if (!regularity.shift_factor.empty()) json["shift_factor"] = regularity.shift_factor;
  } else {
    json["continuity"] = nullptr;
  }
  if (regularity.l2_exponent) json["l2_exponent"] = to_json(*regularity.l2_exponent);
  if (regularity.single_matrix_radius) {
    json["single_matrix_radius"] = to_json(*regularity.single_matrix_radius);
  }
  if (!regularity.assumptions.empty()) json["assumptions"] = regularity.assumptions;
  if (parametric) json["parameter"] = regularity.parameter;
  json["certified"] = Json::array();
  for (const ContinuityText& c : regularity.certified) json["certified"].push_back(certified_json(c));
  json["necessary"] = Json::array();
  for (const ContinuityText& c : regularity.necessary) {
    Json entry = {{"continuity", continuity_name(c.order)}};
    if (parametric) entry["set"] = c.set;
    json["necessary"].push_back(std::move(entry));
  }
  return json;
}

Json optional_json(const std::optional<int>& x) { return x ? Json(*x) : Json(nullptr); }

Json analysis_json(const SchemeAnalysis& analysis) {
  Json json = {{"scheme", scheme_json(analysis)},
               {"support", {analysis.support.first, analysis.support.second}},
               {"parametric_shift", analysis.parametric_shift},
               {"sum_rules", analysis.sum_rules},
               {"generation_degree", analysis.generation_degree},
               {"reproduction_degree", optional_json(analysis.reproduction_degree)}};
  json["eigenvalues"] = analysis.skipped.empty() ? Json::array() : Json(nullptr);
  for (const EigenvalueText& eigenvalue : analysis.eigenvalues)
    json["eigenvalues"].push_back(to_json(eigenvalue));
  json["limit_mask"] = to_json(analysis.limit_mask);
  json["tangent_mask"] = to_json(analysis.tangent_mask);
  json["area_mask"] = to_json(analysis.area_mask);
  json["regularity"] = regularity_json(analysis.regularity);
  Json reasons = Json::object();
  if (!analysis.limit_mask.mask) reasons["limit_mask"] = analysis.limit_mask.reason;
  if (!analysis.tangent_mask.mask) reasons["tangent_mask"] = analysis.tangent_mask.reason;
  if (!analysis.area_mask.mask) reasons["area_mask"] = analysis.area_mask.reason;
  if (!analysis.skipped.empty()) reasons["eigenvalues"] = analysis.skipped;
  if (!analysis.reproduction_degree) reasons["reproduction_degree"] = analysis.skipped;
  if (!reasons.empty()) json["reasons"] = std::move(reasons);
  if (!analysis.remark.empty()) json["remark"] = analysis.remark;
  return json;
}

void print_line(const std::string& name, const std::string& value) {
  constexpr std::size_t name_width = 22;
  std::cout << padded(name, name_width) << value << "\n";
}

/// A mask on one line, or, where that is too long, a coefficient a line with its index.
void print_mask(const std::string& name, const MaskText& mask) {
  std::string line = "from index " + std::to_string(mask.first) + ": (";
  for (std::size_t i = 0; i < mask.coefficients.size(); ++i)
    line += (i == 0 ? "" : ", ") + mask.coefficients[i];
  line += ")";
  constexpr std::size_t most = 78;
  if (line.size() <= most) {
    print_line(name, line);
    return;
  }
  for (std::size_t i = 0; i < mask.coefficients.size(); ++i) {
    const std::string index = std::to_string(mask.first + static_cast<int>(i));
    print_line(i == 0 ? name : "", std::string(index.size() < 3 ? 3 - index.size() : 0, ' ') + index + ": " +
                                       mask.coefficients[i]);
  }
}

void print_mask(const std::string& name, const MaskAnswer& answer) {
  if (answer.mask) {
    print_mask(name, *answer.mask);
  } else {
    print_line(name, "none: " + answer.reason);
  }
}

std::string eigenvalue_line(const EigenvalueText& eigenvalue) {
  std::string text;
  if (eigenvalue.value) {
    text = *eigenvalue.value;
  } else if (eigenvalue.roots_of) {
    text = "roots of " + *eigenvalue.roots_of;
  } else {
    constexpr std::size_t shown = 17;
    text = eigenvalue.real->lower.substr(0, shown) + "..";
    if (eigenvalue.imaginary) text += " + " + eigenvalue.imaginary->lower.substr(0, shown) + ".. i";
  }
  return eigenvalue.multiplicity == 1 ? text
                                      : text + " (" + std::to_string(eigenvalue.multiplicity) + " times)";
}

std::string certified_line(const ContinuityText& c, const std::string& parameter) {
  const std::string power = "power " + std::to_string(c.power) + " of the difference scheme has norm ";
  if (c.interval) {
    return continuity_name(c.order) + " for " + c.interval->lower + " < " + parameter + " < " +
           c.interval->upper + ": " + power + "below 1";
  }
  return continuity_name(c.order) + ": " + power +
         (c.exact_norm.empty() ? c.norm->upper + " at most" : c.exact_norm);
}

std::string necessary_line(const ContinuityText& c, const std::string& parameter) {
  if (parameter.empty() && c.order < 0) return "divergent, by Reif's necessary condition";
  if (parameter.empty()) return "at most " + continuity_name(c.order) + ", by Reif's necessary condition";
  return continuity_name(c.order) + " only for " + parameter + " in " + c.set;
}

std::string smoothness_line(const SmoothnessText& smoothness) {
  const std::string growth = "growth of first differences a step " + smoothness.growth.line;
  if (smoothness.converges == Decision::no) return "divergent: " + growth + ", not below 1";
  std::string text = continuity_name(smoothness.continuity);
  if (smoothness.continuity < 0) text = "convergence undecided, " + growth;
  if (smoothness.continuity_limit != smoothness.continuity) {
    text += ", at most " + continuity_name(smoothness.continuity_limit);
  }
  text += "; Hoelder exponent " + smoothness.exponent.line;
  if (smoothness.attained != Decision::undecided)
    text += smoothness.attained == Decision::yes ? ", attained" : ", not attained";
  if (smoothness.exponent.status != Status::closed) {
    text += " (undecided: " + to_string(smoothness.exponent.status) + ")";
  } else if (!smoothness.closed()) {
    text += " (undecided: the coefficients leave it open)";
  }
  return text;
}

std::string radius_line(const SmoothnessText& smoothness) {
  constexpr std::size_t most = 3;
  std::vector<std::string> shown = smoothness.words;
  shown.resize(std::min(most, shown.size()));
  const std::string words =
      shown.empty() ? "" : (shown.size() == 1 ? ", word " : ", words ") + joined(shown, "and");
  return smoothness.radius.line + words + ", after " + std::to_string(smoothness.factors) +
         " smoothing factors";
}

void print(const RegularityText& regularity) {
  if (regularity.limits) {
    const bool same = regularity.shift_factor.empty() && regularity.independent_shifts == Decision::yes;
    print_line(same ? "smoothness" : "limits", smoothness_line(*regularity.limits));
    print_line("joint spectral radius", radius_line(*regularity.limits));
    if (!same) {
      print_line("scheme", smoothness_line(*regularity.scheme));
      print_line("joint spectral radius", radius_line(*regularity.scheme));
      print_line("shifts",
                 regularity.shift_factor.empty()
                     ? "not proved to be independent"
                     : "dependent: the symbol has a factor t(z^m)/t(z), t = " + regularity.shift_factor);
    }
  }
  if (regularity.l2_exponent) print_line("L2 exponent", regularity.l2_exponent->line);
  if (regularity.single_matrix_radius) {
    print_line("single matrix",
               "of radius " + regularity.single_matrix_radius->line + ": the symbol is not negative");
  }
  std::string name = "assumed";
  for (const std::string& assumption : regularity.assumptions) {
    print_line(name, assumption);
    name.clear();
  }
  name = "certified";
  for (const ContinuityText& c : regularity.certified) {
    print_line(name, certified_line(c, regularity.parameter));
    name.clear();
  }
  name = "necessary";
  for (const ContinuityText& c : regularity.necessary) {
    print_line(name, necessary_line(c, regularity.parameter));
    name.clear();
  }
  if (!regularity.limits && regularity.necessary.empty()) {
    print_line("regularity", "not decided for several free parameters: give values");
  }
}

void print(const SchemeAnalysis& analysis) {
  print_line("scheme", analysis.text);
  print_line("arity", std::to_string(analysis.arity));
  for (const StepText& step : analysis.steps) {
    print_mask(analysis.steps.size() == 1 ? "mask" : "mask of " + step.name, step.mask);
  }
  print_line("support", "[" + analysis.support.first + ", " + analysis.support.second + "]");
  print_line("parametric shift", analysis.parametric_shift);
  print_line("sum rules", std::to_string(analysis.sum_rules));
  print_line("generation degree", std::to_string(analysis.generation_degree));
  if (analysis.reproduction_degree) {
    print_line("reproduction degree", std::to_string(*analysis.reproduction_degree));
  }
  std::string name = "eigenvalues";
  if (!analysis.skipped.empty()) print_line(name, analysis.skipped);
  for (const EigenvalueText& eigenvalue : analysis.eigenvalues) {
    print_line(name, eigenvalue_line(eigenvalue));
    name.clear();
  }
  print_mask("limit mask", analysis.limit_mask);
  print_mask("tangent mask", analysis.tangent_mask);
  print_mask("area mask", analysis.area_mask);
  print(analysis.regularity);
  if (!analysis.remark.empty()) print_line("remark", analysis.remark);
}

}  // namespace

int analyze(const AnalyzeOptions& options) {
  SchemeOptions reading;
  reading.rounded = options.rounded;
  const SchemeAnalysis analysis = analyse(parse_scheme(options.scheme, reading), options.budget);
  if (options.json) {
    std::cout << analysis_json(analysis).dump(2) << "\n";
  } else {
    print(analysis);
  }
  const bool open = analysis.regularity.limits && !analysis.regularity.closed();
  return open ? ExitCode::undecided : ExitCode::done;
}

}  // namespace subdiv::cli
