#include "analysis/continuity_certificate.h"

#include <algorithm>
#include <array>
#include <span>
#include <stdexcept>
#include <utility>

#include "analysis/cell_refinement.h"
#include "analysis/deadline.h"
#include "analysis/hoelder.h"
#include "analysis/line_certificate.h"
#include "analysis/sign_on_interval.h"
#include "analysis/unstable_conditions.h"
#include "schemes/algebra/common_zeros.h"
#include "schemes/algebra/specialize.h"
#include "schemes/algebra/univariate.h"

namespace subdiv {
namespace {

using Function = RationalFunction;

/// One value shall not use up a long budget.
constexpr double most_seconds_of_a_value = 10;

JointSpectralRadiusBudget value_budget(const Deadline& deadline) {
  JointSpectralRadiusBudget budget;
  budget.seconds = std::min(most_seconds_of_a_value, deadline.left());
  return budget;
}

Decision reaches(const Smoothness& smoothness, int continuity) {
  if (smoothness.continuity >= continuity) return Decision::yes;
  return smoothness.continuity_limit < continuity ? Decision::no : Decision::undecided;
}

template <class R>
Mask<R> mask_at(const Mask<Function>& mask, const R& value) {
  return map_coefficients(mask, [&](const Function& f) { return specialize(f, 0, value); });
}

/// f(form) for the mask at x_0 = value, over the rationals when the value is one.
template <class Question>
auto ask_at(const Mask<Function>& mask, const Algebraic& value, Question question) {
  return value.is_rational() ? question(normal_form(mask_at(mask, value.to_rational())))
                             : question(normal_form(mask_at(mask, value)));
}

Decision decide_at(const Mask<Function>& mask, int continuity, const Algebraic& value,
                   const Deadline& deadline) {
  return ask_at(mask, value, [&](const auto& form) {
    return reaches(smoothness(form, value_budget(deadline)), continuity);
  });
}

/// Numerators of what has to vanish for more smoothing factors of b.
std::vector<Polynomial> further_sum_rules(const NormalForm<Function>& form, int more) {
  const Laurent<Function> divisor = pow(smoothing_factor<Function>(form.arity), more);
  std::vector<Polynomial> result;
  const Laurent<Function> remainder = divide_from_below(form.b, divisor).second;
  for (const Function& c : remainder.coefficients()) {
    if (!c.is_zero()) result.push_back(c.numerator());
  }
  return result;
}

std::vector<Algebraic> common_roots(const std::vector<Polynomial>& equations, const Rational& lower,
                                    const Rational& upper) {
  Polynomial common;
  for (const Polynomial& e : equations) common = gcd(common, e);
  std::vector<Algebraic> roots;
  if (common.is_zero() || common.is_constant()) return roots;
  append_real_roots(common, 0, roots);
  std::erase_if(roots, [&](const Algebraic& x) { return x < Algebraic(lower) || x > Algebraic(upper); });
  std::ranges::sort(roots);
  roots.erase(std::unique(roots.begin(), roots.end()), roots.end());
  return roots;
}

CertificateCell whole_cell(const ParameterBox& box, Decision smooth, Ground ground) {
  CertificateCell cell{smooth, {}, smooth == Decision::undecided ? Ground::none : ground, 0, {}, false};
  for (std::size_t k = 0; k < box.lower.size(); ++k)
    cell.sides.push_back(closed_interval(box.lower[k], box.upper[k]));
  return cell;
}

CertificateCell line_cell(RealInterval range, Decision smooth, Ground ground) {
  return {smooth, {std::move(range)}, smooth == Decision::undecided ? Ground::none : ground, 0, {}, false};
}

/// Not smooth but, possibly, at single values.
std::vector<CertificateCell> single_values(const Mask<Function>& mask, int continuity,
                                           const std::vector<Algebraic>& values, const ParameterBox& box,
                                           const Deadline& deadline) {
  std::vector<CertificateCell> cells;
  RealInterval rest = closed_interval(box.lower[0], box.upper[0]);
  for (const Algebraic& x : values) {
    if (*rest.lower < x)
      cells.push_back(line_cell({rest.lower, x, rest.lower_closed, false}, Decision::no, Ground::sum_rule));
    cells.push_back(line_cell({x, x, true, true}, decide_at(mask, continuity, x, deadline), Ground::value));
    rest.lower = x;
    rest.lower_closed = false;
  }
  if (*rest.lower < *rest.upper) cells.push_back(line_cell(rest, Decision::no, Ground::sum_rule));
  return cells;
}

/// Whether one of the equations has no zero in the box, or all of them together have none at all.
bool have_no_zero(const std::vector<Polynomial>& equations, const ParameterBox& box) {
  std::vector<Interval> intervals;
  for (std::size_t k = 0; k < box.lower.size(); ++k)
    intervals.push_back(Interval::hull(box.lower[k], box.upper[k]));
  const bool away = std::ranges::any_of(equations, [&](const Polynomial& e) {
    return !RangedPolynomial(e, box.lower.size()).range(intervals).contains_zero();
  });
  return away || prove_empty({equations, {}}).proved;
}

/// Values at which the shifts are dependent and the scheme is not proved to be smooth.
std::optional<std::vector<DependentValue>> dependent_values(const Mask<Function>& mask,
                                                            const NormalForm<Function>& form, int continuity,
                                                            const ParameterBox& box,
                                                            const std::vector<CertificateCell>& cells,
                                                            const Deadline& deadline) {
  constexpr int most_coefficients = 5;
  if (form.arity != 2 || form.b.size() > most_coefficients) return std::nullopt;
  std::vector<Algebraic> values;
  for (const UnstableCondition& condition : unstable_conditions(form.b)) {
    if (condition.equations.empty()) return std::nullopt;  // dependent for all parameters
    std::ranges::move(common_roots(condition.equations, box.lower[0], box.upper[0]),
                      std::back_inserter(values));
  }
  std::ranges::sort(values);
  values.erase(std::unique(values.begin(), values.end()), values.end());
  std::vector<DependentValue> result;
  for (const Algebraic& x : values) {
    const bool smooth = std::ranges::any_of(cells, [&](const CertificateCell& cell) {
      return cell.smooth == Decision::yes && cell.sides[0].contains(x);
    });
    if (smooth) continue;
    const auto limits = ask_at(mask, x, [&](const auto& at) -> std::optional<Decision> {
      const auto report = smoothness_report(at, value_budget(deadline));
      if (report.reduction.independent == Decision::yes) return std::nullopt;
      return reaches(report.limits, continuity);
    });
    if (limits) result.push_back({x, *limits});
  }
  return result;
}

/// The parameters that matter, renumbered: those that the mask uses and whose range is no point.
struct Reduced {
  Mask<Function> mask;
  ParameterBox box;
  std::vector<std::size_t> kept;
};

Reduced reduced(const Mask<Function>& mask, const ParameterBox& box) {
  Reduced result{mask, {}, {}};
  std::vector<Function> values;
  for (std::size_t k = 0; k < box.lower.size(); ++k) {
    const int variable = static_cast<int>(k);
    const bool used = std::ranges::any_of(mask.symbol.coefficients(), [&](const Function& f) {
      return f.numerator().uses(variable) || f.denominator().uses(variable);
    });
    if (box.lower[k] == box.upper[k] || !used) {
      values.emplace_back(box.lower[k]);
      continue;
    }
    values.push_back(Function::variable(static_cast<int>(result.kept.size())));
    result.box.lower.push_back(box.lower[k]);
    result.box.upper.push_back(box.upper[k]);
    result.kept.push_back(k);
  }
  result.mask = map_coefficients(
      mask, [&](const Function& f) { return f.evaluate(std::span<const Function>(values)); });
  return result;
}

/// A cell of the parameters that matter as one of all.
void widen(CertificateCell& cell, const ParameterBox& box, const std::vector<std::size_t>& kept) {
  std::vector<RealInterval> sides;
  for (std::size_t k = 0; k < box.lower.size(); ++k)
    sides.push_back(closed_interval(box.lower[k], box.upper[k]));
  for (std::size_t i = 0; i < kept.size(); ++i) sides[kept[i]] = cell.sides[i];
  cell.sides = std::move(sides);
}

/// Cells of two and more parameters.
std::vector<CertificateCell> certify_box(const NormalForm<Function>& form, int continuity,
                                         const ParameterBox& box, const Deadline& deadline,
                                         const CertificateOptions& options) {
  constexpr int longest = 4;
  constexpr std::array depths{30, 10, 6};  // for 1, 2 and more parameters
  const std::size_t dimension = box.lower.size();
  const auto family = continuity_family(form, continuity);
  const Deadline for_conditions(deadline.left() / 4);
  CellOptions cell_options;
  cell_options.vertices = options.vertices;
  cell_options.longest_word = longest;
  const CellDecider decider(family, dimension, expanding_conditions(family, longest, for_conditions),
                            cell_options);
  const int depth = options.depth.value_or(depths.at(std::min(dimension, depths.size()) - 1));
  std::vector<CertificateCell> cells;
  for (const MapCell& found : refine_cells(decider, box, depth, deadline)) {
    CertificateCell cell = whole_cell(found.box, found.below, Ground::polytope);
    cell.vertices = found.vertices;
    cell.sequences = found.below == Decision::yes;
    if (found.below == Decision::no) {
      cell.ground = Ground::product;
      cell.words = {found.word};
    }
    cells.push_back(std::move(cell));
  }
  return cells;
}

void certify_without_sum_rule(const Reduced& question, const NormalForm<Function>& form, int continuity,
                              const Deadline& deadline, ContinuityCertificate& result) {
  const std::vector<Polynomial> equations = further_sum_rules(form, continuity + 1 - form.factors);
  if (question.box.lower.size() == 1) {
    const auto values = common_roots(equations, question.box.lower[0], question.box.upper[0]);
    result.cells = single_values(question.mask, continuity, values, question.box, deadline);
    return;
  }
  result.cells = {whole_cell(question.box, Decision::no, Ground::sum_rule)};
  if (!have_no_zero(equations, question.box)) result.exceptions = equations;
}

Rational undecided_volume(const std::vector<CertificateCell>& cells) {
  Rational sum(0);
  for (const CertificateCell& cell : cells) {
    if (cell.smooth != Decision::undecided) continue;
    Rational volume(1);
    for (const RealInterval& side : cell.sides) {
      if (side.is_point() && cell.sides.size() > 1) continue;  // a parameter that has one value
      volume *= side.upper->to_interval().upper() - side.lower->to_interval().lower();
    }
    sum += volume;
  }
  return sum;
}

}  // namespace

std::optional<Decision> ContinuityCertificate::status() const {
  const auto count = [&](Decision smooth) {
    return std::ranges::count(cells, smooth, &CertificateCell::smooth);
  };
  if (count(Decision::undecided) > 0 || !exceptions.empty()) return Decision::undecided;
  if (count(Decision::no) == 0) return Decision::yes;
  if (count(Decision::yes) == 0) return Decision::no;
  return std::nullopt;
}

void require_no_pole(const Mask<Function>& mask, const ParameterBox& box) {
  for (const Function& f : mask.symbol.coefficients()) {
    const Polynomial below = f.denominator();
    if (below.is_constant()) continue;
    if (const auto poles = common_roots({below}, box.lower[0], box.upper[0]); !poles.empty()) {
      throw std::domain_error("division by zero: a coefficient has a pole at " + poles[0].to_string());
    }
  }
}

ContinuityCertificate certify_continuity(const Mask<Function>& mask, int continuity, const ParameterBox& box,
                                         const CertificateOptions& options) {
  const Deadline deadline(options.seconds);
  const Reduced question = reduced(mask, box);
  const NormalForm<Function> form = normal_form(question.mask);
  if (form.factors < 1) throw std::domain_error("the first sum rule does not hold");
  ContinuityCertificate result;
  result.factors = form.factors;
  const std::size_t dimension = question.box.lower.size();
  // No polynomial of b's degree has so many smoothing factors.
  const bool impossible = (continuity + 1L - form.factors) * (form.arity - 1) > form.degree();
  if (dimension == 1) require_no_pole(question.mask, question.box);
  if (dimension == 0) {
    const Mask<Rational> constant =
        map_coefficients(question.mask, [](const Function& f) { return f.constant(); });
    const Decision smooth = reaches(smoothness(normal_form(constant), value_budget(deadline)), continuity);
    result.cells = {whole_cell({}, smooth, Ground::value)};
  } else if (impossible) {
    result.cells = {whole_cell(question.box, Decision::no, Ground::sum_rule)};
  } else if (continuity >= form.factors) {
    certify_without_sum_rule(question, form, continuity, deadline, result);
  } else if (dimension == 1) {
    result.cells =
        certify_line(form, continuity, question.box.lower[0], question.box.upper[0], deadline, options);
  } else {
    result.cells = certify_box(form, continuity, question.box, deadline, options);
  }
  if (dimension == 1) {
    result.dependent =
        dependent_values(question.mask, form, continuity, question.box, result.cells, deadline);
  }
  for (CertificateCell& cell : result.cells) widen(cell, box, question.kept);
  result.undecided = undecided_volume(result.cells);
  return result;
}

}  // namespace subdiv
