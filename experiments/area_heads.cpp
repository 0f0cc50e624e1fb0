#include <array>

#include "experiments/area.h"

namespace subdiv {
namespace {

const std::string objective =
    "Minimise the largest |m_k - l_k|: m the scheme's area mask (m_k = integral of phi(t) phi'(t - k), sum "
    "of k m_k = 1), l the "
    "polygon's (l_1 = -l_{-1} = 1/2). ";
const std::string family_s = objective + "Scheme *J_s, -1.7 <= s <= 5.8.";
const std::string family_r = objective + "Scheme {J_r, *J_{3/2}}, -6 <= r <= 6.";
const std::string family_rs = objective + "Scheme {J_r, *J_s}, (r, s) in [-1.5, 1.5]^2.";
const std::string family_abs = objective + "Scheme {J_{a,b}, *J_s}, all real a and b, -2 <= s <= 6.";
const std::string figure_polygon =
    "E = area of the limit curve / area of the polygon - 1, on the polygon of js-report figure 10 (jsplines "
    "figure 9). Value: on the "
    "heptagon of data/area-witness.csv. ";
const std::string at_printed = "The largest |m_k - l_k| of the scheme with the printed parameters.";

const std::array table{
    // One and two parameters.
    ClaimHead{"area.mask", "subdivlab", "js-report 8", std::nullopt, ClaimKind::exact,
              "m_1 .. m_5 of *J_s over Q(s); m_{-k} = -m_k, m_k = 0 for k > 5."},
    ClaimHead{"area.s.js-report", "js-report", "8", "0.46415", ClaimKind::rounded, family_s},
    ClaimHead{"area.s.jsplines", "jsplines", "8", "0.46", ClaimKind::rounded, family_s},
    ClaimHead{"area.s.minimum", "subdivlab", "js-report 8", std::nullopt, ClaimKind::rounded,
              "The least maximum. " + family_s},
    ClaimHead{"area.r.js-report", "js-report", "8", "-0.0299", ClaimKind::rounded, family_r},
    ClaimHead{"area.r.jsplines", "jsplines", "8", "-0.030", ClaimKind::rounded, family_r},
    ClaimHead{"area.r.jsplines.figure", "jsplines", "figure 9, conclusion", "-0.03", ClaimKind::rounded,
              family_r},
    ClaimHead{"area.r.minimum", "subdivlab", "js-report 8", std::nullopt, ClaimKind::rounded,
              "The least maximum. " + family_r},
    ClaimHead{"area.rs.r.js-report", "js-report", "8", "0.836", ClaimKind::rounded, "r. " + family_rs},
    ClaimHead{"area.rs.s.js-report", "js-report", "8", "-0.531", ClaimKind::rounded, "s. " + family_rs},
    ClaimHead{"area.rs.r.jsplines", "jsplines", "8", "0.84", ClaimKind::rounded, "r. " + family_rs},
    ClaimHead{"area.rs.s.jsplines", "jsplines", "8", "-0.53", ClaimKind::rounded, "s. " + family_rs},
    ClaimHead{"area.rs.minimum", "subdivlab", "js-report 8", std::nullopt, ClaimKind::rounded,
              "The least maximum. " + family_rs},
    ClaimHead{"area.rs.residual.js-report", "subdivlab", "js-report 8", std::nullopt, ClaimKind::exact,
              at_printed + " {J_0.836, *J_-0.531}."},
    ClaimHead{"area.rs.residual.jsplines", "subdivlab", "jsplines 8", std::nullopt, ClaimKind::exact,
              at_printed + " {J_0.84, *J_-0.53}."},

    // Exact preservation.
    ClaimHead{"area.exact.exists", "js-report", "8, figure 10 (jsplines 8, figure 9)",
              "exactly the same area as the control polygon independent of what control points are chosen",
              ClaimKind::exact,
              "Complex a, b, s with m_k = l_k for all k, m the area mask of {J_{a,b}, *J_s}: is there any?"},
    ClaimHead{"area.exact.residual", "subdivlab", "js-report 8", std::nullopt, ClaimKind::rounded,
              "The least maximum. " + family_abs},
    ClaimHead{"area.exact.a", "js-report", "8 (jsplines 8)", "-0.0053", ClaimKind::rounded,
              "a. " + family_abs},
    ClaimHead{"area.exact.b.js-report", "js-report", "8", "1.0276", ClaimKind::rounded, "b. " + family_abs},
    ClaimHead{"area.exact.b.jsplines", "jsplines", "8", "1.03", ClaimKind::rounded, "b. " + family_abs},
    ClaimHead{"area.exact.s.js-report", "js-report", "8", "0.4666", ClaimKind::rounded, "s. " + family_abs},
    ClaimHead{"area.exact.s.jsplines", "jsplines", "8", "0.47", ClaimKind::rounded, "s. " + family_abs},
    ClaimHead{"area.exact.residual.js-report", "subdivlab", "js-report 8", std::nullopt, ClaimKind::exact,
              at_printed + " {J_{-0.0053,1.0276}, *J_0.4666}."},
    ClaimHead{"area.exact.residual.jsplines", "subdivlab", "jsplines 8", std::nullopt, ClaimKind::exact,
              at_printed + " {J_{-0.0053,1.03}, *J_0.47}."},

    // The lost polygon.
    ClaimHead{"area.model.s", "js-report", "figure 10 (jsplines figure 9)", ".476",
              ClaimKind::not_reproducible, figure_polygon + "s with E = 0 for *J_s."},
    ClaimHead{"area.model.r", "js-report", "figure 10 (jsplines figure 9)", ".050",
              ClaimKind::not_reproducible, figure_polygon + "r with E = 0 for {J_r, *J_{3/2}}."},
    ClaimHead{"area.errors.s.js-report", "js-report", "figure 10", "0.00786%", ClaimKind::not_reproducible,
              figure_polygon + "*J_0.46415."},
    ClaimHead{"area.errors.r.js-report", "js-report", "figure 10", "0.03443%", ClaimKind::not_reproducible,
              figure_polygon + "{J_-0.0299, *J_{3/2}}."},
    ClaimHead{"area.errors.rs.js-report", "js-report", "figure 10", "0.00014%", ClaimKind::not_reproducible,
              figure_polygon + "{J_0.836, *J_-0.531}."},
    ClaimHead{"area.errors.s.jsplines", "jsplines", "figure 9", "0.79%", ClaimKind::not_reproducible,
              figure_polygon + "*J_0.46."},
    ClaimHead{"area.errors.r.jsplines", "jsplines", "figure 9", "3.4%", ClaimKind::not_reproducible,
              figure_polygon + "{J_-0.03, *J_{3/2}}."},
    ClaimHead{"area.errors.rs.jsplines", "jsplines", "figure 9", "0.035%", ClaimKind::not_reproducible,
              figure_polygon + "{J_0.84, *J_-0.53}."},
    ClaimHead{"area.model.invariants", "subdivlab", "js-report figure 10", std::nullopt, ClaimKind::exact,
              "E = 2 (m_1 + m_2 x_2 + .. + m_5 x_5) - 1 with x_k = A_k/A_1, A_k = sum of P_i x P_{i+k}, as "
              "an identity of polynomials in "
              "the coordinates of a quadrilateral; on an n-gon A_{n-k} = -A_k, so x has no freedom for n = 3 "
              "and 4, one ratio for "
              "n = 5 and 6, two for n = 7 and 8, at most four."},
    ClaimHead{"area.model.quadrilaterals", "subdivlab", "js-report figure 10", std::nullopt, ClaimKind::exact,
              "E of *J_s on every quadrilateral: a function of s alone."},
    ClaimHead{
        "area.model.witness", "subdivlab", "js-report figure 10", std::nullopt, ClaimKind::exact,
        "Largest difference between js-report's five numbers, E = 0 (*J_.476), 0 ({J_.050, *J_{3/2}}), "
        ".00786 (*J_.46415), .03443 "
        "({J_-.0299, *J_{3/2}}), .00014 ({J_.836, *J_-.531}), read as fractions, and E on the heptagon of "
        "data/area-witness.csv."},
    ClaimHead{
        "area.errors.as-fractions", "subdivlab", "js-report figure 10", std::nullopt, ClaimKind::exact,
        "The least of that largest difference over all heptagons (over all values of their two ratios)."},
    ClaimHead{
        "area.errors.as-per-cent", "subdivlab", "js-report figure 10", std::nullopt, ClaimKind::exact,
        "The same with the five numbers read as per cent, over all polygons of at most eight vertices."},
    ClaimHead{"area.errors.rs.rounding", "subdivlab", "js-report figure 10", std::nullopt, ClaimKind::exact,
              "E of {J_r, *J_s} on the heptagon takes both .00014 and .00035 for pairs (r, s) that round to "
              "(.836, -.531)."},
};

}  // namespace

std::span<const ClaimHead> area_heads() { return table; }

}  // namespace subdiv
