// Mesh schemes by name: the rules behind the names, values, and errors.

#include "schemes/mesh/mesh_catalogue.h"

#include <gtest/gtest.h>

#include "schemes/algebra/algebraic.h"
#include "schemes/algebra/interval.h"
#include "schemes/algebra/rational_function.h"
#include "schemes/mesh/fan.h"
#include "schemes/scheme_description.h"
#include "tests/schemes/input_errors.h"

namespace subdiv {
namespace {

using testing::expect_input_error;

/// The weight that a vertex of valence n keeps.
template <class R>
R centre_weight(const MeshScheme<R>& scheme, int valence) {
  const int sides = scheme.split == MeshSplit::quads ? 4 : 3;
  const MeshTopology fan = fan_topology(sides, valence, 3);
  return scheme.vertex_rule(fan, 0).weight(0);
}

Rational centre_weight(const char* text, int valence) {
  return centre_weight(mesh_scheme<Rational>(parse_mesh_scheme(text)), valence);
}

TEST(MeshCatalogue, NamesLeadToTheirRules) {
  EXPECT_EQ(centre_weight("catmull-clark", 3), Rational(5, 12));  // 1 - 7/(4n)
  EXPECT_EQ(centre_weight("kobbelt", 5), Rational(1));
  EXPECT_EQ(centre_weight("loop", 8), Rational(5, 8));        // notes 4
  EXPECT_EQ(centre_weight("loop", 3), Rational(7, 16));       // notes 4
  EXPECT_EQ(centre_weight("loop-1987", 3), Rational(7, 16));  // Loop 1987: 3/8 + (3/8 - 1/8)^2
  EXPECT_EQ(centre_weight("loop-1987", 4), Rational(3, 8) + Rational(9, 64));
  EXPECT_EQ(centre_weight("butterfly", 7), Rational(1));
  EXPECT_EQ(centre_weight("jspline-mesh:s=1", 3), Rational(5, 12));
  EXPECT_EQ(centre_weight("jspline-mesh-literal:s=1", 3), Rational(5, 12));
  EXPECT_EQ(centre_weight("jspline-mesh:s=0", 3), Rational(1));
  EXPECT_EQ(centre_weight("jspline-mesh:s=2", 4), Rational(1, 4));  // (1 - s/4)^2
}

TEST(MeshCatalogue, EveryFamilyHasRulesOverEveryRing) {
  for (const MeshFamily& family : mesh_catalogue()) {
    const std::string text =
        family.parameters.empty() ? family.name : family.name + ":" + family.parameters.front().name + "=1/2";
    const MeshSchemeDescription description = parse_mesh_scheme(text);
    EXPECT_EQ(description.family, &family);
    EXPECT_TRUE(names_mesh_scheme(text));
    if (family.rings_only) continue;
    const MeshScheme<Rational> exact = mesh_scheme<Rational>(description);
    EXPECT_EQ(exact.name, family.name);
    EXPECT_EQ(exact.split, family.split);
    const Rational weight = centre_weight(exact, 6);
    EXPECT_EQ(centre_weight(mesh_scheme<Algebraic>(description), 6).to_rational(), weight);
    EXPECT_TRUE((centre_weight(mesh_scheme<Interval>(description), 6) - Interval(weight)).contains_zero());
    EXPECT_NEAR(centre_weight(mesh_scheme<double>(description), 6), weight.to_double(), 1e-15);
    EXPECT_EQ(centre_weight(symbolic_mesh_scheme(description), 6), RationalFunction(weight));
  }
}

TEST(MeshCatalogue, ValuesAreExact) {
  const auto literal = [](const std::string& s) { return parse_mesh_scheme("jspline-mesh-literal:s=" + s); };
  // Regular: Kobbelt keeps 1, Catmull-Clark 9/16, so the blend keeps 1 - 7 s/16.
  const auto kept = [](const Rational& s) { return Rational(1) - Rational(7, 16) * s; };
  EXPECT_EQ(centre_weight(mesh_scheme<Rational>(literal("0.25")), 4), kept(Rational(1, 4)));
  EXPECT_EQ(centre_weight(mesh_scheme<Rational>(literal("(1+1/3)")), 4), kept(Rational(4, 3)));
  EXPECT_EQ(centre_weight(mesh_scheme<Rational>(literal("-1e-3")), 4), kept(Rational(-1, 1000)));
  const Algebraic root = centre_weight(mesh_scheme<Algebraic>(literal("sqrt(2)")), 4);
  EXPECT_EQ(root, Algebraic(1) - fraction<Algebraic>(7, 16) * sqrt(Algebraic(2)));
}

TEST(MeshCatalogue, NamesInValuesStayFree) {
  const MeshSchemeDescription description = parse_mesh_scheme("jspline-mesh:s=2*t");
  ASSERT_EQ(description.free_parameters, std::vector<std::string>{"t"});
  const RationalFunction t = RationalFunction::variable(0);
  const RationalFunction kept = RationalFunction(1) - t / RationalFunction(2);
  EXPECT_EQ(centre_weight(symbolic_mesh_scheme(description), 4), kept * kept);  // (1 - s/4)^2
  const std::vector<Rational> half{Rational(1, 2)};
  EXPECT_EQ(centre_weight(mesh_scheme<Rational>(description, half), 4), Rational(9, 16));
  EXPECT_THROW((void)mesh_scheme<Rational>(description), std::domain_error);
}

TEST(MeshCatalogue, PoleOfTheVirtualPointsIsRefused) {
  expect_input_error([] { return parse_mesh_scheme("jspline-mesh:s=9"); },
                     {"scheme 'jspline-mesh:s=9'", "does not exist at s = 9", "jspline-mesh-literal"});
  expect_input_error([] { return parse_mesh_scheme("jspline-mesh:s=sqrt(81)"); }, {"s = 9"});
  EXPECT_NO_THROW((void)parse_mesh_scheme("jspline-mesh-literal:s=9"));
  EXPECT_NO_THROW((void)parse_mesh_scheme("jspline-mesh:s=8.999"));
  const MeshSchemeDescription free = parse_mesh_scheme("jspline-mesh:s=s");
  const std::vector<Interval> around{Interval::hull(Rational(8), Rational(10))};
  expect_input_error([&] { return mesh_scheme<Interval>(free, around); }, {"s = 9"});
}

TEST(MeshCatalogue, ErrorsNameWhatIsWrongAndWhatFits) {
  const auto rejects = [](const char* text, std::initializer_list<const char*> pieces) {
    expect_input_error([&] { return parse_mesh_scheme(text); }, pieces);
  };
  rejects("", {"empty", "catmull-clark"});
  rejects("catmul-clark",
          {"unknown mesh scheme 'catmul-clark'", "did you mean 'catmull-clark'?", "butterfly"});
  rejects("jspline:s=1/2", {"'jspline' is a scheme for curves and grids", "jspline-mesh"});
  rejects("mine.json", {"'mine.json' is a scheme for curves and grids"});
  rejects("jspline-mesh", {"a value is missing for s", "jspline-mesh:s=1/2"});
  rejects("jspline-mesh:t=1", {"no parameter 't'", "takes s"});
  rejects("loop:s=1", {"no parameter 's'", "loop takes no parameters"});
  rejects("jspline-mesh:s=1,s=2", {"given twice"});
  rejects("jspline-mesh:s=1+1", {"one step", "parentheses"});
  rejects("jspline-mesh:s=1/0", {"division by zero"});
  rejects("jspline-mesh:s=sqrt(-1)", {"negative"});
  rejects("jspline-mesh:s=", {"value of 's'"});
  rejects("loop+butterfly", {"one step"});
}

TEST(MeshCatalogue, CurvesRefuseMeshSchemes) {
  EXPECT_FALSE(names_mesh_scheme("jspline:s=1"));
  expect_input_error([] { return parse_scheme("catmull-clark"); },
                     {"'catmull-clark' is a scheme for meshes", "jspline", "bspline"});
}

}  // namespace
}  // namespace subdiv
