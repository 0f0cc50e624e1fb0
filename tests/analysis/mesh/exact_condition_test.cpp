#include "analysis/mesh/exact_condition.h"

#include <gtest/gtest.h>

#include "schemes/mesh/butterfly.h"
#include "schemes/mesh/catmull_clark.h"
#include "schemes/mesh/loop.h"

namespace subdiv {
namespace {

TEST(ExactCondition, TiesAreFailures) {
  // notes 5: not smooth at valence 3; 1/4 is sub-dominant more than twice.
  EXPECT_EQ(exact_condition(butterfly<Rational>(), 3), Decision::no);
  // notes 4: with 5/8 + 3/24 the invariant mode has 1/4 as modes 1 and 2 do.
  EXPECT_EQ(exact_condition(loop_without_exception<Rational>(), 3), Decision::no);
}

TEST(ExactCondition, NothingIsSaidWhereTheNextModulusIsADoubleEigenvalue) {
  EXPECT_EQ(exact_condition(loop<Rational>(), 3), Decision::undecided);
  EXPECT_EQ(exact_condition(catmull_clark<Rational>(), 4), Decision::undecided);
}

}  // namespace
}  // namespace subdiv
