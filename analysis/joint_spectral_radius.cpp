#include "analysis/joint_spectral_radius.h"

#include <algorithm>
#include <string>
#include <type_traits>
#include <utility>

#include "analysis/jsr/block_radius.h"
#include "analysis/jsr/block_triangular.h"

namespace subdiv {
namespace {

Enclosure enclosure(const JointSpectralRadius& radius, const Interval& lower, const Interval& upper,
                    const Deadline& deadline) {
  const std::string words = radius.words.empty() ? "" : ", word " + word_text(radius.words[0]);
  if (radius.exact) return exact(*radius.exact, "invariant polytope" + words);
  Enclosure result = certified(lower.lower(), upper.upper(), "invariant polytope" + words);
  if (result.lower.sign() < 0) result.lower = Rational(0);
  if (!radius.attained) result.status = deadline.passed() ? Status::out_of_time : Status::out_of_depth;
  return result;
}

/// The largest of the blocks' radii. It is attained when it is the radius of closed blocks alone.
JointSpectralRadius combine(const std::vector<BlockRadius>& blocks, const Deadline& deadline) {
  Interval lower = blocks[0].lower;
  Interval upper = blocks[0].upper;
  for (const BlockRadius& block : blocks) {
    if (block.lower.lower() > lower.lower()) lower = block.lower;
    if (block.upper.upper() > upper.upper()) upper = block.upper;
  }
  JointSpectralRadius result;
  result.attained = true;
  std::vector<const BlockRadius*> largest;
  for (const BlockRadius& block : blocks) {
    if (block.upper.upper() < lower.lower()) continue;
    largest.push_back(&block);
    result.attained = result.attained && block.closed;
    result.vertices += block.vertices;
    for (const Word& word : block.words) {
      if (std::find(result.words.begin(), result.words.end(), word) == result.words.end()) {
        result.words.push_back(word);
      }
    }
  }
  if (result.attained) {
    result.exact = largest[0]->exact;
    for (const BlockRadius* block : largest) {
      if (!block->exact || !result.exact) {
        result.exact = std::nullopt;
        break;
      }
      result.exact = std::max(*result.exact, *block->exact);
    }
  }
  if (largest.size() == 1) result.bounded = largest[0]->bounded;
  result.value = enclosure(result, lower, upper, deadline);
  return result;
}

/// Enclosures at the given precision. An exact zero stays one.
Matrix<Interval> enclose(const Matrix<Algebraic>& matrix, long precision) {
  Matrix<Interval> result(matrix.rows(), matrix.cols());
  for (Eigen::Index i = 0; i < matrix.size(); ++i) {
    const Algebraic& x = matrix.data()[i];
    result.data()[i] = x.is_zero() ? Interval(0) : x.to_interval(precision);
  }
  return result;
}

template <class R>
MatrixFamily family_of(const std::vector<Matrix<R>>& matrices, long precision) {
  if constexpr (std::is_same_v<R, Algebraic>) {
    std::vector<Matrix<Interval>> balls;
    for (const Matrix<Algebraic>& t : matrices) balls.push_back(enclose(t, precision));
    return matrix_family(std::move(balls), precision);
  } else {
    return matrix_family(matrices, precision);
  }
}

/// A 1 x 1 block of algebraic numbers has a closed form.
void add_closed_form(const std::vector<Matrix<Algebraic>>& block, BlockRadius& radius) {
  if (block[0].rows() != 1) return;
  Algebraic largest;
  for (const Matrix<Algebraic>& t : block) largest = std::max(largest, abs(t(0, 0)));
  radius.exact = largest;
}

template <class R>
JointSpectralRadius radius_of(const std::vector<Matrix<R>>& matrices,
                              const JointSpectralRadiusBudget& budget) {
  const Deadline deadline(budget.seconds);
  (void)family_of(matrices, budget.precision);  // checks its argument
  std::vector<BlockRadius> blocks;
  std::vector<int> dimensions;
  for (const std::vector<Matrix<R>>& block : diagonal_blocks(matrices)) {
    const MatrixFamily family = family_of(block, budget.precision);
    dimensions.push_back(static_cast<int>(family.dimension()));
    blocks.push_back(block_radius(family, budget.vertices, deadline));
    if constexpr (std::is_same_v<R, Algebraic>) add_closed_form(block, blocks.back());
  }
  JointSpectralRadius result = combine(blocks, deadline);
  result.blocks = std::move(dimensions);
  return result;
}

}  // namespace

JointSpectralRadius joint_spectral_radius(const std::vector<Matrix<Rational>>& family,
                                          const JointSpectralRadiusBudget& budget) {
  return radius_of(family, budget);
}

JointSpectralRadius joint_spectral_radius(const std::vector<Matrix<Interval>>& family,
                                          const JointSpectralRadiusBudget& budget) {
  return radius_of(family, budget);
}

JointSpectralRadius joint_spectral_radius(const std::vector<Matrix<Algebraic>>& family,
                                          const JointSpectralRadiusBudget& budget) {
  return radius_of(family, budget);
}

}  // namespace subdiv
