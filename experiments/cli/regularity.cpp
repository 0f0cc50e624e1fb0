#include "experiments/cli/regularity.h"

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "analysis/hoelder.h"
#include "analysis/iterate_norm.h"
#include "analysis/iterate_norm_range.h"
#include "analysis/nonnegative_symbol.h"
#include "analysis/reif.h"
#include "analysis/sobolev.h"
#include "analysis/sum_rules.h"
#include "analysis/transition_matrices.h"
#include "schemes/input_error.h"

namespace subdiv::cli {
namespace {

/// The largest power k that is tried, so that the m^k residue classes stay few.
int greatest_power(int arity, long most_classes) {
  int power = 0;
  for (long classes = arity; classes <= most_classes; classes *= arity) ++power;
  return power;
}

ContinuityText certificate(int order, int power, const DecimalEnds& norm, std::string exact = "") {
  return {.order = order,
          .set = "",
          .interval = {},
          .norm = norm,
          .exact_norm = std::move(exact),
          .power = power};
}

/// The least power with a norm below 1 among the exact norms of the powers 0, 1, ..
template <class R>
std::optional<int> contracting_power(const std::vector<R>& norms) {
  for (std::size_t k = 1; k < norms.size(); ++k) {
    if (norms[k] < R(1)) return static_cast<int>(k);
  }
  return std::nullopt;
}

/// The least power of the difference scheme whose norm is below 1, with that norm: exact for small powers.
std::optional<ContinuityText> certify(const Laurent<Rational>& difference, int arity, int order) {
  constexpr long most_exact_classes = 1L << 8U;
  constexpr long most_classes = 1L << 18U;
  const int exact_power = greatest_power(arity, most_exact_classes);
  const std::vector<Rational> norms = iterate_norms(difference, arity, exact_power);
  if (const auto k = contracting_power(norms)) {
    const Rational& norm = norms[static_cast<std::size_t>(*k)];
    return certificate(order, *k, decimal_ends(norm, norm, Rigour::exact), norm.to_string());
  }
  for (int k = exact_power + 1; k <= greatest_power(arity, most_classes); ++k) {
    const Enclosure norm = iterate_norm_enclosure(difference, arity, k);
    if (norm.upper < Rational(1))
      return certificate(order, k, decimal_ends(norm.lower, norm.upper, norm.rigour));
  }
  return std::nullopt;
}

std::optional<ContinuityText> certify(const Laurent<Algebraic>& difference, int arity, int order) {
  constexpr long most_classes = 1L << 3U;  // exact algebraic numbers are slow
  const std::vector<Algebraic> norms = iterate_norms(difference, arity, greatest_power(arity, most_classes));
  const auto k = contracting_power(norms);
  if (!k) return std::nullopt;
  const Interval norm = norms[static_cast<std::size_t>(*k)].to_interval();
  return certificate(order, *k, decimal_ends(norm.lower(), norm.upper(), Rigour::certified));
}

ContinuityText necessary_condition(int order, std::string set = "") {
  return {.order = order, .set = std::move(set), .interval = {}, .norm = {}, .exact_norm = "", .power = 0};
}

/// Truncated towards zero as far as both ends agree; where they straddle a round number, with what they may
/// be off; and as an interval when that leaves little.
std::string decimal_line(const Enclosure& x) {
  constexpr int most = 16;
  constexpr int least = 4;
  for (int decimals = most; decimals >= least; --decimals) {
    const Rational unit = pow(Rational(10), -decimals);
    const Rational towards_zero = x.lower.sign() < 0 ? -floor(-x.upper / unit) : floor(x.lower / unit);
    const Rational far_end = x.lower.sign() < 0 ? -floor(-x.lower / unit) : floor(x.upper / unit);
    if (towards_zero == far_end && towards_zero.sign() != 0) {
      return to_decimal(towards_zero * unit, decimals) + "..";
    }
    if (x.width() < unit) {
      constexpr int digits = 2;
      const Rational middle = floor(x.midpoint() / unit + Rational(1, 2)) * unit;
      return to_decimal(middle, decimals) + " +- " +
             to_significant(std::max(x.upper - middle, middle - x.lower) * Rational(11, 10), digits);
    }
  }
  const DecimalEnds ends = decimal_ends(x.lower, x.upper, x.rigour);
  return "in [" + ends.lower + ", " + ends.upper + "]";
}

EnclosureText text_of(const Enclosure& x) {
  EnclosureText text{decimal_ends(x.lower, x.upper, x.rigour), x.exact, x.exact, x.rigour, x.status};
  if (x.exact.empty()) {
    text.line = x.lower == x.upper ? x.lower.to_string() : decimal_line(x);
  } else if (x.lower != x.upper || x.exact.find('/') != std::string::npos) {
    text.line += " = " + decimal_line(x);
  }
  return text;
}

/// rho m^(1-n): how fast the first differences grow from step to step, where that is at least 1/m.
EnclosureText growth_text(const Smoothness& smoothness, int arity) {
  const Rational scale = pow(Rational(arity), 1 - smoothness.factors);
  const Rational least(1, arity);
  Enclosure growth = smoothness.radius.value;
  growth.lower = std::max(growth.lower * scale, least);
  growth.upper = std::max(growth.upper * scale, least);
  growth.exact.clear();
  if (smoothness.radius.exact) {
    growth.exact = std::max(*smoothness.radius.exact * Algebraic(scale), Algebraic(least)).to_string();
  }
  return text_of(growth);
}

SmoothnessText text_of(const Smoothness& smoothness, int arity) {
  SmoothnessText text;
  text.continuity = smoothness.continuity;
  text.continuity_limit = smoothness.continuity_limit;
  text.converges = smoothness.converges;
  text.exponent = text_of(smoothness.exponent);
  text.attained = smoothness.attained;
  text.factors = smoothness.factors;
  text.radius = text_of(smoothness.radius.value);
  text.growth = growth_text(smoothness, arity);
  for (const Word& word : smoothness.radius.words) text.words.push_back(word_text(word));
  return text;
}

NormalForm<Interval> as_intervals(const NormalForm<Interval>& form) { return form; }
template <class R>
NormalForm<Interval> as_intervals(const NormalForm<R>& form) {
  return enclose(form);
}

template <class R>
std::string polynomial_text(const Laurent<R>& p) {
  std::string text;
  for (int i = p.first(); i <= p.last(); ++i) {
    text += (text.empty() ? "" : ", ") + p[i].to_string();
  }
  return "(" + text + ")";
}

void require_agreement(bool agree, const std::string& routes) {
  if (!agree) throw std::logic_error("two routes to the smoothness contradict each other: " + routes);
}

/// The L2 exponent s of independent shifts, with s - 1/2 <= Hoelder exponent <= s; the radius of the single
/// matrix.
template <class R>
void add_second_routes(RegularityText& result, const SmoothnessReport<R>& report) {
  constexpr int longest = 16;
  const NormalForm<R>& form = report.reduction.form;
  if (form.degree() > longest || report.reduction.reduced_independent != Decision::yes) return;
  JointSpectralRadiusBudget budget;
  budget.seconds = 2;
  const Enclosure l2 = sobolev_exponent(as_intervals(form), budget);
  result.l2_exponent = text_of(l2);
  const Enclosure& exponent = report.limits.exponent;
  require_agreement(l2.lower - Rational(1, 2) <= exponent.upper && exponent.lower <= l2.upper,
                    "Hoelder and L2 exponent");
  if constexpr (std::is_same_v<R, Rational>) {
    if (!is_nonnegative(form)) return;
    const Enclosure single = nonnegative_radius(form);
    result.single_matrix_radius = text_of(single);
    const Enclosure& joint = report.limits.radius.value;
    require_agreement(single.lower <= joint.upper && joint.lower <= single.upper,
                      "joint spectral radius and largest eigenvalue of the single matrix");
  }
}

template <class R>
RegularityText joint_regularity(const NormalForm<R>& form, const RegularityOptions& options) {
  JointSpectralRadiusBudget budget;
  budget.seconds = options.seconds;
  const SmoothnessReport<R> report = smoothness_report(form, budget);
  RegularityText result;
  result.scheme = text_of(report.scheme, form.arity);
  result.limits = text_of(report.limits, form.arity);
  result.independent_shifts = report.reduction.independent;
  if (report.reduction.t.size() > 1) result.shift_factor = polynomial_text(report.reduction.t);
  if (options.second_routes) add_second_routes(result, report);
  return result;
}

template <class R>
RegularityText constant_regularity(const Mask<R>& mask, const RegularityOptions& options) {
  RegularityText result = joint_regularity(normal_form(mask), options);
  if (!options.second_routes) return result;
  const int necessary = reif_order(mask);
  result.necessary.push_back(necessary_condition(necessary));
  for (int order = necessary; order >= 0 && result.certified.empty(); --order) {
    const auto difference = difference_symbol(mask, order);
    if (!difference) continue;
    if (auto proof = certify(*difference, mask.arity, order)) result.certified.push_back(*std::move(proof));
  }
  require_agreement(result.scheme->continuity <= necessary, "joint spectral radius and Reif's condition");
  require_agreement(result.certified.empty() || result.certified[0].order <= result.scheme->continuity_limit,
                    "joint spectral radius and norms of powers");
  return result;
}

/// The sum rule of order + 1 in words.
std::string sum_rule_text(int order, int arity) {
  const std::string power = order == 0 ? "a_i" : order == 1 ? "i a_i" : "i^" + std::to_string(order) + " a_i";
  return "sum rule " + std::to_string(order + 1) + ": the sum of " + power + " over i = r mod " +
         std::to_string(arity) + (order == 0 ? " is 1" : " is the same") + " for every r";
}

/// The form with `more` factors besides those already split off; nothing when no symbol within the intervals
/// has them.
std::optional<NormalForm<Interval>> form_with(const FactoredSymbol<Interval>& symbol, int arity, int more) {
  try {
    // sigma^n c(z) with the factors of c, but n more, has the normal form of m^n c(z).
    const Interval scale(pow(Rational(arity), symbol.smoothing_factors));
    NormalForm<Interval> form =
        normal_form(Mask<Interval>{arity, Laurent<Interval>::constant(scale) * symbol.cofactor}, more);
    form.factors += symbol.smoothing_factors;
    return form;
  } catch (const std::domain_error&) {
    return std::nullopt;
  }
}

/// The mask over the rationals when no parameter occurs in it.
std::optional<Mask<Rational>> constant_mask(const Mask<RationalFunction>& mask) {
  for (const RationalFunction& c : mask.symbol.coefficients()) {
    if (!c.is_constant()) return std::nullopt;
  }
  return map_coefficients(mask, [](const RationalFunction& c) { return c.constant(); });
}

/// The one parameter that the coefficients use; nothing when there are more.
std::optional<int> only_parameter(const Mask<RationalFunction>& mask) {
  std::optional<int> found;
  for (const RationalFunction& c : mask.symbol.coefficients()) {
    for (int i = 0; i < max_free_parameters; ++i) {
      if (!c.numerator().uses(i) && !c.denominator().uses(i)) continue;
      if (found && *found != i) return std::nullopt;
      found = i;
    }
  }
  return found;
}

/// Values inside the set to start searches from: seven in each part of finite length, those in the middle
/// first.
std::vector<Rational> interior_values(const RealSet& set) {
  constexpr int eighths[] = {4, 2, 6, 1, 3, 5, 7};
  std::vector<Rational> values;
  for (const RealInterval& part : set.parts) {
    if (part.is_point() || !part.lower || !part.upper) continue;
    const Rational lower = part.lower->to_interval().midpoint();
    const Rational length = part.upper->to_interval().midpoint() - lower;
    for (const int i : eighths) {
      const Rational centre = lower + length * Rational(i, 8);
      values.push_back(simplest_between(centre - length / Rational(64), centre + length / Rational(64)));
    }
  }
  return values;
}

/// The certified interval of the parameter x_0, for the largest power tried: the proof reaches to the inner
/// sides of the ends' enclosures.
ContinuityText range_certificate(int order, const NormRange& range) {
  const Rational& low = range.lower.value.upper;
  const Rational& high = range.upper.value.lower;
  const DecimalEnds interval{decimal_ends(low, low, Rigour::exact).upper,
                             decimal_ends(high, high, Rigour::exact).lower};
  return {
      .order = order, .set = "", .interval = interval, .norm = {}, .exact_norm = "", .power = range.power};
}

std::optional<ContinuityText> certified_range(const Mask<RationalFunction>& mask, int order,
                                              const RealSet& necessary) {
  constexpr int most_power = 8;
  try {
    const DifferenceFamily family = difference_family(mask, order);
    for (const Rational& interior : interior_values(necessary)) {
      NormRangeOptions options;
      options.interior = interior;
      options.max_power = most_power;
      const auto ranges = iterate_norm_ranges(family, options);
      if (!ranges.empty()) return range_certificate(order, ranges.back());
    }
    return std::nullopt;
  } catch (const std::domain_error&) {  // no polynomials, or sum rules that fail for some values
    return std::nullopt;
  }
}

}  // namespace

RegularityText regularity(const Mask<Rational>& mask, std::span<const std::string> /*names*/,
                          const RegularityOptions& options) {
  return constant_regularity(mask, options);
}

RegularityText regularity(const Mask<Algebraic>& mask, std::span<const std::string> /*names*/,
                          const RegularityOptions& options) {
  return constant_regularity(mask, options);
}

int allowed_sum_rules(const FactoredSymbol<Interval>& symbol, int arity) {
  int more = 0;
  while (form_with(symbol, arity, more + 1)) ++more;
  return symbol.smoothing_factors + more;
}

RegularityText regularity(const FactoredSymbol<Interval>& symbol, int arity,
                          const RegularityOptions& options) {
  const int factors = allowed_sum_rules(symbol, arity);
  if (factors == 0) {
    throw InputError(
        "the first sum rule fails by more than the coefficients are uncertain: those with index = r mod " +
        std::to_string(arity) + " must add up to 1 for every r");
  }
  const auto form = form_with(symbol, arity, factors - symbol.smoothing_factors);
  RegularityText result = joint_regularity(*form, options);
  if (symbol.smoothing_factors > 0 && sum(symbol.cofactor).radius() > 0) {
    result.assumptions.push_back("the coefficients add up to " + std::to_string(arity));
  }
  for (int order = symbol.smoothing_factors; order < factors; ++order) {
    result.assumptions.push_back(sum_rule_text(order, arity));
  }
  return result;
}

RegularityText regularity(const Mask<RationalFunction>& mask, std::span<const std::string> names,
                          const RegularityOptions& options) {
  if (const auto constant = constant_mask(mask)) return constant_regularity(*constant, options);
  RegularityText result;
  const auto parameter = only_parameter(mask);
  if (!parameter) return result;
  result.parameter = names[static_cast<std::size_t>(*parameter)];
  std::vector<RationalFunction> as_first(static_cast<std::size_t>(max_parameters),
                                         RationalFunction::variable(0));
  const auto renamed = map_coefficients(mask, [&](const RationalFunction& c) {
    return c.evaluate(std::span<const RationalFunction>(as_first));
  });
  for (int order = 0;; ++order) {
    const RealSet set = reif_set(renamed, order);
    if (set.is_empty()) break;
    result.necessary.push_back(necessary_condition(order, set.to_string()));
    if (auto range = certified_range(renamed, order, set)) result.certified.push_back(*std::move(range));
  }
  return result;
}

}  // namespace subdiv::cli
