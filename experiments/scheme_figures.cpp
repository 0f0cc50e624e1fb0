#include "experiments/scheme_figures.h"

#include <algorithm>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "analysis/basis_function.h"
#include "analysis/continuity_certificate.h"
#include "analysis/hoelder.h"
#include "analysis/reproduction.h"
#include "analysis/sum_rules.h"
#include "experiments/cli/over.h"
#include "experiments/report/figure_style.h"
#include "schemes/input_error.h"
#include "schemes/instantiate.h"
#include "schemes/text.h"

namespace subdiv {
namespace {

constexpr int cell_digits = 15;

std::string cell(const Rational& x) { return to_significant(x, cell_digits); }
std::string cell(const Algebraic& x) { return cell(x.to_interval().midpoint()); }

template <class R>
void require_affine_invariance(const Scheme<R>& scheme) {
  for (const Mask<R>& step : scheme.steps) {
    if (const auto violation = violated_affine_invariance(step))
      throw InputError(scheme.name + ": the step violates the first sum rule: " + *violation);
  }
}

/// The largest level whose points on the support are at most `most`.
template <class R>
int fine_level(const Scheme<R>& scheme, int most) {
  const auto [low, high] = basis_support(scheme);
  int level = 0;
  for (Rational points = (high - low) * Rational(scheme.arity()); points <= Rational(most);
       points *= Rational(scheme.arity()))
    ++level;
  return level;
}

/// Columns t, phi, phi', ..
template <class R>
Results basis_figure(const std::string& name, const Scheme<R>& scheme, const std::string& text) {
  constexpr int most_points = std::is_same_v<R, Rational> ? 1000 : 200;
  constexpr int most_derivatives = 2;
  require_affine_invariance(scheme);
  const SmoothnessReport<R> report = smoothness_report(normal_form(scheme.last()));
  if (report.limits.continuity < 0)
    throw InputError(text + ": no continuous basis function is proved; 'subdivlab analyze' says more");
  const int derivatives = std::min(report.limits.continuity, most_derivatives);
  const int level = fine_level(scheme, most_points);
  std::vector<Laurent<R>> values;
  for (int d = 0; d <= derivatives; ++d) values.push_back(basis_values(scheme, level, d));

  Results results;
  const Rational spacing = pow(Rational(scheme.arity()), -level);
  Series series{name, {"t"}, {}};
  Figure figure{.name = name,
                .title = "Basis function of " + text + ", C" + std::to_string(report.limits.continuity),
                .x_label = "parameter t (control points a unit apart)",
                .y_label = "value",
                .curves = {},
                .setup = ""};
  const char* labels[] = {"basis function", "first derivative", "second derivative"};
  for (int d = 0; d <= derivatives; ++d) {
    series.columns.push_back("derivative-" + std::to_string(d));
    figure.curves.push_back({name, "t", series.columns.back(), labels[d]});
  }
  const auto [low, high] = basis_support(scheme);
  const long first = (-floor(-low / spacing)).to_integer();
  const long last = floor(high / spacing).to_integer();
  for (long i = first; i <= last; ++i) {
    std::vector<std::string> row{cell(Rational(i) * spacing)};
    for (const Laurent<R>& v : values) row.push_back(cell(v[static_cast<int>(i)]));
    series.rows.push_back(std::move(row));
  }
  results.series.push_back(std::move(series));
  results.figures.push_back(std::move(figure));
  return results;
}

/// The exponent at one value of the parameter; nothing where the scheme does not converge or exist.
std::optional<Enclosure> exponent_at(const Mask<RationalFunction>& mask, const Rational& value) {
  JointSpectralRadiusBudget budget;
  budget.seconds = 1;
  try {
    const std::vector<Rational> point{value};
    const Mask<Rational> fixed =
        map_coefficients(mask, [&](const RationalFunction& f) { return f.evaluate<Rational>(point); });
    const Smoothness limits = smoothness_report(normal_form(fixed), budget).limits;
    if (limits.converges == Decision::no) return std::nullopt;
    return limits.exponent;
  } catch (const std::domain_error&) {
    return std::nullopt;
  }
}

Series exponents(const std::string& name, const Mask<RationalFunction>& mask,
                 const cli::ParameterRange& range) {
  constexpr int steps = 120;
  Series series{name, {range.name, "lower", "upper"}, {}};
  for (int i = 0; i <= steps; ++i) {
    const Rational value = range.lower + (range.upper - range.lower) * Rational(i, steps);
    const auto exponent = exponent_at(mask, value);
    std::vector<std::string> row{cell(value), "", ""};
    if (exponent) row = {cell(value), cell(exponent->lower), cell(exponent->upper)};
    series.rows.push_back(std::move(row));
  }
  return series;
}

/// An end as it is in a legend: exact where that is short.
std::string end_text(const Algebraic& end) {
  constexpr std::size_t longest = 12;
  constexpr int digits = 5;
  const std::string text = end.to_string();
  return text.size() <= longest ? text : to_significant(end.to_interval().midpoint(), digits);
}

struct CertifiedRange {
  std::string label;
  std::vector<std::vector<std::string>> rows;  // ends of pieces at the height of the order, gaps between
};

std::optional<CertifiedRange> certified_range(const Mask<RationalFunction>& mask, int order,
                                              const cli::ParameterRange& range) {
  CertificateOptions options;
  options.seconds = 5;
  const ContinuityCertificate certificate =
      certify_continuity(mask, order, {{range.lower}, {range.upper}}, options);
  CertifiedRange result;
  std::string text;
  std::string last_upper;
  for (const CertificateCell& piece : certificate.cells) {
    if (piece.smooth != Decision::yes) continue;
    const RealInterval& side = piece.sides.front();
    const std::string height = std::to_string(order);
    const std::string lower = end_text(*side.lower);
    if (!last_upper.empty() && last_upper == lower) {
      text.erase(text.rfind(", "));
      text += ", " + end_text(*side.upper);
    } else {
      text += (text.empty() ? "" : "; ") + lower + ", " + end_text(*side.upper);
    }
    last_upper = end_text(*side.upper);
    result.rows.push_back({cell(*side.lower), height});
    result.rows.push_back({cell(*side.upper), height});
    result.rows.push_back({"", ""});
  }
  if (result.rows.empty()) return std::nullopt;
  result.label = fmt::format("C^{} certified: {}", order, text);
  return result;
}

Results exponent_figure(const std::string& name, const Scheme<RationalFunction>& scheme,
                        const cli::ParameterRange& range, const std::string& text) {
  constexpr double bar = 5;
  require_affine_invariance(scheme);
  Results results;
  results.series.push_back(exponents(name, scheme.last(), range));
  const bool any =
      std::ranges::any_of(results.series[0].rows, [](const auto& row) { return !row[1].empty(); });
  if (!any) {
    throw InputError(text + ": the scheme converges for no value of " + range.name +
                     " that is looked at; choose another range");
  }
  Figure figure{.name = name,
                .title = "Smoothness of " + text,
                .x_label = range.name,
                .y_label = "Hoelder exponent of the limits",
                .curves = {{name, range.name, "upper", "exponent, at most"},
                           {name, range.name, "lower", "exponent, at least"}},
                .setup = ""};
  constexpr int most_orders = 8;
  for (int order = 0; order <= most_orders; ++order) {
    auto certified = certified_range(scheme.last(), order, range);
    if (!certified) break;
    const std::string series = fmt::format("{}-c{}", name, order);
    results.series.push_back({series, {range.name, "order"}, std::move(certified->rows)});
    figure.curves.push_back({series, range.name, "order", std::move(certified->label),
                             style::curve(static_cast<std::size_t>(order) + 2, bar)});
  }
  figure.setup = fmt::format("set xrange [{}:{}]", cell(range.lower), cell(range.upper));
  results.figures.push_back(std::move(figure));
  return results;
}

}  // namespace

Results scheme_figure(const std::string& name, const std::string& scheme, const std::string& over) {
  const SchemeDescription description = parse_scheme(scheme);
  try {
    if (!over.empty()) {
      const auto ranges = cli::parse_over(over, description.free_parameters, cli::RangeEnds::differ);
      if (ranges.size() != 1) {
        throw InputError(scheme + ": the exponent is drawn over one parameter, and " +
                         joined(description.free_parameters, "and") + " are free");
      }
      const Scheme<RationalFunction> symbolic = symbolic_scheme(description);
      for (const Mask<RationalFunction>& step : symbolic.steps)
        require_no_pole(step, {{ranges[0].lower}, {ranges[0].upper}});
      return exponent_figure(name, symbolic, ranges[0], scheme);
    }
    if (!description.free_parameters.empty()) {
      throw InputError(scheme + ": " + joined(description.free_parameters, "and") + " is free; --over " +
                       description.free_parameters[0] +
                       "=LO..HI draws the smoothness over it, a value the basis function");
    }
    return std::visit(
        [&](const auto& exact) -> Results {
          if constexpr (std::is_same_v<std::decay_t<decltype(exact)>, Scheme<RationalFunction>>) {
            throw std::logic_error("a scheme without free parameters has numbers as coefficients");
          } else {
            return basis_figure(name, exact, scheme);
          }
        },
        exact_scheme(description));
  } catch (const std::domain_error& error) {
    throw InputError(scheme + ": " + error.what());
  }
}

}  // namespace subdiv
