#include "experiments/certificates/prove.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "experiments/certificates/find_cover.h"
#include "optimize/linear_program.h"
#include "schemes/algebra/matrix.h"

namespace subdiv {
namespace {

using verifier::Context;
using verifier::list;
using verifier::number;
using verifier::Question;
using verifier::Quotient;
using verifier::Rejected;
using verifier::scalar;
using verifier::Value;

std::string text(const std::vector<Rational>& row) {
  std::string result = "[";
  for (const Rational& x : row) result += (result.size() > 1 ? ", " : "") + x.to_string();
  return result + "]";
}

std::string text(const std::vector<std::vector<Rational>>& rows) {
  std::string result = "[";
  for (const auto& row : rows) result += (result.size() > 1 ? ", " : "") + text(row);
  return result + "]";
}

Matrix<Rational> rational_matrix(const Value& value) {
  const auto rows = static_cast<Eigen::Index>(list(value).size());
  Matrix<Rational> result(rows, static_cast<Eigen::Index>(list(value.items().at(0)).size()));
  for (Eigen::Index i = 0; i < rows; ++i) {
    for (Eigen::Index j = 0; j < result.cols(); ++j) {
      result(i, j) =
          number(scalar(value.items()[static_cast<std::size_t>(i)].items().at(static_cast<std::size_t>(j))));
    }
  }
  return result;
}

std::vector<Rational> column(const Vector<Rational>& v) { return {v.data(), v.data() + v.size()}; }

/// Weights y with A^T y = 0 that prove the least norm of affine entries: the dual of the linear program.
std::string find_dual(const Question& question) {
  const bool is_max = number(scalar(question.values[0])).sign() != 0;
  const auto& items = list(question.values[1]);
  const auto& variables = list(question.values[2]);
  const auto n = static_cast<Eigen::Index>(items.size());
  const auto free = static_cast<Eigen::Index>(variables.size());
  const Eigen::Index heights = is_max ? 1 : n;  // t, or a t for each entry
  LinearProgram program{zero_matrix<Rational>(2 * n, free + heights),
                        Vector<Rational>::Constant(2 * n, Rational(0)),
                        Vector<Rational>::Constant(free + heights, Rational(0))};
  for (Eigen::Index k = free; k < free + heights; ++k) program.c(k) = Rational(-1);
  for (Eigen::Index i = 0; i < n; ++i) {
    Quotient constant = scalar(items[static_cast<std::size_t>(i)]);
    for (Eigen::Index j = 0; j < free; ++j) {
      const std::string& x = scalar(variables[static_cast<std::size_t>(j)]).above.begin()->first.at(0).first;
      const Rational slope = number(verifier::derivative(constant, x));
      program.a(2 * i, j) = -slope;
      program.a(2 * i + 1, j) = slope;
      constant = verifier::substitute(constant, x, Quotient());
    }
    program.b(2 * i) = -number(constant);
    program.b(2 * i + 1) = number(constant);
    const Eigen::Index height = free + (is_max ? 0 : i);
    program.a(2 * i, height) = program.a(2 * i + 1, height) = Rational(1);
  }
  const LinearSolution solution = solve(program);
  if (solution.status != LinearSolution::Status::optimal) throw Rejected("the linear program has no optimum");
  std::vector<Rational> dual;
  for (Eigen::Index i = 0; i < n; ++i) dual.push_back(solution.y(2 * i) - solution.y(2 * i + 1));
  return text(dual);
}

/// A word, an invariant space and the block of its product whose eigenvalues reach the bound: an eigenvector
/// of a product with the eigenvalue +-bound^length, over Q.
std::map<std::string, std::string> find_product(const Value& family, const Value& bound) {
  const Rational radius = number(scalar(bound));
  std::vector<Matrix<Rational>> matrices;
  for (const Value& m : family.items()) matrices.push_back(rational_matrix(m));
  std::deque<std::pair<std::vector<Rational>, Matrix<Rational>>> words;
  for (std::size_t k = 0; k < matrices.size(); ++k) {
    words.emplace_back(std::vector<Rational>{Rational(static_cast<std::int64_t>(k))}, matrices[k]);
  }
  constexpr std::size_t longest = 8;
  while (!words.empty()) {
    const auto [word, product] = words.front();
    words.pop_front();
    for (const int sign : {1, -1}) {
      const Rational eigenvalue = Rational(sign) * pow(radius, static_cast<long>(word.size()));
      Matrix<Rational> shifted = product;
      for (Eigen::Index i = 0; i < shifted.rows(); ++i) shifted(i, i) -= eigenvalue;
      const auto space = null_space(shifted);
      if (space.empty()) continue;
      std::vector<std::vector<Rational>> rows;
      for (const Rational& x : column(space[0])) rows.push_back({x});
      return {{"word", text(word)}, {"space", text(rows)}, {"block", "[[" + eigenvalue.to_string() + "]]"}};
    }
    if (word.size() == longest) continue;
    for (std::size_t k = 0; k < matrices.size(); ++k) {
      auto longer = word;
      longer.emplace_back(static_cast<std::int64_t>(k));
      words.emplace_back(std::move(longer), Matrix<Rational>(product * matrices[k]));
    }
  }
  throw Rejected("no product was found that reaches the bound");
}

/// Weights with the least sum of absolute values that combine the vertices to a point, and that sum.
std::optional<std::pair<Rational, std::vector<Rational>>> gauge(
    const std::vector<std::vector<Rational>>& vertices, const std::vector<Rational>& point) {
  const auto n = static_cast<Eigen::Index>(vertices.size());
  const auto rows = static_cast<Eigen::Index>(point.size());
  // Unknowns p, q >= 0 with sum of (p_k - q_k) v_k = point; maximise -sum of all.
  LinearProgram program{zero_matrix<Rational>(2 * rows + 2 * n, 2 * n),
                        Vector<Rational>::Constant(2 * rows + 2 * n, Rational(0)),
                        Vector<Rational>::Constant(2 * n, Rational(-1))};
  for (Eigen::Index i = 0; i < rows; ++i) {
    const auto at = static_cast<std::size_t>(i);
    for (Eigen::Index k = 0; k < n; ++k) {
      const Rational& x = vertices[static_cast<std::size_t>(k)][at];
      program.a(2 * i, k) = program.a(2 * i + 1, n + k) = x;
      program.a(2 * i, n + k) = program.a(2 * i + 1, k) = -x;
    }
    program.b(2 * i) = -point[at];
    program.b(2 * i + 1) = point[at];
  }
  for (Eigen::Index k = 0; k < 2 * n; ++k) program.a(2 * rows + k, k) = Rational(1);
  const LinearSolution solution = solve(program);
  if (solution.status != LinearSolution::Status::optimal) return std::nullopt;
  std::vector<Rational> weights;
  for (Eigen::Index k = 0; k < n; ++k) weights.push_back(solution.x(k) - solution.x(n + k));
  return std::pair{-solution.value, std::move(weights)};
}

/// A polytope for rational matrices: grown from the eigenvector of a product that reaches the bound, where
/// there is one, and unit vectors made small enough; images outside become vertices.
std::map<std::string, std::string> find_polytope(const Value& family, const Value& bound) {
  const Rational radius = number(scalar(bound));
  std::vector<Matrix<Rational>> matrices;
  for (const Value& m : family.items()) matrices.push_back(rational_matrix(m));
  const Eigen::Index n = matrices.at(0).rows();
  std::vector<std::vector<Rational>> vertices;
  for (const auto& m : matrices) {
    Matrix<Rational> shifted = m;
    for (Eigen::Index i = 0; i < n; ++i) shifted(i, i) -= radius;
    for (const auto& v : null_space(shifted)) vertices.push_back(column(v));
  }
  for (Eigen::Index i = 0; i < n; ++i) {
    std::vector<Rational> unit(static_cast<std::size_t>(n));
    unit[static_cast<std::size_t>(i)] = Rational(1, vertices.empty() ? 1 : 16);
    vertices.push_back(std::move(unit));
  }
  constexpr std::size_t most = 40;
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    for (const auto& m : matrices) {
      Vector<Rational> v(n);
      for (Eigen::Index i = 0; i < n; ++i) v(i) = vertices[k][static_cast<std::size_t>(i)] / radius;
      std::vector<Rational> image = column(Vector<Rational>(m * v));
      const auto inside = gauge(vertices, image);
      if (inside && inside->first <= Rational(1)) continue;
      if (vertices.size() == most) throw Rejected("no polytope was found");
      vertices.push_back(std::move(image));
    }
  }
  std::vector<std::vector<Rational>> images;
  for (const auto& m : matrices) {
    for (const auto& vertex : vertices) {
      Vector<Rational> v(n);
      for (Eigen::Index i = 0; i < n; ++i) v(i) = vertex[static_cast<std::size_t>(i)];
      images.push_back(gauge(vertices, column(Vector<Rational>(m * v)))->second);
    }
  }
  std::vector<Rational> span;
  for (Eigen::Index i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < vertices.size(); ++k) {
      const auto& v = vertices[k];
      const bool is_unit =
          v[static_cast<std::size_t>(i)].sign() != 0 &&
          std::count_if(v.begin(), v.end(), [](const Rational& x) { return x.sign() != 0; }) == 1;
      if (!is_unit) continue;
      span.emplace_back(static_cast<std::int64_t>(k));
      break;
    }
  }
  return {{"vertices", text(vertices)}, {"images", text(images)}, {"span", text(span)}};
}

