#include "analysis/joint_spectral_radius.h"

#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/transition_matrices.h"
#include "schemes/bspline.h"
#include "schemes/deslauriers_dubuc.h"
#include "schemes/dyn_floater_hormann.h"
#include "schemes/four_point.h"
#include "schemes/jspline.h"
#include "tests/analysis/daubechies.h"
#include "tests/analysis/enclosure_matchers.h"

namespace subdiv {
namespace {

using testing::agrees;
using Family = std::vector<Matrix<Rational>>;

Matrix<Rational> matrix(const std::vector<std::vector<int>>& rows, const Rational& scale = 1) {
  const auto n = static_cast<Eigen::Index>(rows.size());
  Matrix<Rational> result(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) {
      result(i, j) = Rational(rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]) * scale;
    }
  }
  return result;
}

const Family golden_pair{matrix({{1, 1}, {0, 1}}), matrix({{1, 0}, {1, 1}})};

Family transposed(const Family& family) {
  Family result;
  for (const Matrix<Rational>& t : family) result.emplace_back(t.transpose());
  return result;
}

/// S^-1 T S for a product S of elementary matrices.
Family similar(const Family& family) {
  const Eigen::Index n = family[0].rows();
  Matrix<Rational> s = identity_matrix<Rational>(n);
  Matrix<Rational> inverse = s;
  for (Eigen::Index i = 0; i < n; ++i) {
    Matrix<Rational> e = identity_matrix<Rational>(n);
    const Eigen::Index j = (i + 1) % n;
    if (i == j) continue;
    e(i, j) = Rational(i % 2 == 0 ? 2 : -1);
    s = (s * e).eval();
    e(i, j) = -e(i, j);
    inverse = (e * inverse).eval();
  }
  Family result;
  for (const Matrix<Rational>& t : family) result.emplace_back(inverse * t * s);
  return result;
}

Family squares(const Family& family) {
  Family result;
  for (const Matrix<Rational>& a : family) {
    for (const Matrix<Rational>& b : family) result.emplace_back(a * b);
  }
  return result;
}

Family direct_sum(const Family& a, const Family& b, int corner) {
  Family result;
  for (std::size_t k = 0; k < a.size(); ++k) {
    const Eigen::Index n = a[k].rows() + b[k].rows();
    Matrix<Rational> sum = zero_matrix<Rational>(n, n);
    sum.topLeftCorner(a[k].rows(), a[k].rows()) = a[k];
    sum.bottomRightCorner(b[k].rows(), b[k].rows()) = b[k];
    sum(0, n - 1) = Rational(corner);
    result.push_back(sum);
  }
  return result;
}

Family of_mask(const Mask<Rational>& mask) { return transition_matrices(normal_form(mask)); }

// ---- The literature
// ----------------------------------------------------------------------------------------

struct Example {
  std::string name;
  Family family;
  std::string radius;  // decimals, truncated or rounded
  std::string word;    // one of the words reported
};

class LiteratureTest : public ::testing::TestWithParam<Example> {};

TEST_P(LiteratureTest, HasThePublishedRadius) {
  const JointSpectralRadius r = joint_spectral_radius(GetParam().family);
  EXPECT_TRUE(agrees(r.value, GetParam().radius));
  EXPECT_TRUE(r.attained);
  EXPECT_EQ(r.value.status, Status::closed);
  std::vector<std::string> words;
  for (const Word& word : r.words) words.push_back(word_text(word));
  EXPECT_NE(std::find(words.begin(), words.end(), GetParam().word), words.end()) << words.front();
}

