#include "analysis/jsr/block_radius.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <utility>

#include "analysis/jsr/adapted_basis.h"
#include "analysis/jsr/balanced_scales.h"
#include "analysis/jsr/candidate_products.h"
#include "analysis/jsr/invariant_polytope.h"
#include "analysis/jsr/leading_vectors.h"
#include "analysis/jsr/single_matrix.h"

namespace subdiv {
namespace {

/// Words whose radius comes so close to the best one may have the same.
constexpr double tie = 1e-9;
constexpr std::size_t most_ties = 6;
/// Degree of a number field in which images on the boundary are worth an exact decision.
constexpr long largest_field = 8;
/// An attempt may take this share of the time left.
constexpr double share_of_an_attempt = 0.2;
/// Complex hulls cost far more per vertex, and those that close have few.
constexpr std::size_t most_complex_vertices = 160;
/// Larger blocks get only bounds from norms.
constexpr Eigen::Index largest_block = 48;
/// Vectors that span missing directions are this long, in adapted coordinates.
constexpr double small_vector = 1.0 / 64;

BlockRadius of_scalars(const MatrixFamily& family) {
  BlockRadius result;
  result.lower = Interval(0).with_precision(family.precision);
  for (const Matrix<Interval>& t : family.balls) result.lower = max(result.lower, abs(t(0, 0)));
  for (std::size_t i = 0; i < family.size(); ++i) {
    if (abs(family.balls[i](0, 0)).overlaps(result.lower)) result.words.push_back({static_cast<int>(i)});
  }
  result.upper = result.lower;
  result.closed = true;
  result.bounded = Decision::yes;
  result.vertices = 1;
  if (!family.exact.empty()) {
    Rational largest;
    for (const Matrix<Rational>& t : family.exact) largest = std::max(largest, abs(t(0, 0)));
    result.exact = Algebraic(largest);
  }
  return result;
}

/// A lower bound of the product's spectral radius^(1/length) from |tr P^k| <= n rho^k, k up to 2^squarings.
Interval trace_bound(const AdaptedFamily& family, const Word& word, int squarings) {
  BallMatrix power = family.balls[static_cast<std::size_t>(word[0])];
  for (std::size_t i = 1; i < word.size(); ++i) {
    power = multiply(family.balls[static_cast<std::size_t>(word[i])], power, family.precision);
  }
  Interval best = Interval(0).with_precision(family.precision);
  acb_t trace;
  acb_init(trace);
  for (int k = 0; k <= squarings; ++k) {
    acb_mat_trace(trace, power.raw(), family.precision);
    Interval bound = modulus(trace, family.precision) / Interval(power.rows());
    arb_root_ui(bound.raw(), bound.raw(), word.size() << k, family.precision);
    if (bound.is_finite() && bound.lower() > best.lower()) best = Interval(bound.lower(), family.precision);
    power = multiply(power, power, family.precision);
  }
  acb_clear(trace);
  return best;
}

/// One attempt after another on a family of dimension above 1.
class Search {
 public:
  Search(const MatrixFamily& family, std::size_t most_vertices, const Deadline& deadline, Wanted wanted)
      : family_(family),
        most_vertices_(most_vertices),
        deadline_(deadline),
        wanted_(wanted),
        adapted_(adapt(family, Eigen::MatrixXd::Identity(family.dimension(), family.dimension()))) {}

  BlockRadius run();

 private:
  void improve_upper_by_norms();
  bool norm_suffices();
  void improve_lower_by_letters();
  void choose_words();
  void start_from(const std::vector<Word>& words);
  [[nodiscard]] std::vector<Word> with_mirror_image(const Word& word) const;
  void close();
  Growth close_with_ties();
  Growth try_cycles(const std::vector<LeadingVector>& starts, const std::vector<Rational>& scales,
                    std::shared_ptr<const NumberField> field);
  [[nodiscard]] std::vector<std::vector<Rational>> scalings(const std::vector<LeadingVector>& starts) const;
  bool try_slack(double slack);
  Growth grow(InvariantPolytope& polytope, std::size_t most_vertices);
  bool improve_upper(InvariantPolytope& polytope);
  [[nodiscard]] std::shared_ptr<const NumberField> field_of(const std::vector<LeadingVector>& starts) const;
  [[nodiscard]] std::optional<Algebraic> exact_form() const;