class Prover {
 public:
  Prover(const Statement& statement, Context& context)
      : given_(statement.proof.begin(), statement.proof.end()), context_(context) {}

  std::string answer(const Question& question) {
    std::string found = find(question);
    proof_.push_back(question.word + " " + found);
    return found;
  }
  [[nodiscard]] const std::vector<std::string>& proof() const { return proof_; }

 private:
  std::string find(const Question& question) {
    const std::string& word = question.word;
    if (word == "cover") return find_cover(*question.cover, *question.cell);
    if (!given_.empty() && given_.front().starts_with(word + " ")) {
      std::string rest = given_.front().substr(word.size() + 1);
      given_.pop_front();
      return rest;
    }
    if (word == "dual") return find_dual(question);
    if (word == "vertices") found_ = find_polytope(question.values[0], question.values[1]);
    if (word == "word") found_ = find_product(question.values[0], question.values[1]);
    if (word == "near") found_ = find_minimum(question);
    const auto known = found_.find(word);
    if (known == found_.end()) throw Rejected("no witness '" + word + "' was found");
    return known->second;
  }

  /// A rational near the value of a quotient, with all roots halved down to 2^-100 of their ranges.
  [[nodiscard]] Rational approximate(Quotient q) const {
    for (const auto& [x, equation] : context_.roots) {
      const auto sign_at = [&](const Rational& at) {
        Rational sum(0);
        for (const auto& [n, c] : equation) sum += c * pow(at, n);
        return sum.sign();
      };
      Rational lower = context_.ranges.at(x).lower;
      Rational upper = *context_.ranges.at(x).upper;
      const int sign = sign_at(lower);
      constexpr int halvings = 100;
      for (int k = 0; k < halvings; ++k) {
        const Rational middle = (lower + upper) / Rational(2);
        (sign_at(middle) == sign ? lower : upper) = middle;
      }
      q = verifier::substitute(q, x, Quotient(lower));
    }
    return number(q);
  }