INSTANTIATE_TEST_SUITE_P(
    JointSpectralRadius, LiteratureTest,
    ::testing::Values(
        // Blondel & Tsitsiklis: the golden ratio; each matrix alone is defective with radius 1.
        Example{"golden", golden_pair, "1.6180339887498948482", "01"},
        // Blondel, Theys & Vladimirov, SIAM J. Matrix Anal. 24 (2003), the family at 4/5: sqrt(4/5)
        // (1+sqrt(5))/2.
        Example{"plateau_end",
                {golden_pair[0], matrix({{1, 0}, {1, 1}}, Rational(4, 5))},
                "1.4472135954999579393",
                "01"},
        // Gripenberg, Linear Algebra Appl. 234 (1996), section 4: between 0.6596789 and 0.6596924.
        Example{"gripenberg",
                {matrix({{3, 0}, {1, 3}}, Rational(1, 5)), matrix({{3, -3}, {0, -1}}, Rational(1, 5))},
                "0.659678908955283",
                "0000000000001"},
        // Ando & Shih; Parrilo & Jadbabaie, Linear Algebra Appl. 428 (2008), example 2.8.
        Example{"ando_shih", {matrix({{1, 0}, {1, 0}}), matrix({{0, 1}, {0, -1}})}, "1", "0"},
        // Ahmadi & Parrilo (2012), example 2.1: both are nilpotent.
        Example{"nilpotent_pair", {matrix({{0, 1}, {0, 0}}), matrix({{0, 0}, {1, 0}})}, "1", "01"},
        // Parrilo & Jadbabaie 2008, example 5.4: 8.9149 = sqrt(rho(A_1 A_3)), conjectured there.
        Example{"parrilo_jadbabaie",
                {matrix({{0, 1, 7, 4}, {1, 6, -2, -3}, {-1, -1, -2, -6}, {3, 0, 9, 1}}),
                 matrix({{-3, 3, 0, -2}, {-2, 1, 4, 9}, {4, -3, 1, 1}, {1, -5, -1, -2}}),
                 matrix({{1, 4, 5, 10}, {0, 5, 1, -4}, {0, -1, 4, 6}, {-1, 5, 0, 1}})},
                "8.914964143716",
                "02"},
        // Dumas, Linear Algebra Appl. 438 (2013), example 3: reducible, which a polytope of rank 2 hides.
        Example{"dumas",
                {matrix({{1, 1, 1}, {0, 0, 0}, {0, 0, 0}}), matrix({{1, 0, 0}, {0, 1, -1}, {0, 0, 0}}),
                 matrix({{0, 0, 0}, {1, 1, 0}, {0, 0, 1}})},
                "1",
                "0"},
        // The example of the d-Tarnu package: the leading eigenvalue of the product is complex.
        Example{"complex_leading",
                {matrix({{-3, -2, 1, 2}, {-2, 0, -2, 1}, {1, 3, -1, -5}, {-3, -3, -2, -1}}),
                 matrix({{1, 0, -3, -1}, {-4, -2, -1, -4}, {-1, 0, -1, 2}, {-1, -2, -1, 2}})},
                "4.552830283202",
                "01"},
        // A rotation by an irrational angle, and a contraction.
        Example{"rotation",
                {matrix({{3, -4}, {4, 3}}, Rational(1, 5)), matrix({{9, 2}, {0, 1}}, Rational(1, 10))},
                "1",
                "0"},
        // A finite group: rotation by a right angle and a reflection.
        Example{"finite_group", {matrix({{0, -1}, {1, 0}}), matrix({{1, 0}, {0, -1}})}, "1", "1"}),
    [](const auto& example) { return example.param.name; });

TEST(JointSpectralRadius, HasClosedForms) {
  EXPECT_EQ(joint_spectral_radius(golden_pair).value.exact, "(1+sqrt(5))/2");
  const JointSpectralRadius group =
      joint_spectral_radius(Family{matrix({{0, -1}, {1, 0}}), matrix({{1, 0}, {0, -1}})});
  EXPECT_EQ(group.value.exact, "1");
  EXPECT_EQ(group.bounded, Decision::yes);
  EXPECT_EQ(joint_spectral_radius(Family{matrix({{1, 1}, {1, 0}})}).value.exact, "(1+sqrt(5))/2");
}

// ---- Schemes
// -----------------------------------------------------------------------------------------------

TEST(JointSpectralRadius, OfDaubechiesMasks) {
  // alpha = n - 1 - log2 rho: 0.5500, 1.0878, 1.6179 (Daubechies & Lagarias
  // 1992); 1.969, 2.189, 2.460, 2.761, 3.074 (Rioul 1992). Order 10: a longer word than that of the end
  // points; these alone would give 3.381.
  const std::vector<std::pair<int, std::string>> radii{
      {2, "1.36602540378443864676372317075"}, {3, "1.88186883113665472301331643028"},
      {4, "2.60642742441038678619616138456"}, {5, "4.0869836440511348926927235109"},
      {6, "7.01703093194070534939261321052"}, {7, "11.6284838729400301555087401053"},
      {8, "18.8851666984211612639584460797"}, {9, "30.4081284471285376206949683314"},
      {10, "49.8184827347539041450409501133"}};
  for (const auto& [order, radius] : radii) {
    const JointSpectralRadius r = joint_spectral_radius(transition_matrices(testing::daubechies(order)));
    EXPECT_TRUE(agrees(r.value, radius)) << order;
    EXPECT_TRUE(r.attained) << order;
    EXPECT_EQ(word_text(r.words[0]), order == 10 ? "0011" : "0");
  }
}

