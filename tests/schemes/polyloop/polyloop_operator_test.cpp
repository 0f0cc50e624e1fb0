#include "schemes/polyloop/polyloop_operator.h"

#include <gtest/gtest.h>

#include "schemes/algebra/rational_function.h"
#include "schemes/bspline.h"
#include "schemes/jspline.h"

namespace subdiv {
namespace {

using F = RationalFunction;
using Operator = PolyloopOperator<F>;
using namespace polyloop;

Mask<F> mask(const std::vector<Operator>& steps) { return mask_of(sequence(steps)).value(); }

F half() { return fraction<F>(1, 2); }

TEST(PolyloopOperator, SequencesOfTheChapterAreSchemes) {  // polyloops 3.1
  const F s = F::variable(0);
  EXPECT_TRUE(same_but_for_numbers(mask({refine<F>(), dual<F>()}), bspline<F>(2)));
  EXPECT_TRUE(same_but_for_numbers(mask({refine<F>(), dual<F>(), dual<F>()}), bspline<F>(3)));
  EXPECT_EQ(mask({refine<F>(), tuck(half())}), jspline(F(1)));
  EXPECT_EQ(mask({refine<F>(), tuck(half()), untuck<F>()}), jspline(F(0)));
  // The chapter's J_s is that of 1 - s/8.
  EXPECT_EQ(mask({refine<F>(), tuck(half()), tuck(s * fraction<F>(-1, 8))}),
            jspline(F(1) - s * fraction<F>(1, 8)));
}

TEST(PolyloopOperator, SplitAndTweakIsJ) {
  const F s = F::variable(0);
  const F old_share = s * half();
  const F new_share = (F(1) - s) * fraction<F>(1, 8);
  EXPECT_EQ(mask({refine<F>(), tweak(old_share, new_share)}), jspline(s));
}

TEST(PolyloopOperator, OperatorsThatTellVerticesApartHaveNoMask) {
  EXPECT_FALSE(mask_of(tweak(half(), F(0))));
  EXPECT_EQ(composed(tweak(half(), F(0)), tweak(F(0), half())).period, 2);
  EXPECT_EQ(composed(tweak(half(), F(0)), refine<F>()).outputs(), 4);
}

TEST(PolyloopOperator, MovesVerticesWhereAllStepsDo) {
  EXPECT_TRUE(composed(tuck(half()), untuck<F>()).moves_vertices);
  EXPECT_FALSE(composed(refine<F>(), tuck(half())).moves_vertices);
  EXPECT_FALSE(composed(tuck(half()), refine<F>()).moves_vertices);
}

TEST(PolyloopOperator, ThreeVerticesOfTwoAreNotReduced) {
  const auto place = [](int j) { return Laurent<F>::monomial(j, F(1)); };
  const Operator op{2, {place(0), place(1), place(2)}, false};
  EXPECT_EQ(reduced(op).period, 2);
  EXPECT_EQ(reduced(op).outputs(), 3);
  EXPECT_EQ(reduced(Operator{2, {place(0), place(1)}, false}).period, 1);
}

}  // namespace
}  // namespace subdiv
