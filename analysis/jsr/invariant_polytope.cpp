#include "analysis/jsr/invariant_polytope.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

#include <Eigen/QR>

#include "analysis/jsr/candidate_products.h"

namespace subdiv {
namespace {

/// Images with a gauge within this of 1 count as lying on the boundary.
constexpr double boundary = 1e-9;
/// A product met on the way is better when its radius exceeds the goal's by this share.
constexpr double better = 1e-11;

/// Whether a phase times a, the phase taken from the largest entry, overlaps b.
bool overlap_up_to_phase(const BallMatrix& a, const BallMatrix& b, long precision) {
  Eigen::Index largest = 0;
  a.midpoints().col(0).cwiseAbs().maxCoeff(&largest);
  acb_t ratio;
  acb_init(ratio);
  acb_div(ratio, b.at(largest, 0), a.at(largest, 0), precision);
  const bool unimodular = modulus(ratio, precision).contains(Rational(1));
  BallMatrix turned(a.rows(), 1);
  for (long i = 0; i < a.rows(); ++i) acb_mul(turned.at(i, 0), a.at(i, 0), ratio, precision);
  acb_clear(ratio);
  return unimodular && acb_mat_overlaps(turned.raw(), b.raw()) != 0;
}

/// scale T v.
Vector<FieldElement> image_of(const Matrix<Rational>& t, const Vector<FieldElement>& v,
                              const FieldElement& scale) {
  Vector<FieldElement> result = Vector<FieldElement>::Constant(v.size(), FieldElement(0));
  for (Eigen::Index i = 0; i < t.rows(); ++i) {
    for (Eigen::Index j = 0; j < t.cols(); ++j) {
      if (!is_zero(t(i, j))) result(i) += FieldElement(t(i, j)) * v(j);
    }
    result(i) *= scale;
  }
  return result;
}

Interval with_slack(const Interval& radius, double slack) { return radius * (Interval(1) + Interval(slack)); }

}  // namespace

InvariantPolytope::InvariantPolytope(const MatrixFamily& family, const AdaptedFamily& adapted,
                                     PolytopeGoal goal)
    : family_(family),
      adapted_(adapted),
      goal_(std::move(goal)),
      step_(with_slack(goal_.radius, goal_.slack)),
      gauge_(adapted.dimension(), goal_.complex_hull) {}

InvariantPolytope::Vertex& InvariantPolytope::append(BallMatrix ball) {
  Vertex vertex{ball.midpoints(), std::nullopt};
  if (goal_.slack > 0) ball = BallMatrix(Eigen::MatrixXcd(vertex.point));
  vertex.settled.assign(family_.size(), false);
  gauge_.add(vertex.point);
  balls_.push_back(std::move(ball));
  vertices_.push_back(std::move(vertex));
  roots_.emplace_back();
  return vertices_.back();
}

void InvariantPolytope::add_cycle(const LeadingVector& start, const Rational& scale) {
  BallMatrix ball = start.vector;
  acb_mat_scalar_mul_arb(ball.raw(), ball.raw(), Interval(scale, family_.precision).raw(), family_.precision);
  const std::size_t first = vertices_.size();
  for (std::size_t k = 0; k < start.word.size(); ++k) {
    const auto letter = static_cast<std::size_t>(start.word[k]);
    Vertex& vertex = append(ball);
    vertex.product = Eigen::MatrixXd::Identity(adapted_.dimension(), adapted_.dimension());
    vertex.settled[letter] = goal_.slack == 0;
    if (k > 0) {
      vertex.parent = first + k - 1;
      vertex.letter = static_cast<std::size_t>(start.word[k - 1]);
    }
    ball = divide(multiply(adapted_.balls[letter], ball, family_.precision), start.radius);
  }
  if (!goal_.field) return;
  roots_[first] = exact_vector(family_, start, goal_.field);
  if (!roots_[first]) return;
  for (FieldElement& x : roots_[first]->reshaped()) x *= FieldElement(scale);
}

void InvariantPolytope::add_vector(const Eigen::VectorXd& vector) {
  const Eigen::Index n = adapted_.dimension();
  append(BallMatrix(Eigen::MatrixXcd(vector.cast<std::complex<double>>()))).product =
      Eigen::MatrixXd::Identity(n, n);
  if (!goal_.field) return;
  Vector<FieldElement> own = Vector<FieldElement>::Constant(n, FieldElement(0));
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) {
      own(i) += FieldElement(Rational::from_double(adapted_.basis(i, j)) * Rational::from_double(vector(j)));
    }
  }
  roots_.back() = std::move(own);
}