TEST(JointSpectralRadius, OfInterpolatoryMasks) {
  EXPECT_EQ(joint_spectral_radius(of_mask(deslauriers_dubuc<Rational>(4))).value.exact, "2");
  EXPECT_EQ(joint_spectral_radius(of_mask(deslauriers_dubuc<Rational>(6))).value.exact, "9/2");
  // Roots of 4x^3-28x^2-217x+500 and 512x^4-8752x^3-203970x^2+1235225x+3001250: the symbols are non-negative,
  // so that one matrix decides (nonnegative_symbol_test.cpp).
  const JointSpectralRadius eight = joint_spectral_radius(of_mask(deslauriers_dubuc<Rational>(8)));
  EXPECT_TRUE(agrees(eight.value, "10.919761704711538797901591012"));
  ASSERT_TRUE(eight.exact);
  EXPECT_EQ(eight.exact->degree(), 3);
  const JointSpectralRadius ten = joint_spectral_radius(of_mask(deslauriers_dubuc<Rational>(10)));
  EXPECT_TRUE(agrees(ten.value, "27.9819881393384523902500744031"));
}

TEST(JointSpectralRadius, OfTheFourPointScheme) {
  // rho = (1 + sqrt(1 - 16w)) / 2 up to 1/16; then the largest root of x^4-2wx^3+(8w^2-2w)x^2-8w^2x-32w^3
  // (word 01).
  EXPECT_EQ(joint_spectral_radius(of_mask(four_point(Rational(1, 32)))).value.exact, "(2+sqrt(2))/4");
  const JointSpectralRadius r = joint_spectral_radius(of_mask(four_point(Rational(1, 10))));
  ASSERT_TRUE(r.exact);
  const Rational w(1, 10);
  const UnivariatePolynomial q({Rational(-32) * w * w * w, Rational(-8) * w * w,
                                Rational(8) * w * w - Rational(2) * w, Rational(-2) * w, Rational(1)});
  EXPECT_EQ(real_roots(q).back().value, *r.exact);
  EXPECT_EQ(word_text(r.words[0]), "01");
}

TEST(JointSpectralRadius, OfTheDualFourPointScheme) {
  EXPECT_EQ(joint_spectral_radius(of_mask(dyn_floater_hormann(Rational(1, 128)))).value.exact, "9/4");
  // Between w = 0.00784 and 0.01386 the leading pair of T_0 is complex, of modulus sqrt(512 w^2 + 32 w); T_1
  // ties with it. Near the lower end, where its argument is small, long runs of one letter are larger.
  EXPECT_EQ(joint_spectral_radius(of_mask(dyn_floater_hormann(Rational(1, 100)))).value.exact,
            "2*sqrt(58)/25");
  const JointSpectralRadius near = joint_spectral_radius(of_mask(dyn_floater_hormann(Rational(79, 10000))));
  EXPECT_GT(pow(near.value.lower, 2),
            Rational(512) * Rational(79, 10000) * Rational(79, 10000) + Rational(32) * Rational(79, 10000));
  EXPECT_LT(near.value.width(), pow(Rational(10), -6));
  // 222208w^3+37056w^2+1248w-25 changes sign there: word 01.
  const JointSpectralRadius r = joint_spectral_radius(of_mask(dyn_floater_hormann(Rational(1, 50))));
  EXPECT_EQ(word_text(r.words[0]), "01");
  EXPECT_TRUE(agrees(r.value, "0.951011672479626293"));
}

