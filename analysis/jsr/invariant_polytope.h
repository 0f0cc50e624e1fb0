#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "analysis/deadline.h"
#include "analysis/jsr/hull_bound.h"
#include "analysis/jsr/hull_gauge.h"
#include "analysis/jsr/leading_vectors.h"
#include "analysis/jsr/matrix_family.h"
#include "analysis/jsr/number_field.h"
#include "analysis/jsr/word.h"

namespace subdiv {

/// What a polytope is grown for.
struct PolytopeGoal {
  Interval radius;  ///< of the words it starts with: the largest of theirs
  /// Q(radius) for a rational family, when all starting words have this very radius: then images on the
  /// boundary are decided in exact arithmetic. Without it they become vertices.
  std::shared_ptr<const NumberField> field{};
  double slack = 0;              ///< growth aims at radius (1 + slack); at 0 it may prove the radius
  bool complex_hull = false;     ///< whether vertices may be complex, with their conjugates
  bool seek_better_word = true;  ///< growth ends when a product seems to have a larger radius
};

/// How the growth ended: no image is left outside, a budget ran out, or a product has a larger radius.
enum class Growth { closed, too_many_vertices, out_of_time, better_word };

/// What is proved: T_i v lies in bound * radius * hull for all i and all vertices v, which span the space.
/// Then the joint spectral radius is at most bound * radius.
struct PolytopeProof {
  Interval bound;      ///< its upper end counts
  bool tight = false;  ///< the bound is 1: all products T_w / radius^|w| are bounded
};

/// The balanced hull of vertices grown from leading eigenvectors by the matrices of a family (Guglielmi &
/// Protasov, Found. Comput. Math. 13, 2013; Mejstrik, ACM TOMS 46, 2020). The growth is steered by floating
/// point. The proof is not: vertices are balls around exactly defined vectors, and every image is written as
/// a combination of vertices that is valid for all vectors in the balls, or exactly for rational data.
///
/// Without slack, images that are multiples of a vertex by definition need no combination: the cycle of a
/// word w with radius r, v, T_{w_1} v / r, T_{w_2} T_{w_1} v / r^2, ..; and every vertex that is defined as
/// T_i v / radius of an earlier one. With slack, vertices are the doubles themselves, all images are checked,
/// and the proof holds for all matrices in wide balls.
class InvariantPolytope {
 public:
  /// Without vertices yet.
  InvariantPolytope(const MatrixFamily& family, const AdaptedFamily& adapted, PolytopeGoal goal);

  /// The cycle of a leading vector whose radius is at most the goal's, times scale.
  void add_cycle(const LeadingVector& start, const Rational& scale);
  /// A vector of doubles in adapted coordinates: to span what the cycles do not reach.
  void add_vector(const Eigen::VectorXd& vector);

  /// Adds images that lie outside until there are none.
  Growth grow(std::size_t most_vertices, const Deadline& deadline);
  /// The product that showed a larger radius during the growth (Growth::better_word).
  [[nodiscard]] const Word& better_word() const { return better_word_; }

  /// Nothing when the vertices are not proved to span the space, or time runs out.
  [[nodiscard]] std::optional<PolytopeProof> prove(const Deadline& deadline);

  /// Makes vertices of the images that the last proof found not certainly inside, other than those that
  /// coincide with a vertex, and says whether there were any: floating point may have taken them for points
  /// inside.
  bool append_unproved();

  [[nodiscard]] std::size_t size() const { return vertices_.size(); }
  /// The vertices in floating point and adapted coordinates, one a column.
  [[nodiscard]] Eigen::MatrixXcd points() const;
  /// Orthonormal vectors that complete the span of the vertices, judged in floating point.
  [[nodiscard]] Eigen::MatrixXd missing_directions() const;

 private:
  struct Vertex {
    Eigen::VectorXcd point;
    std::optional<std::size_t> parent;  // the vertex is the image of this one under `letter`
    std::size_t letter = 0;
    Word path{};                  // letters since the start, or since the cycle
    Eigen::MatrixXd product{};    // their product over (radius (1 + slack))^length
    std::vector<bool> settled{};  // by letter: the image is a vertex by definition
  };
  struct Image {
    std::size_t vertex;
    std::size_t letter;
    Eigen::VectorXcd point;
  };

  Vertex& append(BallMatrix ball);
  void append_image(const Image& image);
  [[nodiscard]] std::vector<Image> open_images(std::size_t first, std::size_t last) const;
  [[nodiscard]] bool is_new_vertex(const Image& image);
  bool shows_better_word(const Vertex& vertex);
  [[nodiscard]] bool coincides_with_vertex(const Image& image) const;
  [[nodiscard]] Interval image_bound(const Image& image, const std::vector<HullColumn>& spanning);
  [[nodiscard]] bool is_exactly_inside(const Image& image, const std::vector<HullColumn>& basis);
  bool compute_exact_vertices();

  const MatrixFamily& family_;
  const AdaptedFamily& adapted_;
  PolytopeGoal goal_;
  Interval step_;  // radius (1 + slack)
  HullGauge gauge_;
  std::vector<BallMatrix> balls_;
  std::vector<Vertex> vertices_;
  std::vector<std::optional<Vector<FieldElement>>> roots_;  // exact vertices that have no parent
  std::vector<Vector<FieldElement>> exact_;                 // all of them, once asked for
  std::vector<Image> unproved_;
  std::size_t explored_ = 0;
  Word better_word_;
};

}  // namespace subdiv