  const MatrixFamily& family_;
  std::size_t most_vertices_;
  const Deadline& deadline_;
  Wanted wanted_;
  AdaptedFamily adapted_;
  std::vector<LeadingVector> starts_;
  Interval radius_;
  Word better_word_;
  bool seek_better_word_ = true;
  BlockRadius result_;
};

/// The operator norms for l_1, l_infinity and l_2.
void Search::improve_upper_by_norms() {
  using Norm = Interval (*)(const BallMatrix&, long);
  std::vector<Norm> norms{one_norm, infinity_norm};
  if (family_.dimension() <= largest_block) norms.push_back(euclidean_norm_bound);
  for (const Norm norm : norms) {
    Interval largest(0);
    for (const BallMatrix& t : adapted_.balls) largest = max(largest, norm(t, family_.precision));
    if (!result_.upper.is_finite() || largest.upper() < result_.upper.upper()) result_.upper = largest;
  }
}

/// A lower bound from single letters, for blocks too large for a search.
void Search::improve_lower_by_letters() {
  for (int letter = 0; letter < static_cast<int>(family_.size()) && !deadline_.passed(); ++letter) {
    constexpr int few = 4;
    const Interval bound = trace_bound(adapted_, {letter}, few);
    if (bound.lower() <= result_.lower.lower()) continue;
    result_.lower = bound;
    result_.words = {{letter}};
  }
}

/// Coordinates in which norms are near the radius, and the words with the largest radii.
void Search::choose_words() {
  constexpr double share = 0.2;
  const Deadline until(deadline_.left() * share);
  CandidateSearch quick;
  quick.words = 60;
  quick.longest = 0;
  quick.wanted = 1;
  const std::vector<CandidateProduct> first = candidate_products(adapted_.approximate, until, quick);
  if (first.empty()) return;
  improve_upper_by_norms();
  adapted_ = adapt(family_, adapted_basis(adapted_.approximate, first[0].radius));
  improve_upper_by_norms();
  std::vector<Word> words;
  double best = 0;
  const std::vector<CandidateProduct> candidates = candidate_products(adapted_.approximate, until);
  if (!candidates.empty()) {
    const CandidateProduct climbed = locally_best(adapted_.approximate, candidates[0], until);
    if (climbed.radius > candidates[0].radius * (1 + tie)) return start_from(with_mirror_image(climbed.word));
  }
  for (const CandidateProduct& c : candidates) {
    best = std::max(best, c.radius);
    if (c.radius >= best * (1 - tie) && words.size() < most_ties) words.push_back(c.word);
  }
  start_from(words);
}

/// Leading vectors of the words; the words of the largest radius, or all when no vector could be enclosed.
void Search::start_from(const std::vector<Word>& words) {
  starts_.clear();
  radius_ = Interval(0).with_precision(family_.precision);
  for (const Word& word : words) {
    for (LeadingVector& v : leading_vectors(family_, adapted_, word)) {
      radius_ = max(radius_, v.radius);
      starts_.push_back(std::move(v));
    }
  }
  // Words that only come close, often long ones, would have their vertices for nothing.
  std::erase_if(starts_, [&](const LeadingVector& v) { return certainly_less(v.radius, radius_); });
  result_.lower = radius_;
  result_.words.clear();
  for (const LeadingVector& start : starts_) {
    if (result_.words.empty() || result_.words.back() != start.word) result_.words.push_back(start.word);
  }
  if (!starts_.empty()) return;
  result_.words = words;
  constexpr int many = 7;
  for (const Word& word : words) result_.lower = max(result_.lower, trace_bound(adapted_, word, many));
  radius_ = result_.lower;
}

/// The word and, when it is another word of the same radius, its image under the letters' reversal: for the
/// matrices of a symmetric mask both lead.
std::vector<Word> Search::with_mirror_image(const Word& word) const {
  Word mirror = word;
  for (int& letter : mirror) letter = static_cast<int>(family_.size()) - 1 - letter;
  mirror = primitive_rotation(mirror);
  const double radius = approximate_radius(product(adapted_.approximate, word));
  const double other = approximate_radius(product(adapted_.approximate, mirror));
  const bool tied = mirror != word && std::abs(other - radius) <= tie * radius;
  return tied ? std::vector<Word>{word, mirror} : std::vector<Word>{word};
}

/// The largest radius in closed form: the others are certainly smaller than the ball.
std::optional<Algebraic> Search::exact_form() const {
  std::optional<Algebraic> result;
  for (const LeadingVector& start : starts_) {
    if (!start.radius.overlaps(radius_)) continue;
    std::optional<Algebraic> radius = exact_radius(family_, start);
    if (!radius) return std::nullopt;
    if (!result || *radius > *result) result = std::move(radius);
  }
  return result;
}

/// Q(radius), when its degree is moderate and all the given vectors have this very radius. One less by less
/// than the balls show would make exact vertices other than those in the balls.
std::shared_ptr<const NumberField> Search::field_of(const std::vector<LeadingVector>& starts) const {
  const std::optional<Algebraic> largest = starts.empty() ? std::nullopt : exact_form();
  if (!largest || largest->degree() > largest_field) return nullptr;
  const bool all_equal = std::all_of(starts.begin(), starts.end(), [&](const LeadingVector& start) {
    return start.is_real() && exact_radius(family_, start) == largest;
  });
  return all_equal ? std::make_shared<const NumberField>(*largest) : nullptr;
}

/// Grows until closed and spanning; directions that the images do not reach are added as small vectors.
Growth Search::grow(InvariantPolytope& polytope, std::size_t most_vertices) {
  const Deadline until(deadline_.left() * share_of_an_attempt);
  const Growth outcome = polytope.grow(most_vertices, until);
  if (outcome != Growth::closed) return outcome;
  const Eigen::MatrixXd missing = polytope.missing_directions();
  if (missing.cols() == 0) return outcome;
  for (Eigen::Index k = 0; k < missing.cols(); ++k) polytope.add_vector(small_vector * missing.col(k));
  return polytope.grow(most_vertices, until);
}

bool Search::improve_upper(InvariantPolytope& polytope) {
  const std::optional<PolytopeProof> proof = polytope.prove(deadline_);
  if (!proof) return false;
  if (proof->tight) {
    result_.lower = radius_;
    result_.upper = radius_;
    result_.closed = true;
    result_.bounded = Decision::yes;
    result_.vertices = polytope.size();
    result_.exact = exact_form();
    return true;
  }
  const Interval upper = radius_ * proof->bound;
  if (upper.upper() < result_.upper.upper()) {
    result_.upper = upper;
    result_.vertices = polytope.size();
  }
  return true;
}

/// Starts with the cycles of the given vectors times the scales.
Growth Search::try_cycles(const std::vector<LeadingVector>& starts, const std::vector<Rational>& scales,
                          std::shared_ptr<const NumberField> field) {
  const bool real =
      std::all_of(starts.begin(), starts.end(), [](const LeadingVector& v) { return v.is_real(); });
  InvariantPolytope polytope(family_, adapted_, {radius_, std::move(field), 0, !real, seek_better_word_});
  for (std::size_t i = 0; i < starts.size(); ++i) polytope.add_cycle(starts[i], scales[i]);
  const std::size_t most = real ? most_vertices_ : std::min(most_vertices_, most_complex_vertices);
  Growth outcome = grow(polytope, most);
  constexpr int most_repairs = 8;
  for (int repair = 0; repair < most_repairs && outcome == Growth::closed; ++repair) {
    if (!improve_upper(polytope) || result_.closed || !polytope.append_unproved()) break;
    outcome = grow(polytope, most);
  }
  if (outcome == Growth::better_word) better_word_ = polytope.better_word();
  return outcome;
}

bool Search::try_slack(double slack) {
  InvariantPolytope polytope(family_, adapted_, {radius_, nullptr, slack, false, false});
  for (const LeadingVector& start : starts_) {
    if (start.is_real()) {
      polytope.add_cycle(start, 1);
    } else {
      const Eigen::VectorXcd v = start.vector.midpoints();
      polytope.add_vector(v.real());
      polytope.add_vector(v.imag());
    }
  }
  if (starts_.empty()) {
    const Eigen::MatrixXd unit = Eigen::MatrixXd::Identity(adapted_.dimension(), adapted_.dimension());
    for (Eigen::Index k = 0; k < unit.cols(); ++k) polytope.add_vector(unit.col(k));
  }
  const bool closed = grow(polytope, most_vertices_) == Growth::closed;
  return improve_upper(polytope) && closed;
}

/// A norm that is no larger than the radius ends the search: all products are within it.
bool Search::norm_suffices() {
  if (!certainly_at_most(result_.upper, radius_)) return false;
  result_.upper = radius_;
  result_.closed = true;
  result_.bounded = Decision::yes;
  result_.exact = exact_form();
  return true;
}

/// Follows the words that seem better, as long as they are so for certain.
void Search::close() {
  constexpr int most_rounds = 8;
  for (int round = 0; round < most_rounds && !starts_.empty(); ++round) {
    if (close_with_ties() != Growth::better_word) break;
    const std::vector<LeadingVector> starts = starts_;
    const Interval radius = radius_;
    const std::vector<Word> words = result_.words;
    const CandidateProduct better{
        better_word_, root_radius(product(adapted_.approximate, better_word_), better_word_.size())};
    start_from(with_mirror_image(locally_best(adapted_.approximate, better, deadline_).word));
    if (!starts_.empty() && certainly_less(radius, radius_)) continue;
    starts_ = starts;
    radius_ = result_.lower = radius;
    result_.words = words;
    seek_better_word_ = false;
  }
  if (result_.closed || wanted_ == Wanted::closed_polytope) return;
  for (const double slack : {1e-1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-8, 1e-10}) {
    if (deadline_.passed() || !try_slack(slack)) return;
  }
}

/// The scales to try for several cycles. Cycles of equal lengths may meet in one vertex that ball arithmetic
/// cannot tell from two; of different lengths they do not.
std::vector<std::vector<Rational>> Search::scalings(const std::vector<LeadingVector>& starts) const {
  const std::size_t count = starts.size();
  std::vector<std::vector<Rational>> result{std::vector<Rational>(count, Rational(1))};
  if (count < 2) return result;
  std::vector<Rational> balanced = balanced_scales(adapted_, starts);
  if (balanced != result[0]) result.push_back(std::move(balanced));
  for (const Rational& ratio : {Rational(1023, 1024), Rational(15, 16)}) {
    result.emplace_back();
    for (std::size_t i = 0; i < count; ++i) result.back().push_back(pow(ratio, static_cast<long>(i)));
  }
  return result;
}

/// Real cycles alone may do, and are cheaper. With a rational radius, exact arithmetic settles images on the
/// boundary; otherwise they become vertices at first.
Growth Search::close_with_ties() {
  std::vector<LeadingVector> real;
  std::copy_if(starts_.begin(), starts_.end(), std::back_inserter(real),
               [](const LeadingVector& v) { return v.is_real(); });
  const std::shared_ptr<const NumberField> field = field_of(real);
  const auto settled = [&](Growth outcome) { return result_.closed || outcome == Growth::better_word; };
  Growth outcome = Growth::closed;
  const auto with_field = [&] {
    for (const std::vector<Rational>& scales : scalings(real)) {
      outcome = try_cycles(real, scales, field);
      if (settled(outcome)) break;
    }
    return settled(outcome);
  };
  if (field && field->modulus.degree() == 1 && with_field()) return outcome;
  std::vector<std::vector<LeadingVector>> choices;
  if (!real.empty() && real.size() < starts_.size()) choices.push_back(real);
  choices.push_back(starts_);
  for (const std::vector<LeadingVector>& starts : choices) {
    for (const std::vector<Rational>& scales : scalings(starts)) {
      outcome = try_cycles(starts, scales, nullptr);
      if (settled(outcome)) return outcome;
    }
  }
  if (field && field->modulus.degree() > 1) (void)with_field();
  return outcome;
}

BlockRadius Search::run() {
  arb_pos_inf(result_.upper.raw());
  result_.lower = Interval(0).with_precision(family_.precision);
  improve_upper_by_norms();
  if (family_.dimension() <= largest_block) {
    choose_words();
  } else {
    improve_lower_by_letters();
  }
  if (certainly_positive(radius_) && !norm_suffices()) close();
  return std::move(result_);
}

/// Of two matrices or more, or a closed form of one: only rational ones of moderate size have it.
BlockRadius of_matrices(const MatrixFamily& family, std::size_t most_vertices, const Deadline& deadline,
                        Wanted wanted) {
  if (family.size() > 1) return Search(family, most_vertices, deadline, wanted).run();
  constexpr Eigen::Index largest_exact = 20;
  BlockRadius result;
  if (!family.exact.empty() && family.dimension() <= largest_exact)
    result = Search(family, most_vertices, deadline, Wanted::closed_polytope).run();
  return result.closed ? result : single_matrix_radius(family);
}

}  // namespace

BlockRadius block_radius(const MatrixFamily& family, std::size_t most_vertices, const Deadline& deadline,
                         Wanted wanted) {
  if (family.dimension() == 1) return of_scalars(family);
  const ReducedFamily smaller = reduced(family);
  BlockRadius result = of_matrices(smaller.family, most_vertices, deadline, wanted);
  arb_mul_2exp_si(result.lower.raw(), result.lower.raw(), smaller.exponent);
  arb_mul_2exp_si(result.upper.raw(), result.upper.raw(), smaller.exponent);
  if (result.exact) result.exact = *result.exact * Algebraic(Rational::power_of_two(smaller.exponent));
  for (Word& word : result.words) {
    for (int& letter : word) letter = smaller.letters[static_cast<std::size_t>(letter)];
  }
  return result;
}

}  // namespace subdiv