TEST(JointSpectralRadius, OfJSplines) {
  // s <= 3/2: 2-s; 3/2 <= s <= 2: ((s-1)+sqrt((s-1)(15-7s)))/4; 2 <= s <= 3: (s-1)/2; then s-2
  // (three_tap_radius.h).
  const auto radius = [](const char* s) {
    const Rational x = Rational::parse(s);
    return joint_spectral_radius(of_mask(jspline(x, x))).exact.value();
  };
  for (const char* s : {"-1", "0", "1/2", "127/100", "7/5"}) {
    EXPECT_EQ(radius(s), Algebraic(Rational(2) - Rational::parse(s))) << s;
  }
  for (const char* s : {"8/5", "177/100", "19/10"}) {
    const Rational x = Rational::parse(s) - Rational(1);
    const Algebraic root = sqrt(Algebraic(x * (Rational(8) - Rational(7) * x)));
    EXPECT_EQ(radius(s), (Algebraic(x) + root) / Algebraic(4)) << s;
  }
  for (const char* s : {"2", "5/2", "3"}) {
    EXPECT_EQ(radius(s), Algebraic((Rational::parse(s) - Rational(1)) / Rational(2))) << s;
  }
  for (const char* s : {"7/2", "4", "6"})
    EXPECT_EQ(radius(s), Algebraic(Rational::parse(s) - Rational(2))) << s;
}

// ---- Reducible, defective, degenerate
// ----------------------------------------------------------------------

TEST(JointSpectralRadius, OfBlocksIsTheLargest) {
  // Golden ratio above, a smaller radius below, and the other way round; coupled, and hidden by a similarity.
  const Family small{matrix({{0, 1}, {1, 0}}), matrix({{1, 0}, {0, -1}})};
  const Family three{matrix({{3}}), matrix({{-2}})};
  for (const Family& family : {direct_sum(golden_pair, small, 5), direct_sum(small, golden_pair, 7)}) {
    const JointSpectralRadius r = joint_spectral_radius(similar(family));
    EXPECT_EQ(r.value.exact, "(1+sqrt(5))/2");
    EXPECT_EQ(r.blocks.size(), 2u);
    EXPECT_EQ(r.bounded, Decision::yes);
  }
  const JointSpectralRadius r = joint_spectral_radius(similar(direct_sum(golden_pair, three, 1)));
  EXPECT_EQ(r.value.exact, "3");
  EXPECT_EQ(word_text(r.words[0]), "0");
}

TEST(JointSpectralRadius, OfNilpotentAndDefectiveFamilies) {
  const JointSpectralRadius zero =
      joint_spectral_radius(Family{matrix({{0, 1}, {0, 0}}), matrix({{0, 2}, {0, 0}})});
  EXPECT_EQ(zero.value.exact, "0");
  // Powers grow like k: the radius is 1, and boundedness is not claimed.
  const JointSpectralRadius jordan = joint_spectral_radius(Family{matrix({{1, 1}, {0, 1}})});
  EXPECT_EQ(jordan.value.exact, "1");
  EXPECT_EQ(jordan.bounded, Decision::undecided);
}

TEST(JointSpectralRadius, RejectsWhatIsNoFamily) {
  EXPECT_THROW((void)joint_spectral_radius(Family{}), std::domain_error);
  EXPECT_THROW((void)joint_spectral_radius(Family{Matrix<Rational>(2, 3)}), std::domain_error);
  EXPECT_THROW((void)joint_spectral_radius(Family{matrix({{1}}), matrix({{1, 0}, {0, 1}})}),
               std::domain_error);
  Matrix<Interval> unbounded(1, 1);
  unbounded(0, 0) = Interval(1) / Interval(0);
  EXPECT_THROW((void)joint_spectral_radius(std::vector{unbounded}), std::domain_error);
}

// ---- Invariances and bounds
// --------------------------------------------------------------------------------

/// Three matrices of dimension 3 with small integer entries.
Family random_family(std::mt19937& random) {
  std::uniform_int_distribution<int> entry(-3, 3);
  Family result;
  for (int k = 0; k < 2; ++k) {
    std::vector<std::vector<int>> rows(3, std::vector<int>(3));
    for (auto& row : rows) {
      for (int& x : row) x = entry(random);
    }
    result.push_back(matrix(rows));
  }
  return result;
}

bool overlap(const Enclosure& a, const Enclosure& b) { return a.lower <= b.upper && b.lower <= a.upper; }

