#include "schemes/algebra/common_zeros.h"

#include <algorithm>
#include <optional>

namespace subdiv {
namespace {

/// A set whose equations and inequations are irreducible.
struct Case {
  std::vector<Polynomial> equations;
  std::vector<Polynomial> nonzero;
};

bool contains(const std::vector<Polynomial>& list, const Polynomial& p) {
  return std::ranges::find(list, p) != list.end();
}

std::vector<Polynomial> irreducible_factors(const Polynomial& p) {
  std::vector<Polynomial> result;
  for (const auto& [f, multiplicity] : factor(p).factors) result.push_back(f);
  return result;
}

std::vector<int> variables_of(const Polynomial& p) {
  std::vector<int> result;
  for (int v = 0; v < max_parameters; ++v) {
    if (p.uses(v)) result.push_back(v);
  }
  return result;
}

/// p modulo q in one variable in which q has a constant leading coefficient.
Polynomial remainder(Polynomial p, const Polynomial& q, int variable) {
  const long degree = q.degree(variable);
  const Rational lead = q.coefficients_in(variable).back().constant();
  while (!p.is_zero() && p.degree(variable) >= degree) {
    const Polynomial top = p.coefficients_in(variable).back();
    const auto shift = static_cast<unsigned>(p.degree(variable) - degree);
    p -= top * Polynomial(Rational(1) / lead) * pow(Polynomial::variable(variable), shift) * q;
  }
  return p;
}

/// The numerator of p where v is replaced by -d/c: sum of p_k (-d)^k c^(n-k).
Polynomial replace(const Polynomial& p, int v, const Polynomial& c, const Polynomial& d) {
  const std::vector<Polynomial> coefficients = p.coefficients_in(v);
  Polynomial result;
  Polynomial power(1);  // of c
  for (std::size_t i = coefficients.size(); i-- > 0;) {
    // Horner in -d/c, multiplied up.
    result = result * (-d) + coefficients[i] * power;
    power *= c;
  }
  return result;
}

class Prover {
 public:
  explicit Prover(const std::vector<std::string>& names) : names_(names) {}

  bool prove(std::vector<Polynomial> equations, const std::vector<Polynomial>& nonzero, int depth);
  [[nodiscard]] std::vector<std::string> lines() const { return lines_; }

 private:
  enum class Simplified { contradiction, nothing_left, open };
  static void add_nonzero(std::vector<Polynomial>& nonzero, const Polynomial& p);
  static Simplified simplify(std::vector<Polynomial>& equations, const std::vector<Polynomial>& nonzero);
  static void reduce_by_univariate(std::vector<Polynomial>& equations);
  std::optional<bool> split(const std::vector<Polynomial>& equations, const std::vector<Polynomial>& nonzero,
                            int depth);
  std::optional<bool> eliminate_linear(const std::vector<Polynomial>& equations,
                                       const std::vector<Polynomial>& nonzero, int depth);
  bool project(const std::vector<Polynomial>& equations, const std::vector<Polynomial>& nonzero, int depth);
  void say(int depth, const std::string& text) {
    lines_.push_back(std::string(2 * static_cast<std::size_t>(depth), ' ') + text);
  }
  [[nodiscard]] std::string text(const Polynomial& p) const {
    constexpr std::size_t longest = 60;
    std::string result = p.to_string(names_);
    if (result.size() <= longest) return result;
    return "a polynomial of " + std::to_string(p.terms().size()) + " terms";
  }

