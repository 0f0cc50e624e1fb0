// The catalogue's masks against the printed stencils of their sources, and against other ways to the same
// scheme.

#include "schemes/catalogue.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "schemes/algebra/jet.h"
#include "schemes/algebra/rational_function.h"
#include "schemes/bspline.h"
#include "schemes/deslauriers_dubuc.h"
#include "schemes/dyn_floater_hormann.h"
#include "schemes/four_point.h"
#include "schemes/jspline.h"
#include "tests/schemes/input_errors.h"

namespace subdiv {
namespace {

using testing::expect_input_error;
using P = Laurent<Rational>;
using F = RationalFunction;

/// The refined sequence written out with the printed even and odd rules, for a random-looking control
/// sequence.
template <class R>
std::vector<R> control_values() {
  std::vector<R> values;
  for (const int v : {3, -1, 4, 1, -5, 9, 2, -6, 5, 3}) values.push_back(R(v));
  return values;
}

TEST(Jspline, RefinesByThePrintedRules) {
  // J-splines, section 1: even (a, 8-2a, a)/8, odd (b-1, 9-b, 9-b, b-1)/16.
  const F a = F::variable(0);
  const F b = F::variable(1);
  const std::vector<F> p = control_values<F>();
  const Laurent<F> refined = refine_sequence(jspline(a, b), Laurent<F>(0, p));
  for (std::size_t j = 1; j + 2 < p.size(); ++j) {
    const int at = 2 * static_cast<int>(j);
    EXPECT_EQ(refined[at], (a * p[j - 1] + (F(8) - F(2) * a) * p[j] + a * p[j + 1]) / F(8));
    EXPECT_EQ(refined[at + 1], ((b - F(1)) * (p[j - 1] + p[j + 2]) + (F(9) - b) * (p[j] + p[j + 1])) / F(16));
  }
}

TEST(Jspline, HasThePrintedSymbol) {
  // J-splines, section 3, equation (1), whose powers of z start at 0.
  const F s = F::variable(0);
  const F outer = (s - F(1)) / F(16);
  const F inner = (F(9) - s) / F(16);
  const Laurent<F> printed(0, {outer, s / F(8), inner, F(1) - s / F(4), inner, s / F(8), outer});
  EXPECT_EQ(shift(jspline(s).symbol, 3), printed);
}

TEST(Jspline, BlendsFourPointAndCubic) {
  const F s = F::variable(0);
  const Laurent<F> blend = (F(1) - s) * four_point(F(Rational(1, 16))).symbol + s * bspline<F>(3).symbol;
  EXPECT_EQ(jspline(s).symbol, blend);
}

TEST(Jspline, ContainsTheNamedSchemes) {
  EXPECT_EQ(jspline(Rational(0)), four_point(Rational(1, 16)));
  EXPECT_EQ(jspline(Rational(1)).symbol, bspline<Rational>(3).symbol);
  EXPECT_EQ(jspline(Rational(3, 2)), bspline<Rational>(5));
}

TEST(FourPoint, RefinesByThePrintedRule) {
  // Dyn, Levin, Gregory 1987: -w P(j-1) + (1/2+w) P(j) + (1/2+w) P(j+1) - w P(j+2) between P(j) and P(j+1).
  const F w = F::variable(0);
  const std::vector<F> p = control_values<F>();
  const Laurent<F> refined = refine_sequence(four_point(w), Laurent<F>(0, p));
  for (std::size_t j = 1; j + 2 < p.size(); ++j) {
    EXPECT_EQ(refined[2 * static_cast<int>(j)], p[j]);
    EXPECT_EQ(refined[2 * static_cast<int>(j) + 1],
              (F(Rational(1, 2)) + w) * (p[j] + p[j + 1]) - w * (p[j - 1] + p[j + 2]));
  }
}

TEST(DynFloaterHormann, HasThePrintedMaskAndReproducesCubics) {
  // Dyn, Floater, Hormann 2005: mask (-5, -7, 35, 105, 105, 35, -7, -5)/128.
  std::vector<Rational> printed;
  for (const int c : {-5, -7, 35, 105, 105, 35, -7, -5}) printed.emplace_back(c, 128);
  EXPECT_EQ(dyn_floater_hormann(Rational(1, 128)).symbol, P(-4, printed));
  // Its rules are Lagrange's cubic through -1, 0, 1, 2 at 1/4 and 3/4: cubes stay cubes, at j + 1/4 and j +
  // 3/4.
  const auto cube = [](const Rational& t) { return t * t * t; };
  std::vector<Rational> values;
  for (int j = -6; j <= 6; ++j) values.push_back(cube(Rational(j)));
  const P refined = refine_sequence(dyn_floater_hormann(Rational(1, 128)), P(-6, values));
  for (int i = -6; i <= 6; ++i) EXPECT_EQ(refined[i], cube(Rational(2 * i + 1, 4))) << i;
  // Tension 0 is Chaikin's corner cutting, the quadratic B-spline, up to the shift of the indices.
  EXPECT_EQ(shift(dyn_floater_hormann(Rational(0)).symbol, 1), bspline<Rational>(2).symbol);
}

TEST(DeslauriersDubuc, HasThePrintedStencils) {
  EXPECT_EQ(deslauriers_dubuc<Rational>(2).symbol, bspline<Rational>(1).symbol);
  EXPECT_EQ(deslauriers_dubuc<Rational>(4), four_point(Rational(1, 16)));
  const auto odd_rule = [](int points) {
    const P odd = residue_class(deslauriers_dubuc<Rational>(points).symbol, 1, 2);
    EXPECT_EQ(odd.first(), -points / 2);
    return odd.coefficients();
  };
  std::vector<Rational> six;
  for (const int c : {3, -25, 150, 150, -25, 3}) six.emplace_back(c, 256);
  EXPECT_EQ(odd_rule(6), six);
  std::vector<Rational> eight;
  for (const int c : {-5, 49, -245, 1225, 1225, -245, 49, -5}) eight.emplace_back(c, 2048);
  EXPECT_EQ(odd_rule(8), eight);
}

TEST(DeslauriersDubuc, InterpolatesAndReproducesPolynomials) {
  for (int points = 2; points <= 12; points += 2) {
    const Mask<Rational> mask = deslauriers_dubuc<Rational>(points);
    EXPECT_EQ(residue_class(mask.symbol, 0, 2), P(1));
    std::vector<Rational> values;
    for (int j = -20; j <= 20; ++j) values.push_back(pow(Rational(j), points - 1));
    const P refined = refine_sequence(mask, P(-20, values));
    for (int i = -9; i <= 9; ++i) EXPECT_EQ(refined[i], pow(Rational(i, 2), points - 1));
  }
}

/// Lane and Riesenfeld's algorithm itself: every value doubled, then `degree` times neighbours averaged.
std::vector<Rational> doubled_and_averaged(const std::vector<Rational>& values, int degree) {
  std::vector<Rational> result;
  for (const Rational& v : values) result.insert(result.end(), {v, v});
  for (int k = 0; k < degree; ++k) {
    for (std::size_t i = 0; i + 1 < result.size(); ++i) result[i] = (result[i] + result[i + 1]) / Rational(2);
    result.pop_back();
  }
  return result;
}

TEST(Bspline, IsRepeatedAveragingOfADoubledSequence) {
  const std::vector<Rational> p = control_values<Rational>();
  for (int degree = 0; degree <= 9; ++degree) {
    const P refined = refine_sequence(bspline<Rational>(degree), P(0, p));
    const std::vector<Rational> expected = doubled_and_averaged(p, degree);
    // Averaging forwards moves the sequence by half an index each time; the mask is centred instead.
    const int offset = degree - (degree + 1) / 2;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_EQ(refined[static_cast<int>(i) + offset], expected[i]) << "degree " << degree << ", index " << i;
    }
  }
}

TEST(Bspline, HasBinomialCoefficients) {
  // Degrees 2, 3 and 5 as in any textbook: (1, 3, 3, 1)/4, (1, 4, 6, 4, 1)/8, (1, 6, 15, 20, 15, 6, 1)/32.
  const auto over = [](const std::vector<int>& numerators, int denominator) {
    std::vector<Rational> result;
    for (const int n : numerators) result.emplace_back(n, denominator);
    return result;
  };
  EXPECT_EQ(bspline<Rational>(0).symbol, P(0, {1, 1}));
  EXPECT_EQ(bspline<Rational>(1).symbol, P(-1, over({1, 2, 1}, 2)));
  EXPECT_EQ(bspline<Rational>(2).symbol.coefficients(), over({1, 3, 3, 1}, 4));
  EXPECT_EQ(bspline<Rational>(3).symbol, P(-2, over({1, 4, 6, 4, 1}, 8)));
  EXPECT_EQ(bspline<Rational>(5).symbol, P(-3, over({1, 6, 15, 20, 15, 6, 1}, 32)));
}

TEST(CurveSchemes, RejectNonsense) {
  EXPECT_THROW(bspline<Rational>(-1), std::domain_error);
  EXPECT_THROW(deslauriers_dubuc<Rational>(5), std::domain_error);
  EXPECT_THROW(deslauriers_dubuc<Rational>(0), std::domain_error);
}

TEST(CurveSchemes, AutomaticDerivativesAreTheExactOnes) {
  using Jet = ceres::Jet<double, 2>;
  const Mask<Jet> at_jets = jspline(Jet(0.25, 0), Jet(-0.5, 1));
  const Mask<F> symbolic = jspline(F::variable(0), F::variable(1));
  const std::vector<double> point{0.25, -0.5};
  for (int i = -3; i <= 3; ++i) {
    EXPECT_DOUBLE_EQ(at_jets.symbol[i].a, symbolic.symbol[i].evaluate<double>(point));
    for (int v = 0; v < 2; ++v) {
      EXPECT_DOUBLE_EQ(at_jets.symbol[i].v[v], symbolic.symbol[i].derivative(v).evaluate<double>(point));
    }
  }
}

TEST(Catalogue, EveryFamilyIsAffinelyInvariantForAllParameters) {
  for (const Family& family : catalogue()) {
    for (const FamilyForm& form : family.forms) {
      std::vector<long> whole;
      for (const Parameter& p : form.parameters) {
        if (p.whole) whole.push_back(p.least + 2 * p.step);
      }
      const Mask<Polynomial> mask = form.mask(whole);
      EXPECT_EQ(sum(mask.symbol), Polynomial(mask.arity)) << family.name;
      for (int r = 0; r < mask.arity; ++r) {
        EXPECT_EQ(sum(residue_class(mask.symbol, r, mask.arity)), Polynomial(1)) << family.name;
      }
    }
  }
}

TEST(Catalogue, MasksAreThoseOfTheFamilies) {
  const std::vector<std::string> none;
  const std::vector<std::string> ab{"a", "b"};
  const std::vector<std::string> s{"s"};
  const Polynomial x = Polynomial::variable(0);
  EXPECT_EQ(find_form(find_family("jspline"), s).mask({}), jspline(x));
  EXPECT_EQ(find_form(find_family("jspline"), ab).mask({}), jspline(x, Polynomial::variable(1)));
  EXPECT_EQ(find_form(find_family("four-point"), none).mask({}), four_point(x));
  EXPECT_EQ(find_form(find_family("dyn-floater-hormann"), none).mask({}), dyn_floater_hormann(x));
  const std::vector<long> six{6};
  EXPECT_EQ(find_form(find_family("deslauriers-dubuc"), none).mask(six), deslauriers_dubuc<Polynomial>(6));
  const std::vector<std::string> degree{"degree"};
  EXPECT_EQ(find_form(find_family("bspline"), degree).mask(six), bspline<Polynomial>(6));
  EXPECT_EQ(&find_family("lane-riesenfeld"), &find_family("bspline"));
}

TEST(Catalogue, UnknownNamesGetTheNearestKnownOneAndTheList) {
  expect_input_error([] { return &find_family("jsplin"); },
                     {"'jsplin'", "did you mean 'jspline'?", "deslauriers-dubuc", ".json"});
  expect_input_error([] { return &find_family("Four-Point"); }, {"did you mean 'four-point'?"});
  expect_input_error([] { return &find_family("lane-reisenfeld"); }, {"did you mean 'lane-riesenfeld'?"});
  expect_input_error([] { return &find_family(""); }, {"unknown scheme ''", "jspline"});
  const Family& jspline_family = find_family("jspline");
  const std::vector<std::string> unknown{"t"};
  expect_input_error([&] { return &find_form(jspline_family, unknown); },
                     {"no parameter 't'", "s, or a and b"});
  const std::vector<std::string> misspelt{"degre"};
  expect_input_error([&] { return &find_form(find_family("bspline"), misspelt); },
                     {"did you mean 'degree'?"});
  const std::vector<std::string> half{"a"};
  expect_input_error([&] { return &find_form(jspline_family, half); }, {"missing for b"});
  const std::vector<std::string> both{"s", "a"};
  expect_input_error([&] { return &find_form(jspline_family, both); },
                     {"do not go together", "s, or a and b"});
  const std::vector<std::string> none;
  expect_input_error([&] { return &find_form(jspline_family, none); },
                     {"missing", "s, or a and b", "jspline:s="});
  expect_input_error([&] { return &find_form(find_family("bspline"), none); },
                     {"bspline takes degree", "bspline:degree="});
}

TEST(Catalogue, DescribesEveryFamily) {
  for (const Family& family : catalogue()) {
    EXPECT_FALSE(family.summary.empty()) << family.name;
    EXPECT_FALSE(family.source.empty()) << family.name;
    for (const FamilyForm& form : family.forms) {
      for (const Parameter& p : form.parameters) {
        EXPECT_FALSE(p.meaning.empty()) << family.name << " " << p.name;
        EXPECT_FALSE(p.range().empty());
      }
    }
  }
  EXPECT_EQ(usage(find_family("jspline")), "jspline takes s, or a and b");
  EXPECT_EQ(usage(find_family("four-point")), "four-point takes w (default 1/16)");
}

}  // namespace
}  // namespace subdiv