TEST(JointSpectralRadius, IsInvariant) {
  std::mt19937 random(20);
  int attained = 0;
  for (int trial = 0; trial < 8; ++trial) {
    const Family family = random_family(random);
    const JointSpectralRadius r = joint_spectral_radius(family);
    attained += r.attained ? 1 : 0;
    EXPECT_TRUE(overlap(r.value, joint_spectral_radius(similar(family)).value)) << trial;
    EXPECT_TRUE(overlap(r.value, joint_spectral_radius(transposed(family)).value)) << trial;
    const Enclosure square = joint_spectral_radius(squares(family)).value;
    EXPECT_TRUE(r.value.lower * r.value.lower <= square.upper &&
                square.lower <= r.value.upper * r.value.upper)
        << trial;
  }
  EXPECT_GE(attained, 7);
}

TEST(JointSpectralRadius, OfAMaskRefinedByItselfIsTheSquare) {
  // Two steps at once have arity 4 and the symbol b(z) b(z^2).
  const Mask<Rational> mask = four_point(Rational(1, 10));
  const Scheme<Rational> scheme = stationary("four-point", mask);
  const Mask<Rational> twice{4, iterated_symbol(scheme, 2)};
  const JointSpectralRadius once = joint_spectral_radius(of_mask(mask));
  const JointSpectralRadius both = joint_spectral_radius(of_mask(twice));
  EXPECT_EQ(normal_form(twice).factors, normal_form(mask).factors);
  ASSERT_TRUE(once.exact && both.exact);
  EXPECT_EQ(*both.exact, *once.exact * *once.exact);
}

TEST(JointSpectralRadius, IsBoundedByAnyNormAndProduct) {
  std::mt19937 random(7);
  for (int trial = 0; trial < 10; ++trial) {
    const Family family = random_family(random);
    const JointSpectralRadius r = joint_spectral_radius(family);
    Rational norm;
    for (const Matrix<Rational>& t : family) {
      for (Eigen::Index j = 0; j < t.cols(); ++j) {
        Rational sum;
        for (Eigen::Index i = 0; i < t.rows(); ++i) sum += abs(t(i, j));
        norm = std::max(norm, sum);
      }
      // rho^n >= |det|
      const std::vector<Rational> p = characteristic_polynomial(t);
      EXPECT_LE(abs(p[0]), pow(r.value.upper, t.rows())) << trial;
    }
    EXPECT_LE(r.value.lower, norm) << trial;
  }
}

// ---- Balance, repetition, size
// ------------------------------------------------------------------------------

TEST(JointSpectralRadius, BalancesCyclesThatTie) {
  // Both have the eigenvalues 11 and 5; T_1^k (1, 0) tends to 11/6 times the normalised leading vector of
  // T_1, so that the two cycles close only when scaled against each other.
  const Family family{matrix({{55, -41}, {0, 25}}, Rational(1, 5)), matrix({{16, -11}, {5, 0}})};
  const JointSpectralRadius r = joint_spectral_radius(family);
  EXPECT_EQ(r.value.exact, "11");
  EXPECT_EQ(r.bounded, Decision::yes);
}

TEST(JointSpectralRadius, FindsLongRunsOfALetter) {
  // b = (12 + 11z - 2z^2) / 21: T_0 has the eigenvalues 12/21 and 11/21, and the trace of T_1 T_0^k is
  // (22 11^k - 13 12^k) / 21^(k+1), up to the sign nearly 13 12^k: a run of about 55 letters is best.
  const Family family{matrix({{12, 0}, {-2, 11}}), matrix({{11, 12}, {0, -2}})};
  const JointSpectralRadius r = joint_spectral_radius(family);
  EXPECT_TRUE(r.attained);
  ASSERT_FALSE(r.words.empty());
  EXPECT_GE(r.words[0].size(), 50u);
  EXPECT_LE(r.words[0].size(), 60u);
  for (const int k : {40, 50, 55, 60, 70}) {
    // |tr| <= 2 rho^(k+1)
    const Rational trace = abs(Rational(22) * pow(Rational(11), k) - Rational(13) * pow(Rational(12), k));
    EXPECT_LE(trace, Rational(2) * pow(r.value.upper, k + 1)) << k;
  }
}

