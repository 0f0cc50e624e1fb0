#include "analysis/subdivision_matrix.h"

#include <gtest/gtest.h>

#include "schemes/bspline.h"
#include "schemes/dyn_floater_hormann.h"
#include "schemes/jspline.h"

namespace subdiv {
namespace {

Mask<Rational> ternary_bspline(int degree) {
  return {3, Laurent<Rational>(3) * pow(Rational(1, 3) * smoothing_factor<Rational>(3), degree + 1)};
}

/// One step on the window equals one step on all points.
void expect_same_step(const Mask<Rational>& mask, const IndexWindow& window) {
  const Matrix<Rational> matrix = subdivision_matrix(mask, window);
  constexpr int margin = 9;
  std::vector<Rational> values;
  for (int j = window.first - margin; j <= window.last + margin; ++j)
    values.emplace_back(1 + j * j * j, 7 + j * j);
  const Laurent<Rational> control(window.first - margin, values);
  const Laurent<Rational> refined = refine_sequence(mask, control);
  for (int i = window.first; i <= window.last; ++i) {
    Rational value(0);
    for (int j = window.first; j <= window.last; ++j)
      value += matrix(i - window.first, j - window.first) * control[j];
    EXPECT_EQ(value, refined[i]);
  }
}

TEST(SubdivisionMatrix, WindowsAreClosedUnderRefinement) {
  const Mask<Rational> asymmetric{2, shift(bspline<Rational>(4).symbol, 3)};
  for (const Mask<Rational>& mask :
       {jspline(Rational(1, 3)), bspline<Rational>(2), bspline<Rational>(7),
        dyn_floater_hormann(Rational(1, 128)), ternary_bspline(2), ternary_bspline(4), asymmetric}) {
    for (int padding = 0; padding <= 2; ++padding) expect_same_step(mask, vertex_window(mask, padding));
  }
}

TEST(SubdivisionMatrix, Windows) {
  EXPECT_EQ(vertex_window(jspline(Rational(1, 3))), (IndexWindow{-3, 3}));
  EXPECT_EQ(vertex_window(jspline(Rational(1, 3)), 1), (IndexWindow{-4, 4}));
  EXPECT_EQ(vertex_window(bspline<Rational>(2)), (IndexWindow{-2, 1}));
  EXPECT_EQ(vertex_window(ternary_bspline(2)), (IndexWindow{-3, 0}));
  EXPECT_EQ(vertex_window(Mask<Rational>{3, Laurent<Rational>(-2, std::vector<Rational>(6, Rational(1, 2)))}),
            (IndexWindow{-1, 1}));
}

TEST(SubdivisionMatrix, TheMatrixOfJsplines) {
  // 16 times the rows: even (2s, 16-4s, 2s), odd (s-1, 9-s, 9-s, s-1), here at s = 3.
  const Matrix<Rational> matrix = subdivision_matrix(jspline(Rational(3)), {-2, 2});
  const int expected[5][5] = {
      {6, 4, 6, 0, 0}, {2, 6, 6, 2, 0}, {0, 6, 4, 6, 0}, {0, 2, 6, 6, 2}, {0, 0, 6, 4, 6}};
  for (int i = 0; i < 5; ++i) {
    for (int j = 0; j < 5; ++j) EXPECT_EQ(matrix(i, j), Rational(expected[i][j], 16)) << i << " " << j;
  }
}

TEST(SubdivisionMatrix, RejectsWhatHasNoMatrix) {
  EXPECT_THROW(subdivision_matrix(jspline(Rational(1, 3)), {-1, 1}), std::domain_error);
  EXPECT_THROW(subdivision_matrix(jspline(Rational(1, 3)), {-2, 1}), std::domain_error);
  EXPECT_THROW(vertex_window(Mask<Rational>{2, {}}), std::domain_error);
  EXPECT_THROW(vertex_window(Mask<Rational>{1, Laurent<Rational>(1)}), std::domain_error);
  EXPECT_THROW(vertex_window(Mask<Rational>{3, Laurent<Rational>::monomial(1)}), std::domain_error);
}

}  // namespace
}  // namespace subdiv
