#include "experiments/cli/scheme_analysis.h"

#include <algorithm>
#include <array>
#include <functional>
#include <stdexcept>
#include <type_traits>

#include "analysis/area_mask.h"
#include "analysis/eigenvalues.h"
#include "analysis/limit_mask.h"
#include "analysis/reproduction.h"
#include "experiments/cli/regularity.h"
#include "schemes/input_error.h"
#include "schemes/instantiate.h"
#include "schemes/text.h"

namespace subdiv::cli {
namespace {

using Names = std::vector<std::string>;

std::string text_of(const Rational& value, const Names& /*names*/) { return value.to_string(); }
std::string text_of(const Algebraic& value, const Names& /*names*/) { return value.to_string(); }
std::string text_of(const Interval& value, const Names& /*names*/) { return value.to_string(); }
std::string text_of(const RationalFunction& value, const Names& names) {
  return value.to_factored_string(names);
}

template <class R>
MaskText mask_text(const Laurent<R>& mask, const Names& names) {
  MaskText text{mask.first(), {}};
  for (const R& c : mask.coefficients()) text.coefficients.push_back(text_of(c, names));
  return text;
}

template <class R>
MaskAnswer answer(const std::function<Laurent<R>()>& question, const Names& names) {
  try {
    return {mask_text(question(), names), ""};
  } catch (const std::domain_error& error) {
    return {std::nullopt, error.what()};
  }
}

DecimalEnds ends_of(const Interval& x) { return decimal_ends(x.lower(), x.upper(), Rigour::certified); }

/// Real numbers of degree above 2 have no closed form worth reading: their text names the polynomial and one
/// decimal.
EigenvalueText eigenvalue_text(const Eigenvalue& eigenvalue) {
  EigenvalueText text;
  text.multiplicity = eigenvalue.multiplicity;
  constexpr long closed_form_degree = 2;
  if (eigenvalue.exact && eigenvalue.exact->degree() <= closed_form_degree)
    text.value = eigenvalue.exact->to_string();
  if (!eigenvalue.exact || !eigenvalue.exact->is_rational()) text.real = ends_of(eigenvalue.real);
  if (!eigenvalue.is_real()) text.imaginary = ends_of(eigenvalue.imaginary);
  return text;
}

template <class R>
std::vector<EigenvalueText> eigenvalue_texts(const Mask<R>& mask, const Names& /*names*/) {
  std::vector<EigenvalueText> texts;
  for (const Eigenvalue& eigenvalue : eigenvalues(subdivision_matrix(mask)))
    texts.push_back(eigenvalue_text(eigenvalue));
  return texts;
}

template <>
std::vector<EigenvalueText> eigenvalue_texts(const Mask<RationalFunction>& mask, const Names& names) {
  const ParametricSpectrum spectrum = eigenvalues(subdivision_matrix(mask));
  std::vector<EigenvalueText> texts;
  for (const auto& [value, multiplicity] : spectrum.values) {
    texts.push_back({text_of(value, names), std::nullopt, std::nullopt, std::nullopt, multiplicity});
  }
  std::vector<std::string> with_eigenvalue(static_cast<std::size_t>(max_parameters), "x");
  std::copy(names.begin(), names.end(), with_eigenvalue.begin());
  for (const auto& [factor, multiplicity] : spectrum.factors) {
    texts.push_back(
        {std::nullopt, std::nullopt, std::nullopt, factor.to_string(with_eigenvalue), multiplicity});
  }
  return texts;
}

std::vector<StepText> step_texts(const SchemeDescription& description) {
  std::vector<StepText> steps;
  for (const StepDescription& step : description.steps) {
    StepText text{step.name(), {}, {}};
    for (const Argument& argument : step.arguments)
      text.parameters.emplace_back(argument.name, argument.value.text());
    steps.push_back(std::move(text));
  }
  return steps;
}

constexpr const char* advice_on_rounding =
    ", no more than the rounding of the written decimals; with --rounded every decimal is an interval";

/// The sum rules that a scheme's decimals allow when they are taken as rounded; -1 when there is nothing to
/// round.
int rules_within_rounding(const SchemeDescription& description, std::size_t step) {
  const StepDescription& written = description.steps[step];
  if (!description.free_parameters.empty() || !written.file || !written.file->has_decimals()) return -1;
  const SchemeDescription rounded{written.text, {written}, {}, true};
  return allowed_sum_rules(factored_interval_symbols(rounded)[0], written.arity());
}

/// Without affine invariance there is no limit mask and little else; the message says which sum is wrong.
template <class R>
void require_affine_invariance(const SchemeDescription& description, const Scheme<R>& scheme) {
  for (std::size_t i = 0; i < scheme.steps.size(); ++i) {
    if (const auto violation = violated_affine_invariance(scheme.steps[i])) {
      const bool rounding = rules_within_rounding(description, i) > 0;
      throw InputError(description.steps[i].text + ": the step is not affinely invariant: " + *violation +
                       (rounding
                            ? std::string(advice_on_rounding)
                            : "; each of the " + std::to_string(scheme.arity()) + " rules must sum to 1"));
    }
  }
}

void require_limit_mask(const SchemeDescription& description, const MaskAnswer& limit_mask) {
  if (limit_mask.mask) return;
  throw InputError(description.text + ": division by zero, the limit does not exist for these values (" +
                   limit_mask.reason + "); choose other values");
}

/// By how much the next sum rule is missed, when rounding of the repeating step's decimals explains it.
std::string rounding_remark(const SchemeDescription& description, const Mask<Rational>& mask) {
  const int order = sum_rules(mask).order;
  if (rules_within_rounding(description, description.steps.size() - 1) <= order) return "";
  Rational least = residue_moment(mask, 0, order);
  Rational most = least;
  for (int r = 1; r < mask.arity; ++r) {
    const Rational moment = residue_moment(mask, r, order);
    least = std::min(least, moment);
    most = std::max(most, moment);
  }
  constexpr int digits = 3;
  return "sum rule " + std::to_string(order + 1) + " is missed by " + to_significant(most - least, digits) +
         advice_on_rounding;
}

template <class R>
std::string rounding_remark(const SchemeDescription& /*description*/, const Mask<R>& /*mask*/) {
  return "";
}

/// Why the expensive questions are left out; empty when they are not.
template <class R>
std::string too_long(const Scheme<R>& scheme) {
  constexpr int most = std::is_same_v<R, Rational> ? 40 : 16;
  for (const Mask<R>& mask : scheme.steps) {
    if (mask.symbol.size() <= most) continue;
    return "not computed: the mask has " + std::to_string(mask.symbol.size()) +
           " coefficients, exact answers are given up to " + std::to_string(most);
  }
  return "";
}

/// Masks of limits and tangents are formal where there are none.
void withdraw_formal_masks(SchemeAnalysis& analysis) {
  const std::optional<SmoothnessText>& limits = analysis.regularity.limits;
  if (!limits) return;
  if (limits->converges == Decision::no) {
    analysis.limit_mask = analysis.tangent_mask = analysis.area_mask = {std::nullopt, "the scheme diverges"};
  } else if (limits->continuity_limit < 1) {
    analysis.tangent_mask = {std::nullopt, "the limits are not C1"};
  }
}

/// What needs no more than the masks.
template <class R>
SchemeAnalysis described(const SchemeDescription& description, const Scheme<R>& scheme) {
  SchemeAnalysis result;
  result.text = description.text;
  result.arity = scheme.arity();
  result.free_parameters = description.free_parameters;
  result.steps = step_texts(description);
  for (std::size_t i = 0; i < scheme.steps.size(); ++i) {
    result.steps[i].mask = mask_text(scheme.steps[i].symbol, description.free_parameters);
  }
  const auto [low, high] = basis_support(scheme);
  result.support = {low.to_string(), high.to_string()};
  return result;
}

template <class R>
SchemeAnalysis analyse_over(const SchemeDescription& description, const Scheme<R>& scheme, double seconds) {
  const Names& names = description.free_parameters;
  require_affine_invariance(description, scheme);
  SchemeAnalysis result = described(description, scheme);
  result.limit_mask = answer<R>([&] { return vertex_limit_mask(scheme); }, names);
  require_limit_mask(description, result.limit_mask);
  result.parametric_shift = text_of(parametric_shift(scheme), names);
  result.sum_rules = sum_rule_order(scheme);
  result.generation_degree = generation_degree(scheme);
  result.reproduction_degree = reproduction_degree(scheme);
  result.tangent_mask = answer<R>([&] { return vertex_tangent_mask(scheme); }, names);
  result.remark = rounding_remark(description, scheme.last());
  result.skipped = too_long(scheme);
  result.area_mask.reason = result.skipped;
  result.regularity = regularity(scheme.last(), names, {seconds, result.skipped.empty()});
  if (result.skipped.empty()) {
    result.eigenvalues = eigenvalue_texts(scheme.last(), names);
    result.area_mask = answer<R>([&] { return area_mask(scheme); }, names);
  }
  withdraw_formal_masks(result);
  return result;
}

/// tau of Conti & Hormann 2011 (analysis/reproduction.h), from the means of the steps.
Interval shift_over_intervals(const Scheme<Interval>& scheme) {
  const auto mean = [&](const Mask<Interval>& mask) {
    Interval sum(0);
    for (int r = 0; r < mask.arity; ++r) sum += residue_moment(mask, r, 1);
    return sum / Interval(mask.arity);
  };
  Interval tau = mean(scheme.last()) / Interval(scheme.arity() - 1);
  for (std::size_t k = scheme.steps.size() - 1; k-- > 0;) {
    tau = (mean(scheme.steps[k]) + tau) / Interval(scheme.arity());
  }
  return tau;
}

/// Whether a scheme file of the scheme holds decimals.
bool has_decimals(const SchemeDescription& description) {
  return std::any_of(description.steps.begin(), description.steps.end(),
                     [](const StepDescription& step) { return step.file && step.file->has_decimals(); });
}

/// Of masks known as intervals only.
SchemeAnalysis analyse_intervals(const SchemeDescription& description, double seconds) {
  const Scheme<Interval> scheme = interval_scheme(description);
  const std::vector<FactoredSymbol<Interval>> symbols = factored_interval_symbols(description);
  SchemeAnalysis result = described(description, scheme);
  try {
    result.regularity = regularity(symbols.back(), scheme.arity(), {seconds, true});
  } catch (const InputError& error) {
    throw InputError(description.steps.back().text + ": " + error.what());
  }
  int rules = result.regularity.scheme->factors;
  for (std::size_t i = 0; i + 1 < symbols.size(); ++i) {
    rules = std::min(rules, allowed_sum_rules(symbols[i], scheme.arity()));
  }
  if (rules < 1) throw InputError(description.text + ": a step is not affinely invariant");
  const Names none;
  result.parametric_shift = text_of(shift_over_intervals(scheme), none);
  result.sum_rules = rules;
  result.generation_degree = rules - 1;
  result.skipped = "not computed: the coefficients are known as intervals only";
  result.area_mask.reason = result.skipped;
  result.limit_mask = answer<Interval>([&] { return vertex_limit_mask(scheme); }, none);
  result.tangent_mask = answer<Interval>([&] { return vertex_tangent_mask(scheme); }, none);
  withdraw_formal_masks(result);
  return result;
}

}  // namespace

SchemeAnalysis analyse(const SchemeDescription& description, double seconds) {
  const bool constant = description.free_parameters.empty();
  const bool rounded = description.rounded && has_decimals(description);
  if (rounded && !constant) {
    throw InputError(description.text + ": rounded coefficients need values for the free parameters " +
                     joined(description.free_parameters, "and"));
  }
  if (rounded || (constant && smallest_field(description) == Field::inexact)) {
    return analyse_intervals(description, seconds);
  }
  return std::visit([&](const auto& scheme) { return analyse_over(description, scheme, seconds); },
                    exact_scheme(description));
}

}  // namespace subdiv::cli