TEST(JointSpectralRadius, IgnoresRepeatedAndNegatedMatrices) {
  const Family family{matrix({{-1, 0, -1}, {-2, 0, -1}, {-1, 0, 1}}),
                      matrix({{1, 0, 1}, {0, 1, -1}, {1, 1, 2}})};
  const JointSpectralRadius r = joint_spectral_radius(family);
  Matrix<Rational> opposite = family[1];
  for (Rational& x : opposite.reshaped()) x = -x;
  const JointSpectralRadius more = joint_spectral_radius(Family{opposite, family[0], opposite, family[1]});
  EXPECT_TRUE(more.attained);
  ASSERT_TRUE(r.exact && more.exact);
  EXPECT_EQ(*more.exact, *r.exact);
  for (const int letter : more.words[0]) EXPECT_LE(letter, 1);
  // The same moduli do not make the same matrix: sqrt(2) alone, 2 together.
  EXPECT_EQ(joint_spectral_radius(Family{matrix({{1, 1}, {1, -1}}), matrix({{1, 1}, {1, 1}})}).value.exact,
            "2");
}

TEST(JointSpectralRadius, ScalesWithTheMatrices) {
  for (const int exponent : {-400, -30, 30, 400}) {
    const Rational scale = pow(Rational(10), exponent);
    Family family = golden_pair;
    for (Matrix<Rational>& t : family) t = (scale * t).eval();
    const JointSpectralRadius r = joint_spectral_radius(family);
    EXPECT_TRUE(r.attained) << exponent;
    ASSERT_TRUE(r.exact) << exponent;
    EXPECT_EQ(*r.exact / Algebraic(scale), (Algebraic(1) + sqrt(Algebraic(5))) / Algebraic(2)) << exponent;
  }
}

TEST(JointSpectralRadius, OfIsometries) {
  // Two rotations by irrational angles and a reflection; in other coordinates, where no polytope closes.
  const Family family{matrix({{3, -4}, {4, 3}}, Rational(1, 5)), matrix({{5, -12}, {12, 5}}, Rational(1, 13)),
                      matrix({{1, 0}, {0, -1}})};
  const Enclosure value = joint_spectral_radius(similar(family)).value;
  EXPECT_LE(value.lower, Rational(1));
  EXPECT_GE(value.upper, Rational(1));
  EXPECT_LT(value.width(), pow(Rational(10), -6));
}

TEST(JointSpectralRadius, OfOneMatrixIsItsSpectralRadius) {
  // A defective one with intervals for entries, and a large one: the second differences of n points, 2 + 2
  // cos(pi / (n+1)).
  std::vector<Matrix<Interval>> defective(1, Matrix<Interval>(2, 2));
  defective[0] << Interval(3), Interval(1), Interval(-1), Interval(1);
  const JointSpectralRadius two = joint_spectral_radius(defective);
  EXPECT_TRUE(two.value.contains(Rational(2)));
  EXPECT_LT(two.value.width(), pow(Rational(10), -12));
  EXPECT_EQ(two.bounded, Decision::undecided);
  constexpr int n = 59;
  Matrix<Rational> laplacian = zero_matrix<Rational>(n, n);
  for (int i = 0; i < n; ++i) {
    laplacian(i, i) = Rational(2);
    if (i > 0) laplacian(i, i - 1) = laplacian(i - 1, i) = Rational(-1);
  }
  // cos(pi/60) = 0.99862953475457387378...
  const JointSpectralRadius large = joint_spectral_radius(std::vector{laplacian});
  EXPECT_TRUE(agrees(large.value, "3.9972590695091477475"));
  EXPECT_EQ(large.bounded, Decision::yes);
}

TEST(JointSpectralRadius, OfKroneckerSquaresIsTheSquare) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 4; ++trial) {
    const Family family = random_family(random);
    Family squared;
    for (const Matrix<Rational>& t : family) {
      Matrix<Rational> square(9, 9);
      for (Eigen::Index i = 0; i < 9; ++i) {
        for (Eigen::Index j = 0; j < 9; ++j) square(i, j) = t(i / 3, j / 3) * t(i % 3, j % 3);
      }
      squared.push_back(std::move(square));
    }
    const Enclosure once = joint_spectral_radius(family).value;
    const Enclosure both = joint_spectral_radius(squared).value;
    EXPECT_LE(pow(once.lower, 2), both.upper) << trial;
    EXPECT_LE(both.lower, pow(once.upper, 2)) << trial;
  }
}