  /// Ends around the place of a minimum, with the entries that fall to it and rise from it.
  std::map<std::string, std::string> find_minimum(const Question& question) {
    const auto& items = list(question.values[0]);
    const Rational bound = approximate(scalar(question.values[1]));
    const Rational place = approximate(scalar(question.values[2]));
    const verifier::Range range = context_.ranges.at(question.name);
    std::string falling;
    std::string rising;
    Rational steepest_fall(0);
    Rational steepest_rise(0);
    for (std::size_t i = 0; i < items.size(); ++i) {
      const Quotient& entry = scalar(items[i]);
      const Rational there = approximate(verifier::substitute(entry, question.name, place));
      if (abs(abs(there) - bound) > Rational(1, 1000000000) * (bound + Rational(1))) continue;
      const char* sign = there.sign() < 0 ? "-" : "+";
      const Rational slope =
          Rational(there.sign() < 0 ? -1 : 1) *
          approximate(verifier::substitute(verifier::derivative(entry, question.name), question.name, place));
      if (slope < steepest_fall) {
        steepest_fall = slope;
        falling = sign + std::to_string(i);
      }
      if (slope > steepest_rise) {
        steepest_rise = slope;
        rising = sign + std::to_string(i);
      }
    }
    if (falling.empty() || rising.empty()) throw Rejected("no entries fall to the minimum and rise from it");
    Rational reach = range.upper ? (*range.upper - range.lower) / Rational(4) : Rational(1, 4);
    for (int k = 0; k < 40; ++k, reach /= Rational(2)) {
      const Rational lower = simplest_between(place - reach, place - reach / Rational(2));
      const Rational upper = simplest_between(place + reach / Rational(2), place + reach);
      if (lower < range.lower || (range.upper && upper > *range.upper)) continue;
      if (!falls(items, falling, question.name, lower, upper, Rational(-1))) continue;
      if (!falls(items, rising, question.name, lower, upper, Rational(1))) continue;
      return {{"near", "[" + lower.to_string() + ", " + upper.to_string() + "]"},
              {"active", fmt::format("{} {}", falling, rising)}};
    }
    throw Rejected("no interval around the minimum was found");
  }
  [[nodiscard]] bool falls(const std::vector<Value>& items, const std::string& token, const std::string& x,
                           const Rational& lower, const Rational& upper, const Rational& direction) const {
    const Rational sign = token[0] == '+' ? direction : -direction;
    const Quotient slope =
        Quotient(sign) * verifier::derivative(scalar(items[std::stoul(token.substr(1))]), x);
    if (slope.is_number()) return number(slope).sign() > 0;
    const Quotient product =
        Quotient(slope.above) *
        Quotient(slope.is_polynomial() ? verifier::Sparse{{{}, Rational(1)}} : slope.below);
    verifier::Ranges ranges = context_.ranges;
    ranges[x] = {lower, upper, false, false};
    try {
      const auto [cover, cell] = verifier::pose(verifier::Condition::sign, true, {product.above, {}}, ranges);
      (void)find_cover(cover, cell, 100);
      return true;
    } catch (const Rejected&) {
      return false;
    }
  }

  std::deque<std::string> given_;
  const Context& context_;
  std::map<std::string, std::string> found_;
  std::vector<std::string> proof_;
};

}  // namespace

verifier::Certificate prove(const Statement& statement, const std::filesystem::path& data) {
  verifier::Certificate result{statement.claim, {}, statement.lines, {}};
  for (const std::string& line : statement.head) {
    const std::size_t first = line.find(' ');
    const std::size_t second = line.find(' ', first + 1);
    if (second == std::string::npos) throw Rejected("a name and a scheme or file are needed: " + line);
    const std::string name = line.substr(first + 1, second - first - 1);
    const std::string what = line.substr(second + 1);
    result.head.push_back(line.starts_with("scheme ") ? verifier::scheme_line(name, what)
                                                      : verifier::data_line(name, what, data));
  }
  Context context = verifier::read_head(result.head, data);
  Prover prover(statement, context);
  const verifier::Witness witness = [&](const Question& question) { return prover.answer(question); };
  for (const std::string& line : statement.lines) {
    try {
      verifier::check_line(line, context, witness);
    } catch (const std::exception& error) {
      throw Rejected(std::string(error.what()) + " (" + line + ")");
    }
  }
  result.proof = prover.proof();
  return result;
}

}  // namespace subdiv
