#include <algorithm>

#include <fmt/format.h>

#include "analysis/real_set.h"
#include "experiments/area_schemes.h"
#include "experiments/polygon_curves.h"
#include "experiments/report/figure_style.h"
#include "experiments/simple_polygons.h"

namespace subdiv {
namespace {

const ClaimHead& head_of(const std::string& id) { return head(polygon_curve_heads(), id); }
Rational number(const char* text) { return Rational::parse(text); }

/// E = area of the limit curve / area of the polygon - 1, over any field that holds the mask.
template <class R>
R area_error(const Laurent<R>& mask, const PlanePolygon& polygon) {
  R total(0);
  const Rational unit = cross_sum(std::span<const std::pair<Rational, Rational>>(polygon), 1);
  for (int k = mask.first(); k <= mask.last(); ++k) {
    const Rational a = cross_sum(std::span<const std::pair<Rational, Rational>>(polygon), k);
    total = total + mask[k] * from_rational<R>(a / unit);
  }
  return total - R(1);
}

/// |E| of every polygon of the family.
std::vector<Rational> error_sizes(const Scheme<Rational>& scheme) {
  const Laurent<Rational> mask = area_mask(scheme);
  std::vector<Rational> result;
  for (const PlanePolygon& polygon : simple_polygons()) result.push_back(abs(area_error(mask, polygon)));
  return result;
}

int below(const std::vector<Rational>& values, const Rational& bound) {
  return static_cast<int>(std::ranges::count_if(values, [&](const Rational& x) { return x < bound; }));
}

/// On how many polygons the first of several schemes has the smallest |E|.
int best(const std::vector<std::vector<Rational>>& schemes) {
  int count = 0;
  for (std::size_t i = 0; i < schemes.front().size(); ++i) {
    count += std::all_of(schemes.begin() + 1, schemes.end(),
                         [&](const std::vector<Rational>& other) { return schemes.front()[i] < other[i]; })
                 ? 1
                 : 0;
  }
  return count;
}

std::string per_cent(const Rational& x) { return to_significant(x * Rational(100), 3) + " %"; }

Rational median(std::vector<Rational> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

/// The distribution of |E| for several schemes: the share of polygons below it.
void add_figure(Results& results, std::vector<std::pair<std::string, std::vector<Rational>>> schemes) {
  constexpr int digits = 12;
  Series series{"area-usually", {"share"}, {}};
  Figure figure{"area-usually",
                "Area errors on simple polygons",
                "error of the area (fraction of the polygon's)",
                "share of polygons below",
                {},
                style::log_x + "set yrange [0:1]",
                {"family.area-usually.", "family.area-usually", "area.tendency."}};
  for (auto& [name, errors] : schemes) {
    std::ranges::sort(errors);
    series.columns.push_back(name);
    figure.curves.push_back({"area-usually", name, "share", name});
  }
  const std::size_t count = schemes.front().second.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Rational share(static_cast<std::int64_t>(i) + 1, static_cast<std::int64_t>(count));
    std::vector<std::string> row{to_significant(share, digits)};
    for (const auto& [name, errors] : schemes) row.push_back(to_significant(errors[i], digits));
    series.rows.push_back(std::move(row));
  }
  results.series.push_back(std::move(series));
  results.figures.push_back(std::move(figure));
}

/// The values of s that give the area of each polygon exactly.
void add_preserving_parameters(Results& results) {
  const Laurent<RationalFunction> mask = area_mask(repeated_jspline(RationalFunction::variable(0)));
  int smooth = 0;
  int continuous = 0;
  int unique = 0;
  for (const PlanePolygon& polygon : simple_polygons()) {
    std::vector<Algebraic> roots;
    append_real_roots(area_error(mask, polygon).numerator(), 0, roots);
    const auto within = [&](int lower, int upper) {
      return std::ranges::count_if(
          roots, [&](const Algebraic& x) { return Algebraic(lower) < x && x < Algebraic(upper); });
    };
    smooth += within(0, 4) > 0 ? 1 : 0;
    continuous += within(-2, 6) > 0 ? 1 : 0;
    unique += within(0, 4) == 1 ? 1 : 0;
  }
  const auto total = static_cast<int>(simple_polygons().size());
  results.claims.push_back(settle_share(
      head_of("area.tendency.c2"), smooth, total,
      fmt::format("On {} of them there is exactly one such s; on {} some s in (-2, 6), where *J_s is C1.",
                  unique, continuous)));
}

}  // namespace

Results run_polygon_areas() {
  Results results;
  const auto total = static_cast<int>(simple_polygons().size());
  const std::vector<Rational> four_point = error_sizes(repeated_jspline(Rational(0)));
  const std::vector<Rational> half = error_sizes(repeated_jspline(Rational(1, 2)));
  const std::vector<Rational> cubic = error_sizes(repeated_jspline(Rational(1)));
  const Rational nearly(1, 20);
  const Rational very_close(1, 50);
  const std::string medians =
      fmt::format("The medians of |E| are {} for *J_{{1/2}}, {} for *J_0 and {} for *J_1.",
                  per_cent(median(half)), per_cent(median(four_point)), per_cent(median(cubic)));
  results.claims.push_back(settle_share(
      head_of("family.area-usually"), below(half, nearly), total,
      fmt::format("*J_0: {}, *J_1: {}. {}", below(four_point, nearly), below(cubic, nearly), medians)));
  results.claims.push_back(settle_share(head_of("family.area-usually.abstract"), below(half, very_close),
                                        total,
                                        fmt::format("*J_0: {}, *J_1: {}. {}", below(four_point, very_close),
                                                    below(cubic, very_close), medians)));
  results.claims.push_back(
      settle_share(head_of("family.area-usually.against-ends"), best({half, four_point, cubic}), total));

  const std::vector<Rational> kinks =
      error_sizes(anticipated_jspline(number("0.836"), number("0.836"), number("-0.531")));
  const std::vector<Rational> smooth = error_sizes(repeated_jspline(number("0.46415")));
  const std::vector<Rational> smoother =
      error_sizes(anticipated_jspline(number("-0.0299"), number("-0.0299"), Rational(3, 2)));
  results.claims.push_back(settle_share(
      head_of("area.tendency.rs"), best({kinks, smooth, smoother}), total,
      fmt::format(
          "Smaller than that of *J_0.46415 alone on {}, of {{J_-0.0299, *J_{{3/2}}}} alone on {}. The "
          "medians of |E| are {}, {} and {}.",
          best({kinks, smooth}), best({kinks, smoother}), per_cent(median(kinks)), per_cent(median(smooth)),
          per_cent(median(smoother)))));
  add_preserving_parameters(results);
  add_figure(results, {{"*J_0", four_point},
                       {"*J_{1/2}", half},
                       {"*J_1", cubic},
                       {"*J_{0.46415}", smooth},
                       {"J_{0.836} *J_{-0.531}", kinks}});
  return results;
}

}  // namespace subdiv