TEST(JointSpectralRadius, OfRankOneMatricesIsALargestCycleMean) {
  // u_i v_i^T: products are scalars <v_i, u_j> along a cycle; here of two lengths.
  const auto outer = [](const std::vector<int>& u, const std::vector<int>& v) {
    std::vector<std::vector<int>> rows;
    for (const int x : u) {
      rows.emplace_back();
      for (const int y : v) rows.back().push_back(x * y);
    }
    return matrix(rows);
  };
  // <v_0, u_0> = 1, <v_1, u_1> = 0, <v_0, u_1> <v_1, u_0> = 2 * 3.
  EXPECT_EQ(joint_spectral_radius(Family{outer({1, 3}, {1, 0}), outer({2, 0}, {0, 1})}).value.exact,
            "sqrt(6)");
  // <v_0, u_0> = 5 now.
  EXPECT_EQ(joint_spectral_radius(Family{outer({5, 3}, {1, 0}), outer({2, 0}, {0, 1})}).value.exact, "5");
}

TEST(JointSpectralRadius, OfIntervalsEnclosesEveryMember) {
  // J_s for all s in [1.2, 1.3]: between 2 - 1.3 and 2 - 1.2, both attained.
  std::vector<Matrix<Interval>> family(2, zero_matrix<Interval>(2, 2));
  const Interval p = Interval::hull(Rational(1, 10), Rational(3, 20));
  const Interval q = Interval::hull(Rational(7, 10), Rational(4, 5));
  family[0](0, 0) = family[0](1, 0) = p;
  family[0](1, 1) = q;
  family[1](0, 0) = q;
  family[1](0, 1) = family[1](1, 1) = p;
  const JointSpectralRadius r = joint_spectral_radius(family);
  EXPECT_LE(r.value.lower, Rational(7, 10));
  EXPECT_GE(r.value.upper, Rational(4, 5));
  EXPECT_GE(r.value.lower, Rational(69, 100));
  EXPECT_LE(r.value.upper, Rational(81, 100));
  EXPECT_EQ(r.value.rigour, Rigour::certified);
}

TEST(JointSpectralRadius, OfAlgebraicNumbers) {
  // Daubechies' order 2: a(z) = 2 ((1+z)/2)^2 b(z), b = ((1+sqrt(3)) + (1-sqrt(3)) z) / 2.
  const Algebraic root = sqrt(Algebraic(3));
  const Laurent<Algebraic> half_b(
      0, {(Algebraic(1) + root) / Algebraic(4), (Algebraic(1) - root) / Algebraic(4)});
  const JointSpectralRadius r = joint_spectral_radius(transition_matrices(normal_form(2, 2, half_b)));
  EXPECT_EQ(r.value.exact, "(1+sqrt(3))/2");
  // J_s at s = sqrt(2): 2 - s.
  const Algebraic s = sqrt(Algebraic(2));
  const JointSpectralRadius j = joint_spectral_radius(transition_matrices(normal_form(jspline(s, s))));
  EXPECT_TRUE(agrees(j.value, "0.585786437626904951"));
}

TEST(JointSpectralRadius, SaysWhatItReachedWhenTimeIsShort) {
  JointSpectralRadiusBudget none;
  none.seconds = 0;
  const JointSpectralRadius r = joint_spectral_radius(transition_matrices(testing::daubechies(8)), none);
  EXPECT_FALSE(r.attained);
  EXPECT_EQ(r.value.status, Status::out_of_time);
  EXPECT_LE(r.value.lower, Rational::parse("18.88516669842116127"));
  EXPECT_GE(r.value.upper, Rational::parse("18.88516669842116126"));
  JointSpectralRadiusBudget few;
  few.vertices = 20;
  const JointSpectralRadius s = joint_spectral_radius(transition_matrices(testing::daubechies(10)), few);
  EXPECT_FALSE(s.attained);
  EXPECT_NE(s.value.status, Status::closed);
  EXPECT_LE(s.value.lower, Rational::parse("49.818482734753904146"));
  EXPECT_GE(s.value.upper, Rational::parse("49.818482734753904145"));
}

}  // namespace
}  // namespace subdiv
