#include <stdexcept>
#include <type_traits>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "analysis/area_mask.h"
#include "analysis/eigenvalues.h"
#include "analysis/hoelder.h"
#include "analysis/iterate_norm.h"
#include "analysis/limit_mask.h"
#include "analysis/reif.h"
#include "analysis/reproduction.h"
#include "analysis/sobolev.h"
#include "analysis/sum_rules.h"
#include "experiments/definition_parts.h"
#include "schemes/input_error.h"
#include "schemes/instantiate.h"
#include "schemes/text.h"

namespace subdiv {
namespace {

using Kind = DefinitionArgument::Kind;

/// Calls f with the scheme over the smallest exact ring. Steps must be affinely invariant.
template <class F>
Answer over_exact_ring(const SchemeDescription& description, F f) {
  return std::visit(
      [&](const auto& scheme) {
        for (const auto& step : scheme.steps) {
          if (const auto violation = violated_affine_invariance(step))
            throw InputError(description.text + ": the step violates the first sum rule: " + *violation);
        }
        try {
          return f(scheme);
        } catch (const std::domain_error& error) {
          throw InputError(description.text + ": " + error.what());
        }
      },
      exact_scheme(description));
}

/// The same for schemes without free parameters: over rationals or real algebraic numbers.
template <class F>
Answer over_numbers(const DefinitionCall& call, F f) {
  return over_exact_ring(fixed_scheme_of(call), [&](const auto& scheme) -> Answer {
    if constexpr (std::is_same_v<std::decay_t<decltype(scheme)>, Scheme<RationalFunction>>) {
      throw std::logic_error("a scheme without free parameters has numbers as coefficients");
    } else {
      return f(scheme);
    }
  });
}

void check_fixed(const DefinitionCall& call) { (void)fixed_scheme_of(call); }

JointSpectralRadiusBudget budget_of(const DefinitionCall& call) {
  JointSpectralRadiusBudget budget;
  budget.seconds = std::stod(call.text("budget"));
  return budget;
}

Answer whole_answer(int value, std::string method) {
  return number_answer(exact(Rational(value), std::move(method)));
}

/// The smoothness of the limits, or of the scheme in the sense of its differences.
Smoothness smoothness_of(const DefinitionCall& call) {
  Smoothness result;
  (void)over_numbers(call, [&](const auto& scheme) {
    const auto report = smoothness_report(normal_form(scheme.last()), budget_of(call));
    result = call.text("of") == "scheme" ? report.scheme : report.limits;
    return Answer{};
  });
  return result;
}

Answer continuity(const DefinitionCall& call) {
  const Smoothness smoothness = smoothness_of(call);
  const Rational low(smoothness.continuity);
  const Rational high(smoothness.continuity_limit);
  if (low == high) return number_answer(exact(low, "joint spectral radius"));
  Enclosure value = certified(low, high, "joint spectral radius");
  value.status = smoothness.exponent.status;
  return number_answer(std::move(value));
}

Answer hoelder(const DefinitionCall& call) {
  const Smoothness smoothness = smoothness_of(call);
  if (smoothness.converges == Decision::no)
    throw InputError("the scheme diverges: it has no Hoelder exponent");
  return number_answer(smoothness.exponent);
}

Answer joint_radius(const DefinitionCall& call) { return number_answer(smoothness_of(call).radius.value); }

Answer l2_exponent(const DefinitionCall& call) {
  return over_numbers(call, [&](const auto& scheme) {
    const auto form = normal_form(scheme.last());
    if constexpr (std::is_same_v<std::decay_t<decltype(scheme)>, Scheme<Rational>>) {
      return number_answer(sobolev_exponent(form, budget_of(call)));
    } else {
      return number_answer(sobolev_exponent(enclose(form), budget_of(call)));
    }
  });
}

Answer count_sum_rules(const DefinitionCall& call) {
  return over_exact_ring(scheme_of(call), [](const auto& scheme) {
    return whole_answer(sum_rule_order(scheme), "exact sum rules");
  });
}

Answer generation(const DefinitionCall& call) {
  return over_exact_ring(scheme_of(call), [](const auto& scheme) {
    return whole_answer(generation_degree(scheme), "exact sum rules");
  });
}

Answer reproduction(const DefinitionCall& call) {
  return over_exact_ring(scheme_of(call), [](const auto& scheme) {
    return whole_answer(reproduction_degree(scheme), "exact moments");
  });
}

Answer necessary_continuity(const DefinitionCall& call) {
  return over_numbers(
      call, [](const auto& scheme) { return whole_answer(reif_order(scheme.last()), "Reif 1996"); });
}

Answer support(const DefinitionCall& call) {
  return over_exact_ring(scheme_of(call), [&](const auto& scheme) {
    const auto [low, high] = basis_support(scheme);
    return set_answer(call, {{RealInterval{Algebraic(low), Algebraic(high), true, true}}});
  });
}

RationalFunction printed_coefficient(const Expression& expression, const std::vector<std::string>& names) {
  return evaluate<RationalFunction>(expression, [&](const std::string& name, const Expression::Node& node) {
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (names[i] == name) return RationalFunction::variable(static_cast<int>(i));
    }
    throw InputError(expression.locate(node, "unknown name " + in_quotes(name)));
  });
}

std::string coefficient_text(const RationalFunction& f, const std::vector<std::string>& names) {
  return f.to_factored_string(names);
}
template <class R>
std::string coefficient_text(const R& x, const std::vector<std::string>& /*names*/) {
  return x.to_string();
}

bool is_coefficient(const RationalFunction& f, const Expression& printed,
                    const std::vector<std::string>& names) {
  return f == printed_coefficient(printed, names);
}
template <class R>
bool is_coefficient(const R& x, const Expression& printed, const std::vector<std::string>& /*names*/) {
  return Algebraic(x) == evaluate_constant<Algebraic>(printed);
}

/// A mask's coefficients from the first to the last, or the one of an index.
template <class R>
Answer mask_answer(const DefinitionCall& call, const Laurent<R>& mask,
                   const std::vector<std::string>& names) {
  std::vector<R> list = mask.coefficients();
  if (call.has("index")) {
    const R one = mask[static_cast<int>(call.whole("index"))];
    if constexpr (!std::is_same_v<R, RationalFunction>) return number_answer(exact(one));
    list = {one};
  }
  Answer answer;
  for (const R& c : list) answer.text += (answer.text.empty() ? "" : ", ") + coefficient_text(c, names);
  if (!call.has("index")) answer.note = fmt::format("Indices {} to {}.", mask.first(), mask.last());
  answer.is_printed = [list, names](std::string_view printed) {
    const std::vector<Expression> said = parse_list(printed);
    bool same = said.size() == list.size();
    for (std::size_t i = 0; same && i < list.size(); ++i) same = is_coefficient(list[i], said[i], names);
    return same;
  };
  return answer;
}

AnswerKind mask_kind(const DefinitionCall& call) {
  return call.has("index") && scheme_of(call).free_parameters.empty() ? AnswerKind::number : AnswerKind::text;
}

template <class Question>
Answer mask_question(const DefinitionCall& call, Question question) {
  const SchemeDescription description = scheme_of(call);
  return over_exact_ring(description, [&](const auto& scheme) {
    return mask_answer(call, question(scheme), description.free_parameters);
  });
}

Answer mask(const DefinitionCall& call) {
  return mask_question(call, [](const auto& scheme) { return scheme.last().symbol; });
}
Answer limits(const DefinitionCall& call) {
  return mask_question(call, [](const auto& scheme) { return vertex_limit_mask(scheme); });
}
Answer tangents(const DefinitionCall& call) {
  return mask_question(call, [](const auto& scheme) { return vertex_tangent_mask(scheme); });
}
Answer areas(const DefinitionCall& call) {
  return mask_question(call, [](const auto& scheme) { return area_mask(scheme); });
}

Answer eigenvalue(const DefinitionCall& call) {
  return over_numbers(call, [&](const auto& scheme) {
    long left = call.whole("index");
    for (const Eigenvalue& value : eigenvalues(subdivision_matrix(scheme.last()))) {
      left -= value.multiplicity;
      if (left >= 0) continue;
      if (!value.is_real()) throw InputError("this eigenvalue is not real: " + value.to_string());
      if (value.exact) return number_answer(exact(*value.exact));
      return number_answer(certified(value.real, "roots of the characteristic polynomial"));
    }
    throw InputError(fmt::format("the subdivision matrix has no eigenvalue {}; its size is {}",
                                 call.text("index"), call.whole("index") - left));
  });
}

Answer difference_norm(const DefinitionCall& call) {
  return over_numbers(call, [&](const auto& scheme) {
    const auto difference = difference_symbol(scheme.last(), static_cast<int>(call.whole("continuity")));
    if (!difference) throw InputError("the scheme has too few sum rules for this difference scheme");
    const int power = static_cast<int>(call.whole("power"));
    constexpr int most_exact = 256;
    if constexpr (std::is_same_v<std::decay_t<decltype(scheme)>, Scheme<Rational>>) {
      if (pow(Rational(scheme.arity()), power) > Rational(most_exact))
        return number_answer(iterate_norm_enclosure(*difference, scheme.arity(), power));
    }
    return number_answer(exact(iterate_norms(*difference, scheme.arity(), power).back()));
  });
}

/// "C2", "C^2" or "2" as "2".
std::string without_c(const std::string& printed) {
  if (printed.starts_with("C^")) return printed.substr(2);
  return printed.starts_with('C') ? printed.substr(1) : printed;
}

DefinitionArgument whole_argument(std::string name, std::string meaning, long least, long greatest,
                                  bool required) {
  return {.name = std::move(name),
          .kind = Kind::whole,
          .meaning = std::move(meaning),
          .required = required,
          .least = least,
          .greatest = greatest};
}

DefinitionArgument whose_argument() {
  return {.name = "of",
          .kind = Kind::word,
          .meaning = "of the limits, or of the scheme in the sense of its differences",
          .required = false,
          .default_value = "limits",
          .words = {"limits", "scheme"}};
}

Definition number(std::string name, std::string summary, std::vector<DefinitionArgument> more,
                  void (*check)(const DefinitionCall&), Answer (*answer)(const DefinitionCall&),
                  std::string example) {
  std::vector<DefinitionArgument> arguments{scheme_argument()};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return {std::move(name), std::move(summary), std::move(arguments), always_number, check, nullptr, nullptr,
          answer,          std::move(example)};
}

Definition mask_definition(std::string name, std::string summary, Answer (*answer)(const DefinitionCall&)) {
  constexpr long farthest = 10000;
  Definition result =
      number(name, std::move(summary),
             {whole_argument("index", "one coefficient instead of all", -farthest, farthest, false)},
             nothing_to_check, answer, fmt::format(R"({{"name": "{}", "scheme": "four-point:w=w"}})", name));
  result.kind = mask_kind;
  result.check_printed = check_list;
  return result;
}

}  // namespace

