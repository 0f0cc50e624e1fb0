#include "experiments/cli/regularity.h"

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "analysis/iterate_norm.h"
#include "analysis/iterate_norm_range.h"
#include "analysis/reif.h"
#include "analysis/sum_rules.h"

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
  constexpr long most_classes = 1L << 5U;  // exact algebraic numbers are slow
  const std::vector<Algebraic> norms = iterate_norms(difference, arity, greatest_power(arity, most_classes));
  const auto k = contracting_power(norms);
  if (!k) return std::nullopt;
  const Interval norm = norms[static_cast<std::size_t>(*k)].to_interval();
  return certificate(order, *k, decimal_ends(norm.lower(), norm.upper(), Rigour::certified));
}

ContinuityText necessary_condition(int order, std::string set = "") {
  return {.order = order, .set = std::move(set), .interval = {}, .norm = {}, .exact_norm = "", .power = 0};
}

template <class R>
RegularityText constant_regularity(const Mask<R>& mask) {
  RegularityText result;
  const int necessary = reif_order(mask);
  result.necessary.push_back(necessary_condition(necessary));
  for (int order = necessary; order >= 0 && result.certified.empty(); --order) {
    const auto difference = difference_symbol(mask, order);
    if (!difference) continue;
    if (auto proof = certify(*difference, mask.arity, order)) result.certified.push_back(*std::move(proof));
  }
  result.closed = necessary < 0 || (!result.certified.empty() && result.certified[0].order == necessary);
  return result;
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

RegularityText regularity(const Mask<Rational>& mask, std::span<const std::string> /*names*/) {
  return constant_regularity(mask);
}

RegularityText regularity(const Mask<Algebraic>& mask, std::span<const std::string> /*names*/) {
  return constant_regularity(mask);
}

RegularityText regularity(const Mask<RationalFunction>& mask, std::span<const std::string> names) {
  if (const auto constant = constant_mask(mask)) return constant_regularity(*constant);
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