void InvariantPolytope::append_image(const Image& image) {
  const BallMatrix ball = multiply(adapted_.balls[image.letter], balls_[image.vertex], family_.precision);
  Vertex& vertex = append(divide(ball, step_));
  Vertex& parent = vertices_[image.vertex];
  parent.settled[image.letter] = goal_.slack == 0;
  vertex.parent = image.vertex;
  vertex.letter = image.letter;
  vertex.path = parent.path;
  vertex.path.push_back(static_cast<int>(image.letter));
  vertex.product = adapted_.approximate[image.letter] * parent.product / step_.to_double();
}

std::vector<InvariantPolytope::Image> InvariantPolytope::open_images(std::size_t first,
                                                                     std::size_t last) const {
  std::vector<Image> result;
  for (std::size_t j = first; j < last; ++j) {
    for (std::size_t i = 0; i < family_.size(); ++i) {
      if (vertices_[j].settled[i]) continue;
      result.push_back({j, i, adapted_.approximate[i] * vertices_[j].point / step_.to_double()});
    }
  }
  std::stable_sort(result.begin(), result.end(),
                   [](const Image& a, const Image& b) { return a.point.norm() > b.point.norm(); });
  return result;
}

/// Whether some vertex times a phase (a sign, in a real hull) has the ball of the image: two balls of one
/// vector, as good as certainly.
bool InvariantPolytope::coincides_with_vertex(const Image& image) const {
  const BallMatrix x =
      divide(multiply(adapted_.balls[image.letter], balls_[image.vertex], family_.precision), step_);
  for (std::size_t j = 0; j < vertices_.size(); ++j) {
    const std::complex<double> inner = vertices_[j].point.dot(image.point);
    if (!(std::abs(inner) >= (1 - boundary) * vertices_[j].point.norm() * image.point.norm())) continue;
    if (overlap_up_to_phase(balls_[j], x, family_.precision)) return true;
  }
  return false;
}

bool InvariantPolytope::is_new_vertex(const Image& image) {
  const double gauge = gauge_.combine(image.point, 1 - boundary).sum;
  if (gauge <= 1 - boundary) return false;
  if (gauge > 1 + boundary) return true;
  // On the boundary: exact arithmetic may show that it lies inside; a vertex of its own is inside by
  // definition, but the same vertex twice would never end.
  if (goal_.field) return false;
  return goal_.slack == 0 && !coincides_with_vertex(image);
}

bool InvariantPolytope::shows_better_word(const Vertex& vertex) {
  const double radius =
      std::pow(approximate_radius(vertex.product), 1.0 / static_cast<double>(vertex.path.size()));
  if (!(radius > 1 + better)) return false;
  better_word_ = primitive_rotation(vertex.path);
  return true;
}

Growth InvariantPolytope::grow(std::size_t most_vertices, const Deadline& deadline) {
  while (explored_ < vertices_.size()) {
    const std::size_t last = vertices_.size();
    gauge_.condition();
    for (const Image& image : open_images(explored_, last)) {
      if (deadline.passed()) return Growth::out_of_time;
      if (!is_new_vertex(image)) continue;
      if (vertices_.size() >= most_vertices) return Growth::too_many_vertices;
      append_image(image);
      if (goal_.seek_better_word && shows_better_word(vertices_.back())) return Growth::better_word;
    }
    explored_ = last;
  }
  return Growth::closed;
}

