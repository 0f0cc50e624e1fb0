#include "analysis/jsr/candidate_products.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include <Eigen/Eigenvalues>

namespace subdiv {
namespace {

constexpr double same_radius = 1e-12;

/// The best few products met, each word once.
class Collection {
 public:
  explicit Collection(std::size_t wanted) : wanted_(wanted) {}

  void offer(const Word& word, double radius) {
    if (!(radius > 0) || (found_.size() >= 2 * wanted_ && radius < threshold_)) return;
    const Word root = primitive_rotation(word);
    if (!known_.insert(root).second) return;
    found_.push_back({root, radius});
    if (found_.size() >= 4 * wanted_) prune();
  }
  [[nodiscard]] double best() const {
    double best = 0;
    for (const CandidateProduct& c : found_) best = std::max(best, c.radius);
    return best;
  }
  [[nodiscard]] std::vector<CandidateProduct> result() {
    prune();
    return std::move(found_);
  }

 private:
  void prune() {
    std::sort(found_.begin(), found_.end(), [](const CandidateProduct& a, const CandidateProduct& b) {
      return a.radius != b.radius ? a.radius > b.radius : a.word < b.word;
    });
    // Radii that agree with their predecessor up to rounding belong together: there, the shorter words come
    // first.
    for (std::size_t first = 0; first < found_.size();) {
      std::size_t last = first + 1;
      while (last < found_.size() && found_[last].radius >= found_[first].radius * (1 - same_radius)) ++last;
      std::stable_sort(found_.begin() + static_cast<std::ptrdiff_t>(first),
                       found_.begin() + static_cast<std::ptrdiff_t>(last),
                       [](const CandidateProduct& a, const CandidateProduct& b) {
                         return a.word.size() != b.word.size() ? a.word.size() < b.word.size()
                                                               : a.word < b.word;
                       });
      first = last;
    }
    if (found_.size() > wanted_) found_.resize(wanted_);
    if (!found_.empty()) threshold_ = found_.back().radius;
  }

  std::size_t wanted_;
  std::vector<CandidateProduct> found_;
  std::set<Word> known_;
  double threshold_ = 0;
};

/// The length up to which there are about `words` Lyndon words: m^n / n of length n.
int exhaustive_length(std::size_t letters, int words) {
  if (letters < 2) return 1;
  double total = 0;
  for (int n = 1;; ++n) {
    total += std::pow(static_cast<double>(letters), n) / n;
    if (total > words) return std::max(2, n - 1);
  }
}

void try_lyndon_words(const std::vector<Eigen::MatrixXd>& family, int longest, const Deadline& deadline,
                      Collection& found) {
  const auto letters = static_cast<int>(family.size());
  // beginnings[i] is the product of the first i + 1 letters of the previous word.
  std::vector<Eigen::MatrixXd> beginnings;
  Word previous;
  for (Word word = next_lyndon_word({}, letters, longest); !word.empty();
       word = next_lyndon_word(std::move(word), letters, longest)) {
    std::size_t common = 0;
    while (common < word.size() && common < previous.size() && word[common] == previous[common]) ++common;
    beginnings.resize(common);
    for (std::size_t i = common; i < word.size(); ++i) {
      const Eigen::MatrixXd& t = family[static_cast<std::size_t>(word[i])];
      beginnings.push_back(i == 0 ? t : (t * beginnings[i - 1]).eval());
    }
    found.offer(word, root_radius(beginnings.back(), word.size()));
    if (deadline.passed()) return;
    previous = word;
  }
}

/// All words with one letter more, less, or another one.
std::vector<Word> neighbours(const Word& word, int letters) {
  std::vector<Word> result;
  for (std::size_t i = 0; i < word.size(); ++i) {
    const auto place = static_cast<std::ptrdiff_t>(i);
    if (word.size() > 1) {
      result.push_back(word);
      result.back().erase(result.back().begin() + place);
    }
    for (int letter = 0; letter < letters; ++letter) {
      result.push_back(word);
      result.back().insert(result.back().begin() + place, letter);
      if (letter == word[i]) continue;
      result.push_back(word);
      result.back()[i] = letter;
    }
  }
  return result;
}

struct Branch {
  Word word;
  Eigen::MatrixXd product;
  double norm;
};

void grow_words(const std::vector<Eigen::MatrixXd>& family, const CandidateSearch& search,
                const Deadline& deadline, Collection& found) {
  const Eigen::Index n = family[0].rows();
  const double scale = 1 / found.best();
  std::vector<Branch> level{{{}, Eigen::MatrixXd::Identity(n, n), 1}};
  for (int length = 1; length <= search.longest && !level.empty(); ++length) {
    std::vector<Branch> next;
    for (const Branch& branch : level) {
      for (std::size_t letter = 0; letter < family.size(); ++letter) {
        Branch longer{branch.word, family[letter] * branch.product * scale, 0};
        longer.word.push_back(static_cast<int>(letter));
        longer.norm = longer.product.norm();
        if (longer.norm > 1) next.push_back(std::move(longer));
      }
    }
    const auto kept = std::min(next.size(), static_cast<std::size_t>(search.beam));
    std::partial_sort(next.begin(), next.begin() + static_cast<std::ptrdiff_t>(kept), next.end(),
                      [](const Branch& a, const Branch& b) { return a.norm > b.norm; });
    next.resize(kept);
    for (const Branch& branch : next) {
      found.offer(branch.word, root_radius(branch.product, branch.word.size()) / scale);
      if (deadline.passed()) return;
    }
    level = std::move(next);
  }
}

}  // namespace

double approximate_radius(const Eigen::MatrixXd& matrix) {
  if (matrix.rows() == 1) return std::abs(matrix(0, 0));
  if (!matrix.allFinite()) return 0;
  return matrix.eigenvalues().cwiseAbs().maxCoeff();
}

double root_radius(const Eigen::MatrixXd& matrix, std::size_t order) {
  return std::pow(approximate_radius(matrix), 1.0 / static_cast<double>(order));
}

CandidateProduct locally_best(const std::vector<Eigen::MatrixXd>& family, const CandidateProduct& start,
                              const Deadline& deadline) {
  constexpr std::size_t longest = 160;
  constexpr double noticeable = 1e-10;  // above the rounding errors of long products
  const auto letters = static_cast<int>(family.size());
  CandidateProduct best = start;
  for (bool improved = true; improved;) {
    improved = false;
    const Word centre = best.word;
    for (const Word& word : neighbours(centre, letters)) {
      if (deadline.passed()) return best;
      const double radius = root_radius(product(family, word), word.size());
      if (!(radius > best.radius * (1 + noticeable))) continue;
      best = {primitive_rotation(word), radius};
      improved = best.word.size() < longest;
    }
  }
  return best;
}

std::vector<CandidateProduct> candidate_products(const std::vector<Eigen::MatrixXd>& family,
                                                 const Deadline& deadline, const CandidateSearch& search) {
  Collection found(static_cast<std::size_t>(search.wanted));
  try_lyndon_words(family, exhaustive_length(family.size(), search.words), deadline, found);
  if (found.best() > 0 && family.size() > 1) grow_words(family, search, deadline, found);
  return found.result();
}

}  // namespace subdiv
