#include "experiments/basis_fit.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include <gtest/gtest.h>

#include "tests/experiments/find_claim.h"

namespace subdiv {
namespace {

using test::find_claim;
using test::value_of;

/// Values on a grid of multiples of 1/unit, from t = -first/unit on.
struct Samples {
  std::vector<double> values;
  int first = 0;
  int unit = 1;
};

/// One step of J_s from its stencils (jsplines 1): even points (s, 8-2s, s)/8, odd ones (s-1, 9-s, 9-s,
/// s-1)/16.
Samples refine(const Samples& p, double s) {
  const auto at = [&](int i) {
    const int place = i + p.first;
    return place < 0 || place >= static_cast<int>(p.values.size())
               ? 0.0
               : p.values[static_cast<std::size_t>(place)];
  };
  Samples fine{{}, 2 * p.first + 3, 2 * p.unit};
  const int last = 2 * (static_cast<int>(p.values.size()) - 1 - p.first) + 3;
  for (int i = -fine.first; i <= last; ++i) {
    const int j = (i - (i % 2 != 0 ? 1 : 0)) / 2;
    fine.values.push_back(i % 2 == 0
                              ? (s * (at(j - 1) + at(j + 1)) + (8 - 2 * s) * at(j)) / 8
                              : ((s - 1) * (at(j - 1) + at(j + 2)) + (9 - s) * (at(j) + at(j + 1))) / 16);
  }
  return fine;
}

Samples iterate(double s, int level) {
  Samples p{{1.0}, 0, 1};
  for (int k = 0; k < level; ++k) p = refine(p, s);
  return p;
}

/// The limits of a level's points, by the limit mask (js-report 5): samples of the basis function.
Samples limit(double s, int level) {
  const Samples p = iterate(s, level);
  const double below = 12 * (6 + s);
  const double mask[] = {(72 + 2 * (s - 9) * s) / below, 2 * s * (8 - s) / below, s * (s - 1) / below};
  Samples result = p;
  const int n = static_cast<int>(p.values.size());
  for (int i = 0; i < n; ++i) {
    double sum = 0;
    for (int k = -2; k <= 2; ++k) {
      if (i + k >= 0 && i + k < n) sum += mask[std::abs(k)] * p.values[static_cast<std::size_t>(i + k)];
    }
    result.values[static_cast<std::size_t>(i)] = sum;
  }
  return result;
}

double bspline(int degree, double t) {
  t = std::abs(t);
  if (degree == 1) return std::max(0.0, 1 - t);
  if (degree == 2) {
    return t < 0.5 ? 0.75 - t * t : std::pow(std::max(0.0, 1.5 - t), 2) / 2;
  }
  const auto part = [&](double knot) { return std::pow(std::max(0.0, knot - t), 4); };
  return (part(2.5) - 5 * part(1.5) + 10 * part(0.5)) / 24;
}

double objective(const Samples& p, int degree, const std::string& norm) {
  double total = 0;
  for (std::size_t i = 0; i < p.values.size(); ++i) {
    const double e = std::abs(p.values[i] - bspline(degree, (static_cast<double>(i) - p.first) / p.unit));
    if (norm == "linf") {
      total = std::max(total, e);
    } else {
      total += (norm == "l1" ? e : e * e) / p.unit;
    }
  }
  return total;
}

/// The minimiser by golden section.
double minimiser(const std::function<double(double)>& f, double low, double high) {
  const double golden = (std::sqrt(5.0) - 1) / 2;
  for (int i = 0; i < 42; ++i) {
    const double a = high - golden * (high - low);
    const double b = low + golden * (high - low);
    (f(a) < f(b) ? high : low) = f(a) < f(b) ? b : a;
  }
  return (low + high) / 2;
}

// One test: a run takes seconds, and every test is a process of its own.
TEST(BasisFit, EveryClaimByASecondRoute) {
  const std::vector<Claim> claims = run_basis_fit().claims;
  EXPECT_EQ(claims.size(), basis_fit_heads().size());
  struct Target {
    std::string name;
    int degree;
    double low;
    double high;
  };
  for (const Target& target :
       {Target{"b2", 2, 0.5, 0.9}, Target{"b4", 4, 1.1, 1.4}, Target{"linear", 1, 0, 0.5}}) {
    for (const std::string norm : {"l1", "linf", "l2"}) {
      const std::string id = "fit." + target.name + "." + norm;
      constexpr int documents_level = 8;
      const double sampled =
          minimiser([&](double s) { return objective(iterate(s, documents_level), target.degree, norm); },
                    target.low, target.high);
      // Where the objective is smooth, rounding blurs a minimiser found by values alone.
      EXPECT_NEAR(value_of(claims, id), sampled, 1e-7) << id;
      const double continuous = minimiser(
          [&](double s) { return objective(limit(s, 9), target.degree, norm); }, target.low, target.high);
      EXPECT_NEAR(value_of(claims, id + ".continuum"), continuous, norm == "l2" ? 2e-5 : 2e-3) << id;
      EXPECT_EQ(find_claim(claims, id + ".continuum").verdict, Verdict::established) << id;
      const Verdict expected = norm == "l2" ? Verdict::established : Verdict::reproduced;
      EXPECT_EQ(find_claim(claims, id).verdict, expected) << id;
      const Rational width = find_claim(claims, id).upper.value() - find_claim(claims, id).lower.value();
      EXPECT_LE(width, Rational(1, 1000000000000000)) << id;
    }
  }
  // The six digits of js-report 9 are those of the iterate alone.
  EXPECT_NE(find_claim(claims, "fit.linear.l1").note.find(".306901"), std::string::npos);
  EXPECT_EQ(find_claim(claims, "fit.b4.l1").note.find("would print"), std::string::npos);

  EXPECT_EQ(find_claim(claims, "fit.samples").exact, std::to_string(iterate(1, 8).values.size()));
  EXPECT_EQ(find_claim(claims, "fit.l2.polynomial").exact, "a polynomial of degree 16");
  EXPECT_NE(find_claim(claims, "fit.l2.polynomial").note.find("[-1.7, 5.8]: 1."), std::string::npos);

  // The edge bound: partial sums of e(t + m) over m, summed up by size, on a grid of t.
  const Samples phi = limit(0.689, 9);
  double largest = 0;
  for (int i = 0; i < phi.unit; ++i) {
    double sum = 0;
    double h = 0;
    for (int m = 3; m >= -4; --m) {
      const int place = i + m * phi.unit + phi.first;
      const bool inside = place >= 0 && place < static_cast<int>(phi.values.size());
      const double t = static_cast<double>(i) / phi.unit + m;
      h += (inside ? phi.values[static_cast<std::size_t>(place)] : 0.0) - bspline(2, t);
      sum += std::abs(h);
    }
    largest = std::max(largest, sum);
  }
  EXPECT_NEAR(value_of(claims, "fit.b2.edge-bound.sharp"), largest, 1e-6);
  EXPECT_EQ(find_claim(claims, "fit.b2.edge-bound").verdict, Verdict::reproduced);
}

TEST(BasisFit, HeadsSayWhatIsPrinted) {
  std::vector<Claim> heads;
  for (const ClaimHead& head : basis_fit_heads()) heads.push_back({head, "", {}, {}, {}, {}, ""});
  EXPECT_EQ(find_claim(heads, "fit.b2.l1").head.printed, ".689");
  EXPECT_EQ(find_claim(heads, "fit.b2.linf").head.printed, ".639");
  EXPECT_EQ(find_claim(heads, "fit.b4.l1").head.printed, "1.27");
  EXPECT_EQ(find_claim(heads, "fit.b4.linf").head.printed, "1.27");
  EXPECT_EQ(find_claim(heads, "fit.linear.l1").head.printed, ".304763");
  EXPECT_EQ(find_claim(heads, "fit.linear.linf").head.printed, ".152773");
  EXPECT_FALSE(find_claim(heads, "fit.b2.l2").head.printed);
  EXPECT_FALSE(find_claim(heads, "fit.linear.l1.continuum").head.printed);
}

}  // namespace
}  // namespace subdiv