Interval InvariantPolytope::image_bound(const Image& image, const std::vector<HullColumn>& spanning) {
  const BallMatrix x =
      divide(multiply(adapted_.balls[image.letter], balls_[image.vertex], family_.precision), goal_.radius);
  const HullCombination proposal = gauge_.combine(x.midpoints());
  const std::vector<HullColumn> basis = basis_near(proposal, balls_, spanning);
  const Interval bound = gauge_bound(x, balls_, proposal, basis, spanning, family_.precision);
  const bool inside = certainly_at_most(bound, Interval(1)) || is_exactly_inside(image, basis);
  return inside ? Interval(1) : bound;
}

/// The vertices over Q(radius), in the family's own coordinates.
bool InvariantPolytope::compute_exact_vertices() {
  const FieldElement inverse = FieldElement(1) / FieldElement::generator(goal_.field);
  for (std::size_t j = exact_.size(); j < vertices_.size(); ++j) {
    const Vertex& vertex = vertices_[j];
    if (!vertex.parent) {
      if (!roots_[j]) return false;
      exact_.push_back(*roots_[j]);
    } else {
      exact_.push_back(image_of(family_.exact[vertex.letter], exact_[*vertex.parent], inverse));
    }
  }
  return true;
}

bool InvariantPolytope::is_exactly_inside(const Image& image, const std::vector<HullColumn>& basis) {
  if (!goal_.field || goal_.slack != 0 || !compute_exact_vertices()) return false;
  std::vector<Vector<FieldElement>> columns;
  for (const HullColumn& column : basis) columns.push_back(exact_[static_cast<std::size_t>(column.vertex)]);
  const FieldElement inverse = FieldElement(1) / FieldElement::generator(goal_.field);
  return subdiv::is_exactly_inside(image_of(family_.exact[image.letter], exact_[image.vertex], inverse),
                                   columns);
}

std::optional<PolytopeProof> InvariantPolytope::prove(const Deadline& deadline) {
  unproved_.clear();
  const auto spanning = spanning_columns(balls_, goal_.complex_hull, family_.precision);
  if (!spanning) return std::nullopt;
  gauge_.condition();
  // Images that are vertices by definition have the bound 1.
  Interval bound = Interval(1).with_precision(family_.precision);
  for (const Image& image : open_images(0, vertices_.size())) {
    if (deadline.passed()) return std::nullopt;
    const Interval at_image = image_bound(image, *spanning);
    if (!at_image.is_finite()) return std::nullopt;
    if (!certainly_at_most(at_image, Interval(1))) unproved_.push_back(image);
    bound = max(bound, at_image);
  }
  return PolytopeProof{bound, certainly_at_most(bound, Interval(1))};
}

bool InvariantPolytope::append_unproved() {
  const std::size_t before = vertices_.size();
  for (const Image& image : unproved_) {
    if (!coincides_with_vertex(image)) append_image(image);
  }
  unproved_.clear();
  return vertices_.size() > before;
}

Eigen::MatrixXcd InvariantPolytope::points() const {
  Eigen::MatrixXcd result(adapted_.dimension(), static_cast<Eigen::Index>(vertices_.size()));
  for (std::size_t j = 0; j < vertices_.size(); ++j)
    result.col(static_cast<Eigen::Index>(j)) = vertices_[j].point;
  return result;
}

Eigen::MatrixXd InvariantPolytope::missing_directions() const {
  const Eigen::MatrixXcd all = points();
  Eigen::MatrixXd real(all.rows(), 2 * all.cols());
  real << all.real(), all.imag();
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(real);
  qr.setThreshold(boundary);
  const Eigen::MatrixXd q = qr.householderQ();
  return q.rightCols(all.rows() - qr.rank());
}

}  // namespace subdiv