  const std::vector<std::string>& names_;
  std::vector<std::string> lines_;
};

void Prover::add_nonzero(std::vector<Polynomial>& nonzero, const Polynomial& p) {
  for (const Polynomial& f : irreducible_factors(p)) {
    if (!contains(nonzero, f)) nonzero.push_back(f);
  }
}

/// Univariate equations in the same variable become their gcd, and reduce the others' degree in it.
void Prover::reduce_by_univariate(std::vector<Polynomial>& equations) {
  for (int v = 0; v < max_parameters; ++v) {
    Polynomial common;
    std::erase_if(equations, [&](const Polynomial& p) {
      if (variables_of(p) != std::vector<int>{v}) return false;
      common = gcd(common, p);
      return true;
    });
    if (common.is_zero()) continue;
    for (Polynomial& p : equations) {
      if (!common.is_constant() && p.uses(v)) p = remainder(p, common, v);
    }
    equations.push_back(common);
  }
}

/// Equations without repeated factors and without factors that cannot vanish.
Prover::Simplified Prover::simplify(std::vector<Polynomial>& equations,
                                    const std::vector<Polynomial>& nonzero) {
  std::vector<Polynomial> before;
  while (before != equations) {
    before = equations;
    std::vector<Polynomial> next;
    for (const Polynomial& p : equations) {
      if (p.is_zero()) continue;
      Polynomial kept(1);
      for (const Polynomial& f : irreducible_factors(p)) {
        if (!contains(nonzero, f)) kept *= f;
      }
      if (kept.is_constant()) return Simplified::contradiction;
      if (!contains(next, kept)) next.push_back(kept);
    }
    equations = std::move(next);
    reduce_by_univariate(equations);
  }
  return equations.empty() ? Simplified::nothing_left : Simplified::open;
}

/// The first equation that factors, as cases; later cases may assume that earlier factors do not vanish.
std::optional<bool> Prover::split(const std::vector<Polynomial>& equations,
                                  const std::vector<Polynomial>& nonzero, int depth) {
  for (std::size_t i = 0; i < equations.size(); ++i) {
    std::vector<Polynomial> factors = irreducible_factors(equations[i]);
    if (factors.size() < 2) continue;
    std::ranges::stable_sort(factors, {}, [](const Polynomial& f) { return f.terms().size(); });
    std::vector<Polynomial> excluded = nonzero;
    for (const Polynomial& f : factors) {
      std::vector<Polynomial> next = equations;
      next[i] = f;
      say(depth, "case " + text(f) + " = 0");
      if (!prove(std::move(next), excluded, depth + 1)) return false;
      excluded.push_back(f);
    }
    return true;
  }
  return std::nullopt;
}

/// An equation c v + d = 0 with the shortest c.
std::optional<bool> Prover::eliminate_linear(const std::vector<Polynomial>& equations,
                                             const std::vector<Polynomial>& nonzero, int depth) {
  std::size_t equation = equations.size();
  int variable = 0;
  std::size_t shortest = SIZE_MAX;
  for (std::size_t i = 0; i < equations.size(); ++i) {
    for (int v = 0; v < max_parameters; ++v) {
      if (equations[i].degree(v) != 1) continue;
      const Polynomial c = equations[i].coefficients_in(v)[1];
      const std::size_t length = c.is_constant() ? 0 : c.terms().size();
      if (length >= shortest) continue;
      shortest = length;
      equation = i;
      variable = v;
    }
  }
  if (equation == equations.size()) return std::nullopt;
  const std::vector<Polynomial> parts = equations[equation].coefficients_in(variable);
  const Polynomial& d = parts[0];
  const Polynomial& c = parts[1];
  const std::string name = Polynomial::variable(variable).to_string(names_);
  std::vector<Polynomial> next;
  for (std::size_t i = 0; i < equations.size(); ++i) {
    if (i != equation) next.push_back(replace(equations[i], variable, c, d));
  }
  std::vector<Polynomial> excluded;
  if (!c.is_constant()) add_nonzero(excluded, c);
  bool is_excluded = false;  // a factor that must not vanish vanishes wherever the equation and c != 0 hold
  for (const Polynomial& p : nonzero) {
    const Polynomial replaced = replace(p, variable, c, d);
    is_excluded = is_excluded || replaced.is_zero();
    if (!is_excluded && !replaced.is_constant()) add_nonzero(excluded, replaced);
  }
  say(depth, "eliminate " + name + " = -(" + text(d) + ")/(" + text(c) + ")");
  if (!is_excluded && !prove(std::move(next), excluded, depth + 1)) return false;
  if (c.is_constant()) return true;
  std::vector<Polynomial> degenerate = equations;
  degenerate[equation] = c;
  degenerate.push_back(d);
  say(depth, "case " + text(c) + " = " + text(d) + " = 0");
  return prove(std::move(degenerate), nonzero, depth + 1);
}

/// Resultants of the equation of lowest degree in one variable with the others: necessary conditions in fewer
/// variables.
bool Prover::project(const std::vector<Polynomial>& equations, const std::vector<Polynomial>& nonzero,
                     int depth) {
  for (int v = 0; v < max_parameters; ++v) {
    std::vector<Polynomial> with;
    std::vector<Polynomial> next;
    for (const Polynomial& p : equations) (p.uses(v) ? with : next).push_back(p);
    if (with.size() < 2) continue;
    std::ranges::stable_sort(with, {}, [&](const Polynomial& p) { return p.degree(v); });
    bool useful = false;
    for (std::size_t i = 1; i < with.size(); ++i) {
      next.push_back(resultant(with[0], with[i], v));
      useful = useful || !next.back().is_zero();
    }
    if (!useful) continue;
    std::vector<Polynomial> kept;
    std::ranges::copy_if(nonzero, std::back_inserter(kept), [&](const Polynomial& p) { return !p.uses(v); });
    say(depth, "project along " + Polynomial::variable(v).to_string(names_) + " by resultants");
    return prove(std::move(next), kept, depth + 1);
  }
  say(depth, "undecided");
  return false;
}

bool Prover::prove(std::vector<Polynomial> equations, const std::vector<Polynomial>& nonzero, int depth) {
  constexpr int deepest = 40;
  switch (simplify(equations, nonzero)) {
    case Simplified::contradiction:
      say(depth, "no common zero");
      return true;
    case Simplified::nothing_left:
      say(depth, "not empty");
      return false;
    case Simplified::open:
      break;
  }
  if (depth == deepest) return false;
  if (const auto done = split(equations, nonzero, depth)) return *done;
  if (const auto done = eliminate_linear(equations, nonzero, depth)) return *done;
  return project(equations, nonzero, depth);
}

}  // namespace

EmptinessProof prove_empty(const ZeroSet& set, const std::vector<std::string>& names) {
  std::vector<Polynomial> nonzero;
  for (const Polynomial& p : set.nonzero) {
    if (p.is_zero()) return {true, {"an expression that must not vanish is 0"}};
    for (const auto& [f, multiplicity] : factor(p).factors) {
      if (!contains(nonzero, f)) nonzero.push_back(f);
    }
  }
  Prover prover(names);
  EmptinessProof result;
  result.proved = prover.prove(set.equations, nonzero, 0);
  result.cases = prover.lines();
  return result;
}

}  // namespace subdiv
