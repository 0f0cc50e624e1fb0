#include "analysis/expanding_line.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "analysis/sign_on_interval.h"
#include "schemes/algebra/univariate.h"

namespace subdiv {
namespace {

void add_word(std::vector<Word>& words, const Word& word) {
  if (std::ranges::find(words, word) == words.end()) words.push_back(word);
}

/// The distinct roots of g in the closed hull of a range, ascending; g is not zero.
std::vector<Algebraic> roots_within(const UnivariatePolynomial& g, const RealInterval& range) {
  const Rational low = range.lower->to_interval().lower();
  const Rational high = range.upper->to_interval().upper();
  std::vector<Algebraic> result;
  for (const auto& [base, multiplicity] : factor(g)) {
    if (count_roots(base, low, high) == 0) continue;
    for (RealRoot& root : real_roots(base)) {
      if (*range.lower <= root.value && root.value <= *range.upper) result.push_back(std::move(root.value));
    }
  }
  std::ranges::sort(result);
  return result;
}

/// One gap cut by the roots of g.
struct Cut {
  std::vector<ExpandingPart> parts;
  std::vector<OpenGap> gaps;
};

Cut cut(const OpenGap& gap, const UnivariatePolynomial& g, const Word& word) {
  if (g.is_zero()) return {{{gap.range, {word}}}, {}};
  const std::vector<Algebraic> roots = roots_within(g, gap.range);
  const auto is_root = [&](const Algebraic& x) { return std::ranges::find(roots, x) != roots.end(); };
  std::vector<Algebraic> points = roots;
  if (!is_root(*gap.range.lower)) points.insert(points.begin(), *gap.range.lower);
  if (!is_root(*gap.range.upper)) points.push_back(*gap.range.upper);
  Cut result;
  const auto words_at = [&](const Algebraic& end) {
    std::vector<Word> words;
    if (end == *gap.range.lower) words = gap.at_lower;
    if (end == *gap.range.upper) words = gap.at_upper;
    if (is_root(end)) add_word(words, word);
    return words;
  };
  for (const Algebraic& root : roots) {
    if (gap.range.contains(root)) result.parts.push_back({{root, root, true, true}, {word}});
  }
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Algebraic& low = points[i];
    const Algebraic& high = points[i + 1];
    if (g.evaluate(rational_between(low, high)).sign() < 0) {
      result.parts.push_back({{low, high, true, true}, {word}});
      continue;
    }
    const bool low_closed = gap.range.contains(low) && !is_root(low);
    const bool high_closed = gap.range.contains(high) && !is_root(high);
    result.gaps.push_back({{low, high, low_closed, high_closed}, words_at(low), words_at(high)});
  }
  return result;
}

}  // namespace

ExpandingLine::ExpandingLine(const Rational& lower, const Rational& upper) {
  if (!(lower < upper)) throw std::domain_error("a line of parameters needs two different ends");
  gaps_.push_back({closed_interval(lower, upper), {}, {}});
}

void ExpandingLine::add(const ExpandingCondition& condition) {
  const UnivariatePolynomial g(condition.g, 0);
  std::vector<OpenGap> gaps;
  for (const OpenGap& gap : gaps_) {
    Cut pieces = cut(gap, g, condition.word);
    std::ranges::move(pieces.parts, std::back_inserter(parts_));
    std::ranges::move(pieces.gaps, std::back_inserter(gaps));
  }
  gaps_ = std::move(gaps);
}

std::vector<ExpandingPart> ExpandingLine::parts() const {
  std::vector<ExpandingPart> sorted = parts_;
  std::ranges::stable_sort(
      sorted, [](const ExpandingPart& a, const ExpandingPart& b) { return *a.range.lower < *b.range.lower; });
  std::vector<ExpandingPart> merged;
  for (const ExpandingPart& part : sorted) {
    if (merged.empty() || *merged.back().range.upper < *part.range.lower) {
      merged.push_back(part);
      continue;
    }
    ExpandingPart& last = merged.back();
    if (*last.range.upper < *part.range.upper) last.range.upper = part.range.upper;
    for (const Word& word : part.words) add_word(last.words, word);
  }
  return merged;
}

}  // namespace subdiv
