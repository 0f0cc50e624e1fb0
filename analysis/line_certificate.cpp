#include "analysis/line_certificate.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "analysis/cell_refinement.h"
#include "analysis/contraction_end.h"
#include "analysis/expanding_line.h"
#include "analysis/jsr/candidate_products.h"
#include "analysis/sign_on_interval.h"
#include "schemes/algebra/specialize.h"

namespace subdiv {
namespace {

using Family = std::vector<Matrix<RationalFunction>>;

/// Beyond these no characteristic polynomials are computed: cells are decided by polytopes alone.
constexpr Eigen::Index most_rows = 16;

CertificateCell no_cell(ExpandingPart part) {
  CertificateCell cell{Decision::no, {std::move(part.range)}, Ground::product, 0, {}, false};
  cell.words = std::move(part.words);
  return cell;
}

CertificateCell line_cell(const MapCell& found) {
  CertificateCell cell{
      found.below, {closed_interval(found.box.lower[0], found.box.upper[0])}, Ground::none, 0, {}, false};
  if (found.below == Decision::yes) {
    cell.ground = Ground::polytope;
    cell.vertices = found.vertices;
    cell.sequences = true;
  }
  return cell;
}

RealInterval up_to_end(const Algebraic& end, const Rational& cut) {
  const bool upwards = end > Algebraic(cut);
  return upwards ? RealInterval{Algebraic(cut), end, true, false}
                 : RealInterval{end, Algebraic(cut), false, true};
}

CertificateCell end_cell(const ContractionEnd& proof) {
  CertificateCell cell{Decision::yes, {up_to_end(proof.end, proof.cut)}, Ground::polytope, 0, {}, false};
  for (const PolytopeProof& piece : proof.polytopes) {
    cell.vertices = std::max(cell.vertices, static_cast<std::size_t>(piece.polytope.vertices.cols()));
  }
  return cell;
}

std::vector<Eigen::MatrixXd> value_at(const Family& family, const Rational& at) {
  std::vector<Eigen::MatrixXd> result;
  for (const Matrix<RationalFunction>& t : family) {
    result.emplace_back(
        t.unaryExpr([&](const RationalFunction& f) { return specialize(f, 0, at).to_double(); }));
  }
  return result;
}

/// Points of a gap to look for long words at: most of them near its ends.
std::vector<Rational> probes(const RealInterval& gap) {
  const Rational low = gap.lower->to_interval().midpoint();
  const Rational width = gap.upper->to_interval().midpoint() - low;
  std::vector<Rational> result;
  constexpr int halvings = 20;
  for (int k = 1; k <= halvings; ++k) {
    const Rational step = width * Rational::power_of_two(-k);
    result.push_back(low + step);
    if (k > 1) result.push_back(low + width - step);
  }
  constexpr int parts = 16;
  for (int i = 1; i < parts; ++i) result.push_back(low + width * Rational(i, parts));
  return result;
}

/// Words longer than those tried that expand somewhere in a gap, judged in floating point.
std::vector<Word> long_words(const Family& family, const std::vector<OpenGap>& gaps,
                             const Deadline& deadline) {
  constexpr double rounding = 1e-9;
  CandidateSearch search;
  search.words = 400;
  search.beam = 16;
  search.longest = 12;
  search.wanted = 1;
  std::vector<Word> result;
  for (const OpenGap& gap : gaps) {
    for (const Rational& at : probes(gap.range)) {
      if (deadline.passed()) return result;
      for (const CandidateProduct& found : candidate_products(value_at(family, at), deadline, search)) {
        if (found.radius < 1 + rounding) continue;
        if (std::ranges::find(result, found.word) == result.end()) result.push_back(found.word);
      }
    }
  }
  return result;
}

/// The line cut by short words, and then by the long words that expand in what is left.
ExpandingLine expanding_line(const Family& family, const Rational& lower, const Rational& upper,
                             const Deadline& deadline) {
  ExpandingLine line(lower, upper);
  if (family[0].rows() > most_rows) return line;
  const int longest = family.size() == 2 ? 4 : 3;
  for (const ExpandingCondition& c : expanding_conditions(family, longest, Deadline(deadline.left() / 4))) {
    line.add(c);
  }
  constexpr int rounds = 4;
  for (int round = 0; round < rounds; ++round) {
    const std::vector<Word> words = long_words(family, line.gaps(), Deadline(deadline.left() / 4));
    for (const Word& word : words) {
      if (deadline.passed()) break;
      for (const ExpandingCondition& c : expanding_conditions(family, word)) line.add(c);
    }
    if (words.empty()) break;
  }
  return line;
}

/// Where cells begin: at a closed end, or next to an open one, a small part of the way to the middle.
Rational next_to(const Algebraic& end, bool closed, const Rational& middle) {
  if (closed) return end.to_rational();
  const Rational part = Rational::power_of_two(-32);
  const Rational from = end.to_interval().midpoint();
  const Algebraic near(from + (middle - from) * part);
  return rational_between(std::min(end, near), std::max(end, near));
}

/// The cells of a gap: first halved ones, which come close to open ends.
std::vector<CertificateCell> gap_cells(const OpenGap& gap, const CellDecider& decider, int depth,
                                       const Deadline& deadline) {
  const RealInterval& range = gap.range;
  const Rational middle = rational_between(*range.lower, *range.upper);
  const Rational low = next_to(*range.lower, range.lower_closed, middle);
  const Rational high = next_to(*range.upper, range.upper_closed, middle);
  std::vector<CertificateCell> cells;
  for (const MapCell& cell : refine_cells(decider, {{low}, {high}}, depth, deadline)) {
    cells.push_back(line_cell(cell));
  }
  const auto add_rest = [&](const Algebraic& end, const Rational& near) {
    cells.push_back({Decision::undecided, {up_to_end(end, near)}, Ground::none, 0, {}, false});
  };
  if (!range.lower_closed) add_rest(*range.lower, low);
  if (!range.upper_closed) add_rest(*range.upper, high);
  return cells;
}

/// Takes what is proved near an end out of the undecided cells.
void cut_away(std::vector<CertificateCell>& cells, const RealInterval& proved) {
  for (CertificateCell& cell : cells) {
    RealInterval& side = cell.sides[0];
    if (cell.smooth != Decision::undecided) continue;
    if (*proved.lower <= *side.lower && *side.lower < *proved.upper) side.lower = proved.upper;
    if (*proved.lower < *side.upper && *side.upper <= *proved.upper) side.upper = proved.lower;
  }
  std::erase_if(cells,
                [](const CertificateCell& cell) { return *cell.sides[0].lower >= *cell.sides[0].upper; });
}

/// Proves a gap right up to one of its open ends when that works.
void close_end(const Family& family, const Algebraic& end, const std::vector<Word>& words,
               const Rational& middle, const Deadline& deadline, std::vector<CertificateCell>& cells) {
  for (const Word& word : words) {
    if (deadline.passed()) return;
    const auto proof = prove_contraction_at_end(family, word, end, middle);
    if (!proof) continue;
    CertificateCell cell = end_cell(*proof);
    cut_away(cells, cell.sides[0]);
    cells.push_back(std::move(cell));
    return;
  }
}

bool touch(const RealInterval& a, const RealInterval& b) {
  return *a.upper > *b.lower || (*a.upper == *b.lower && (a.upper_closed || b.lower_closed));
}

/// Takes the later cell into the earlier one.
void join(CertificateCell& earlier, const CertificateCell& later) {
  RealInterval& side = earlier.sides[0];
  const RealInterval& next = later.sides[0];
  if (*side.upper == *next.upper) side.upper_closed = side.upper_closed || next.upper_closed;
  if (*side.upper < *next.upper) {
    side.upper = next.upper;
    side.upper_closed = next.upper_closed;
  }
  earlier.vertices = std::max(earlier.vertices, later.vertices);
  earlier.sequences = false;
  for (const Word& word : later.words) {
    if (std::ranges::find(earlier.words, word) == earlier.words.end()) earlier.words.push_back(word);
  }
}

}  // namespace

std::vector<CertificateCell> certify_line(const NormalForm<RationalFunction>& form, int continuity,
                                          const Rational& lower, const Rational& upper,
                                          const Deadline& deadline, const CertificateOptions& options) {
  const Family family = continuity_family(form, continuity);
  const ExpandingLine line = expanding_line(family, lower, upper, deadline);
  constexpr int default_depth = 30;
  CellOptions cell_options;
  cell_options.vertices = options.vertices;
  const CellDecider decider(family, 1, {}, cell_options);
  std::vector<std::vector<CertificateCell>> gaps;
  for (const OpenGap& gap : line.gaps()) {
    gaps.push_back(gap_cells(gap, decider, options.depth.value_or(default_depth), deadline));
  }
  std::vector<CertificateCell> cells;
  for (ExpandingPart& part : line.parts()) cells.push_back(no_cell(std::move(part)));
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    const OpenGap& gap = line.gaps()[i];
    const Rational middle = rational_between(*gap.range.lower, *gap.range.upper);
    close_end(family, *gap.range.lower, gap.at_lower, middle, deadline, gaps[i]);
    close_end(family, *gap.range.upper, gap.at_upper, middle, deadline, gaps[i]);
    std::ranges::move(gaps[i], std::back_inserter(cells));
  }
  return merged_line(std::move(cells));
}

std::vector<CertificateCell> merged_line(std::vector<CertificateCell> cells) {
  std::ranges::stable_sort(cells, [](const CertificateCell& a, const CertificateCell& b) {
    const RealInterval& left = a.sides[0];
    const RealInterval& right = b.sides[0];
    return *left.lower == *right.lower ? *left.upper < *right.upper : *left.lower < *right.lower;
  });
  std::vector<CertificateCell> merged;
  for (CertificateCell& cell : cells) {
    if (!merged.empty() && merged.back().smooth == cell.smooth && merged.back().ground == cell.ground &&
        touch(merged.back().sides[0], cell.sides[0])) {
      join(merged.back(), cell);
    } else {
      merged.push_back(std::move(cell));
    }
  }
  return merged;
}

}  // namespace subdiv