std::vector<Definition> scheme_definitions() {
  constexpr long most_power = 20;
  constexpr long most_continuity = 100;
  constexpr long most_index = 1000;
  std::vector<Definition> list;
  list.push_back(number("continuity", "The largest k such that the limits are C^k, -1 for none",
                        {whose_argument(), seconds_argument("30")}, check_fixed, continuity,
                        R"({"name": "continuity", "scheme": "jspline:s=3/2"})"));
  list.back().read_printed = without_c;
  list.push_back(number("hoelder", "The Hoelder exponent, from the joint spectral radius",
                        {whose_argument(), seconds_argument("30")}, check_fixed, hoelder,
                        R"({"name": "hoelder", "scheme": "jspline:s=1/2"})"));
  list.push_back(
      number("joint-spectral-radius",
             "The joint spectral radius of the transition matrices of what the smoothing factors leave of "
             "the symbol, normalised to value 1 at z = 1",
             {whose_argument(), seconds_argument("30")}, check_fixed, joint_radius,
             R"({"name": "joint-spectral-radius", "scheme": "four-point"})"));
  list.push_back(number("l2-exponent", "The L2 (Sobolev) exponent of the scheme", {seconds_argument("30")},
                        check_fixed, l2_exponent, R"({"name": "l2-exponent", "scheme": "four-point"})"));
  list.push_back(number("necessary-continuity",
                        "The largest k such that the eigenvalues of the subdivision matrix allow C^k (Reif)",
                        {}, check_fixed, necessary_continuity,
                        R"({"name": "necessary-continuity", "scheme": "four-point"})"));
  list.push_back(
      number("difference-norm",
             "The norm of a power of the scheme that refines the differences of the M-th divided "
             "differences; below 1 it proves C^M",
             {continuity_argument(), whole_argument("power", "of the scheme", 1, most_power, true)},
             check_fixed, difference_norm,
             R"({"name": "difference-norm", "scheme": "four-point", "continuity": 1, "power": 2})"));
  list.back().arguments[1].greatest = most_continuity;
  list.push_back(number("sum-rules",
                        "The number of sum rules that every step satisfies, for all values of free "
                        "parameters",
                        {}, nothing_to_check, count_sum_rules,
                        R"({"name": "sum-rules", "scheme": "four-point:w=w"})"));
  list.push_back(number(
      "generation-degree", "The largest degree of the polynomials that shifts of the basis function span", {},
      nothing_to_check, generation, R"({"name": "generation-degree", "scheme": "four-point"})"));
  list.push_back(number("reproduction-degree",
                        "The largest degree up to which limits of polynomial data are these "
                        "polynomials",
                        {}, nothing_to_check, reproduction,
                        R"({"name": "reproduction-degree", "scheme": "four-point"})"));
  list.push_back(
      number("eigenvalue",
             "An eigenvalue of the subdivision matrix at a vertex; index 0 has the largest modulus, each "
             "counts as often as its multiplicity",
             {whole_argument("index", "which one", 0, most_index, true)}, check_fixed, eigenvalue,
             R"({"name": "eigenvalue", "scheme": "jspline:s=1", "index": 2})"));
  list.push_back(number("support", "The support of the basis function", {end_argument()}, nothing_to_check,
                        support, R"({"name": "support", "scheme": "four-point", "end": "upper"})"));
  list.back().kind = set_kind;
  list.back().check_printed = check_set;
  list.push_back(mask_definition("mask", "The coefficients of the repeating step", mask));
  list.push_back(
      mask_definition("limit-mask", "The weights of control points in the limit of an old vertex", limits));
  list.push_back(mask_definition("tangent-mask",
                                 "The weights of control points in the tangent at the limit of an old "
                                 "vertex, control points a unit of the parameter apart",
                                 tangents));
  list.push_back(mask_definition("area-mask",
                                 "The coefficients of the limit's area as a quadratic form of the control "
                                 "polygon",
                                 areas));
  return list;
}

}  // namespace subdiv
