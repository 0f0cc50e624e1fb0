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

namespace subdiv::cli {
namespace {

using Names = std::vector<std::string>;

std::string text_of(const Rational& value, const Names& /*names*/) { return value.to_string(); }
std::string text_of(const Algebraic& value, const Names& /*names*/) { return value.to_string(); }
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

/// Without affine invariance there is no limit mask and little else; the message says which sum is wrong.
template <class R>
void require_limit_mask(const SchemeDescription& description, const Scheme<R>& scheme,
                        const MaskAnswer& limit_mask) {
  for (std::size_t i = 0; i < scheme.steps.size(); ++i) {
    if (const auto violation = violated_affine_invariance(scheme.steps[i])) {
      throw InputError(description.steps[i].text + ": the step is not affinely invariant: " + *violation +
                       "; each of the " + std::to_string(scheme.arity()) + " rules must sum to 1");
    }
  }
  if (limit_mask.mask) return;
  throw InputError(description.text + ": division by zero, the limit does not exist for these values (" +
                   limit_mask.reason + "); choose other values");
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

template <class R>
SchemeAnalysis analyse_over(const SchemeDescription& description, const Scheme<R>& scheme) {
  const Names& names = description.free_parameters;
  SchemeAnalysis result;
  result.limit_mask = answer<R>([&] { return vertex_limit_mask(scheme); }, names);
  require_limit_mask(description, scheme, result.limit_mask);
  result.text = description.text;
  result.arity = scheme.arity();
  result.free_parameters = names;
  result.steps = step_texts(description);
  for (std::size_t i = 0; i < scheme.steps.size(); ++i) {
    result.steps[i].mask = mask_text(scheme.steps[i].symbol, names);
  }
  const auto [low, high] = basis_support(scheme);
  result.support = {low.to_string(), high.to_string()};
  result.parametric_shift = text_of(parametric_shift(scheme), names);
  result.sum_rules = sum_rule_order(scheme);
  result.generation_degree = generation_degree(scheme);
  result.reproduction_degree = reproduction_degree(scheme);
  result.tangent_mask = answer<R>([&] { return vertex_tangent_mask(scheme); }, names);
  result.skipped = too_long(scheme);
  result.area_mask.reason = result.skipped;
  if (!result.skipped.empty()) return result;
  result.eigenvalues = eigenvalue_texts(scheme.last(), names);
  result.area_mask = answer<R>([&] { return area_mask(scheme); }, names);
  result.regularity = regularity(scheme.last(), names);
  return result;
}

}  // namespace

SchemeAnalysis analyse(const SchemeDescription& description) {
  return std::visit([&](const auto& scheme) { return analyse_over(description, scheme); },
                    exact_scheme(description));
}

}  // namespace subdiv::cli
