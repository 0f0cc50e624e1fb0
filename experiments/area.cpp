#include "experiments/area.h"

#include <fmt/format.h>

#include "experiments/area_schemes.h"
#include "experiments/report/figure_style.h"
#include "optimize/problem.h"

namespace subdiv {
namespace {

using Function = RationalFunction;

const Rational three_halves(3, 2);
constexpr int digits = 15;

const ClaimHead& head_of(const std::string& id) { return head(area_heads(), id); }

std::string short_decimal(const Rational& x) { return to_significant(x, 6); }

Summary least_residual(const Scheme<Function>& scheme, std::vector<Range> box) {
  return minimise({area_residuals(scheme), Norm::linf, std::move(box), {}});
}

Scheme<Function> mixed_rs(const Function& r, const Function& s) { return anticipated_jspline(r, r, s); }

Rational residual_s(const Rational& s) { return largest_area_residual(repeated_jspline(s)); }
Rational residual_rs(const Rational& r, const Rational& s) {
  return largest_area_residual(anticipated_jspline(r, r, s));
}

void add_masks(Results& results) {
  const Laurent<Function> mask = area_mask(repeated_jspline(Function::variable(0)));
  const std::vector<std::string> names{"s"};
  std::string text;
  for (int k = 1; k <= mask.last(); ++k) {
    text += fmt::format("{}m_{} = {}", k > 1 ? "; " : "", k, mask[k].to_factored_string(names));
  }
  results.claims.push_back(
      settle_statement(head_of("area.mask"), mask.last() == 5 && mask.first() == -5, text));
}

void add_one_parameter(Results& results) {
  const Function x = Function::variable(0);
  const Summary s = least_residual(repeated_jspline(x), {{Rational(-17, 10), Rational(58, 10)}});
  results.claims.push_back(settle(head_of("area.s.js-report"), s.minimiser[0]));
  results.claims.push_back(
      settle(head_of("area.s.jsplines"), s.minimiser[0],
             fmt::format("Rounded too far to be used as it stands: at s = 0.46 the largest difference of the "
                         "masks is {}, at the "
                         "optimum {}.",
                         short_decimal(residual_s(Rational(46, 100))), short_decimal(s.minimum.midpoint()))));
  results.claims.push_back(settle(head_of("area.s.minimum"), s.minimum));
  const Summary r = least_residual(mixed_rs(x, Function(three_halves)), {{Rational(-6), Rational(6)}});
  for (const char* id : {"area.r.js-report", "area.r.jsplines", "area.r.jsplines.figure"}) {
    results.claims.push_back(settle(head_of(id), r.minimiser[0]));
  }
  results.claims.push_back(settle(head_of("area.r.minimum"), r.minimum));

  // The whole range, closer points about the sharp optimum, and the optimum itself.
  std::vector<Rational> abscissae{Rational::parse(to_decimal(s.minimiser[0].midpoint(), digits))};
  for (int i = 0; i <= 150; ++i) abscissae.emplace_back(i - 34, 20);
  for (int i = 0; i <= 40; ++i) abscissae.push_back(Rational(81 + i, 200) + Rational(1, 1000));
  std::ranges::sort(abscissae);
  Series curve{"area-objective-s", {"s", "largest difference"}, {}};
  for (const Rational& at : abscissae) {
    curve.rows.push_back({to_significant(at, digits), to_significant(residual_s(at), digits)});
  }
  results.series.push_back(std::move(curve));
  results.series.push_back(
      {"area-optimum-s",
       {"s", "largest difference"},
       {{to_significant(s.minimiser[0].midpoint(), digits), to_significant(s.minimum.midpoint(), digits)}}});
  results.figures.push_back({"area-objective-s",
                             "How far the area mask m of *J_s is from the polygon's, l",
                             "parameter s",
                             "largest |m_k - l_k|",
                             {{"area-objective-s", "s", "largest difference", "*J_s"},
                              {"area-optimum-s", "s", "largest difference", "optimum", style::points(1)}},
                             style::log_y,
                             {"area.s.js-report", "area.s.jsplines", "area.s.minimum"}});
}

/// Over r for fixed s: the floor of the valley in which the optimum of {J_r, *J_s} lies.
Series valley() {
  Series series{"area-rs-valley", {"s", "r", "largest difference"}, {}};
  constexpr int steps = 40;
  for (int i = 0; i <= steps; ++i) {
    const Rational s = Rational(-3, 2) + Rational(3 * i, steps);
    const Summary best =
        least_residual(mixed_rs(Function::variable(0), Function(s)), {{-three_halves, three_halves}});
    series.rows.push_back({to_significant(s, digits), to_significant(best.minimiser[0].midpoint(), digits),
                           to_significant(best.minimum.midpoint(), digits)});
  }
  return series;
}

void add_two_parameters(Results& results) {
  const Summary best = least_residual(mixed_rs(Function::variable(0), Function::variable(1)),
                                      {{-three_halves, three_halves}, {-three_halves, three_halves}});
  struct Printed {
    std::string document;
    Rational r;
    Rational s;
  };
  const Printed printed[] = {{"js-report", Rational::parse("0.836"), Rational::parse("-0.531")},
                             {"jsplines", Rational::parse("0.84"), Rational::parse("-0.53")}};
  Series points{"area-rs-points", {"s", "r", "largest difference"}, {}};
  const bool found = best.termination == Termination::proved;
  if (found) {
    points.rows.push_back({to_significant(best.minimiser[1].midpoint(), digits),
                           to_significant(best.minimiser[0].midpoint(), digits),
                           to_significant(best.minimum.midpoint(), digits)});
  }
  for (const Printed& p : printed) {
    const Rational there = residual_rs(p.r, p.s);
    const std::string note =
        found
            ? fmt::format(
                  "The printed pair is not the minimiser: at ({}, {}) the largest difference of the masks is "
                  "{}, {} times the "
                  "minimum {} at (r, s) = ({}, {}).",
                  to_decimal(p.r, 3), to_decimal(p.s, 3), short_decimal(there),
                  to_significant(there / best.minimum.midpoint(), 3), short_decimal(best.minimum.midpoint()),
                  short_decimal(best.minimiser[0].midpoint()), short_decimal(best.minimiser[1].midpoint()))
            : "";
    results.claims.push_back(settle(head_of("area.rs.r." + p.document), best.minimiser[0], note));
    results.claims.push_back(settle(head_of("area.rs.s." + p.document), best.minimiser[1], note));
    results.claims.push_back(settle(head_of("area.rs.residual." + p.document), exact(there)));
    points.rows.push_back(
        {to_significant(p.s, digits), to_significant(p.r, digits), to_significant(there, digits)});
  }
  results.claims.push_back(
      settle(head_of("area.rs.minimum"), best.minimum,
             fmt::format("Attained at r = {}, s = {} alone; two entries of the mask, m_1 and m_2, attain it.",
                         to_significant(best.minimiser[0].midpoint(), digits),
                         to_significant(best.minimiser[1].midpoint(), digits))));
  results.series.push_back(valley());
  results.series.push_back(std::move(points));
  results.figures.push_back(
      {"area-rs-valley",
       "How far the area mask m of {J_r, *J_s}, r the best, is from the polygon's, l",
       "parameter s",
       "largest |m_k - l_k|",
       {{"area-rs-valley", "s", "largest difference", "{J_r, *J_s}, best r"},
        {"area-rs-points", "s", "largest difference", "optimum, and printed pairs (r, s)", style::points(1)}},
       style::log_y,
       {"area.rs."}});
}

/// The masks of the recommended schemes beside the polygon's.
void add_mask_figure(Results& results) {
  const auto parse = [](const char* text) { return Rational::parse(text); };
  const Rational r = parse("-0.0299");
  const Rational r2 = parse("0.836");
  const std::vector<std::pair<std::string, Laurent<Rational>>> masks{
      {"polygon", polygon_area_mask<Rational>()},
      {"*J_0", area_mask(repeated_jspline(Rational(0)))},
      {"*J_1", area_mask(repeated_jspline(Rational(1)))},
      {"*J_0.46415", area_mask(repeated_jspline(parse("0.46415")))},
      {"{J_-0.0299, *J_1.5}", area_mask(anticipated_jspline(r, r, three_halves))},
      {"{J_0.836, *J_-0.531}", area_mask(anticipated_jspline(r2, r2, parse("-0.531")))},
  };
  // The others differ from the polygon's by so much that they would hide these.
  const auto is_recommended = [](const std::string& name) {
    return name != "polygon" && name != "*J_0" && name != "*J_1";
  };
  Series series{"area-masks", {"k"}, {}};
  Series differences{"area-mask-differences", {"k"}, {}};
  Figure figure{"area-masks", "Area masks of schemes and of the polygon", "entry k",    "weight m_k",
                {},           "set xrange [-5.5:5.5]; set xtics 1",       {"area.mask"}};
  Figure difference_figure{"area-mask-differences",
                           "Area masks of recommended schemes minus the polygon's",
                           "entry k",
                           "m_k - l_k",
                           {},
                           "set xrange [-5.5:5.5]; set xtics 1",
                           {"area.s.minimum", "area.r.minimum", "area.rs.minimum", "area.rs.residual."}};
  for (const auto& [name, mask] : masks) {
    series.columns.push_back(name);
    figure.curves.push_back({"area-masks", "k", name, name, style::marked(figure.curves.size())});
    if (!is_recommended(name)) continue;
    differences.columns.push_back(name);
    difference_figure.curves.push_back(
        {"area-mask-differences", "k", name, name, style::marked(difference_figure.curves.size())});
  }
  for (int k = -5; k <= 5; ++k) {
    std::vector<std::string> row{std::to_string(k)};
    std::vector<std::string> difference_row{std::to_string(k)};
    for (const auto& [name, mask] : masks) {
      row.push_back(to_significant(mask[k], digits));
      if (is_recommended(name))
        difference_row.push_back(to_significant(mask[k] - masks[0].second[k], digits));
    }
    series.rows.push_back(std::move(row));
    differences.rows.push_back(std::move(difference_row));
  }
  results.series.push_back(std::move(series));
  results.series.push_back(std::move(differences));
  results.figures.push_back(std::move(figure));
  results.figures.push_back(std::move(difference_figure));
}

void append(Results& results, Results part) {
  std::ranges::move(part.claims, std::back_inserter(results.claims));
  std::ranges::move(part.series, std::back_inserter(results.series));
  std::ranges::move(part.figures, std::back_inserter(results.figures));
}

}  // namespace

Results run_area() {
  Results results;
  add_masks(results);
  add_one_parameter(results);
  add_two_parameters(results);
  add_mask_figure(results);
  append(results, run_area_exact());
  append(results, run_area_model());
  return results;
}

}  // namespace subdiv
