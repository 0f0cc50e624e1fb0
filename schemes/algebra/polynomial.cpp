#include "schemes/algebra/polynomial.h"

#include <stdexcept>

#include <flint/fmpq_mpoly_factor.h>

namespace subdiv {
namespace {

/// FLINT's description of Q[x_0 .. x_7], made once and never changed.
struct Context {
  fmpq_mpoly_ctx_t ctx;
  Context() { fmpq_mpoly_ctx_init(ctx, max_parameters, ORD_LEX); }
  ~Context() { fmpq_mpoly_ctx_clear(ctx); }
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;
};

std::vector<std::string> complete_names(std::span<const std::string> names) {
  std::vector<std::string> result(names.begin(), names.end());
  for (auto i = result.size(); i < max_parameters; ++i) {
    result.push_back(i == symbol_variable       ? "z"
                     : i == eigenvalue_variable ? "lambda"
                                                : "x" + std::to_string(i));
  }
  return result;
}

}  // namespace

const fmpq_mpoly_ctx_struct* Polynomial::context() {
  static const Context context;
  return context.ctx;
}

Polynomial::Polynomial() { fmpq_mpoly_init(value_, context()); }
Polynomial::Polynomial(int n) : Polynomial() { fmpq_mpoly_set_si(value_, n, context()); }
Polynomial::Polynomial(const Rational& q) : Polynomial() { fmpq_mpoly_set_fmpq(value_, q.raw(), context()); }

Polynomial Polynomial::variable(int i) {
  if (i < 0 || i >= max_parameters) throw std::domain_error("no such indeterminate");
  Polynomial result;
  fmpq_mpoly_gen(result.value_, i, context());
  return result;
}

Polynomial::Polynomial(const Polynomial& o) : Polynomial() { fmpq_mpoly_set(value_, o.value_, context()); }
Polynomial::Polynomial(Polynomial&& o) noexcept : Polynomial() {
  fmpq_mpoly_swap(value_, o.value_, context());
}
Polynomial& Polynomial::operator=(const Polynomial& o) {
  if (this != &o) fmpq_mpoly_set(value_, o.value_, context());
  return *this;
}
Polynomial& Polynomial::operator=(Polynomial&& o) noexcept {
  fmpq_mpoly_swap(value_, o.value_, context());
  return *this;
}
Polynomial::~Polynomial() { fmpq_mpoly_clear(value_, context()); }

Polynomial& Polynomial::operator+=(const Polynomial& o) {
  fmpq_mpoly_add(value_, value_, o.value_, context());
  return *this;
}
Polynomial& Polynomial::operator-=(const Polynomial& o) {
  fmpq_mpoly_sub(value_, value_, o.value_, context());
  return *this;
}
Polynomial& Polynomial::operator*=(const Polynomial& o) {
  fmpq_mpoly_mul(value_, value_, o.value_, context());
  return *this;
}
bool operator==(const Polynomial& a, const Polynomial& b) {
  return fmpq_mpoly_equal(a.value_, b.value_, Polynomial::context()) != 0;
}

bool Polynomial::is_zero() const { return fmpq_mpoly_is_zero(value_, context()) != 0; }
bool Polynomial::is_constant() const { return fmpq_mpoly_is_fmpq(value_, context()) != 0; }

Rational Polynomial::constant() const {
  if (!is_constant()) throw std::domain_error("not a constant: " + to_string());
  Rational result;
  fmpq_mpoly_get_fmpq(result.raw(), value_, context());
  return result;
}

long Polynomial::degree(int variable) const { return fmpq_mpoly_degree_si(value_, variable, context()); }

Polynomial Polynomial::derivative(int variable) const {
  Polynomial result;
  fmpq_mpoly_derivative(result.value_, value_, variable, context());
  return result;
}

std::vector<Polynomial> Polynomial::coefficients_in(int variable) const {
  std::vector<Polynomial> result(static_cast<std::size_t>(std::max(degree(variable), 0L) + 1));
  const Polynomial one(1);
  for (Term& term : terms()) {
    auto& exponent = term.exponents[static_cast<std::size_t>(variable)];
    Polynomial& target = result[static_cast<std::size_t>(exponent)];
    exponent = 0;
    std::vector<unsigned long> exponents(term.exponents.begin(), term.exponents.end());
    fmpq_mpoly_push_term_fmpq_ui(target.value_, term.coefficient.raw(), exponents.data(), context());
  }
  for (Polynomial& p : result) {
    fmpq_mpoly_sort_terms(p.value_, context());
    fmpq_mpoly_combine_like_terms(p.value_, context());
  }
  return result;
}

Polynomial Polynomial::substitute(int variable, const Polynomial& by) const {
  const std::vector<Polynomial> coefficients = coefficients_in(variable);
  Polynomial result;
  for (auto c = coefficients.rbegin(); c != coefficients.rend(); ++c) result = result * by + *c;
  return result;
}

std::vector<Polynomial::Term> Polynomial::terms() const {
  std::vector<Term> result;
  const long count = fmpq_mpoly_length(value_, context());
  for (long i = 0; i < count; ++i) {
    Term term{Rational(), std::vector<long>(max_parameters)};
    fmpq_mpoly_get_term_coeff_fmpq(term.coefficient.raw(), value_, i, context());
    fmpq_mpoly_get_term_exp_si(term.exponents.data(), value_, i, context());
    result.push_back(std::move(term));
  }
  return result;
}

std::string Polynomial::to_string(std::span<const std::string> names) const {
  const std::vector<std::string> complete = complete_names(names);
  std::vector<const char*> pointers;
  for (const std::string& name : complete) pointers.push_back(name.c_str());
  char* raw = fmpq_mpoly_get_str_pretty(value_, pointers.data(), context());
  std::string text(raw);
  flint_free(raw);
  return text;
}

Polynomial pow(const Polynomial& p, unsigned n) {
  Polynomial result;
  fmpq_mpoly_pow_ui(result.raw(), p.raw(), n, Polynomial::context());
  return result;
}

bool divides(const Polynomial& b, const Polynomial& a, Polynomial& quotient) {
  if (b.is_zero()) return false;
  return fmpq_mpoly_divides(quotient.raw(), a.raw(), b.raw(), Polynomial::context()) != 0;
}

Polynomial gcd(const Polynomial& a, const Polynomial& b) {
  Polynomial result;
  if (fmpq_mpoly_gcd(result.raw(), a.raw(), b.raw(), Polynomial::context()) == 0) {
    throw std::domain_error("greatest common divisor too large to compute");
  }
  return result;
}

Polynomial resultant(const Polynomial& a, const Polynomial& b, int variable) {
  Polynomial result;
  if (fmpq_mpoly_resultant(result.raw(), a.raw(), b.raw(), variable, Polynomial::context()) == 0) {
    throw std::domain_error("resultant too large to compute");
  }
  return result;
}

Factorization factor(const Polynomial& p) {
  if (p.is_zero()) throw std::domain_error("zero has no factorisation");
  fmpq_mpoly_factor_t raw;
  fmpq_mpoly_factor_init(raw, Polynomial::context());
  const bool done = fmpq_mpoly_factor(raw, p.raw(), Polynomial::context()) != 0;
  Factorization result;
  if (done) {
    fmpq_set(result.constant.raw(), raw->constant);
    const long count = fmpq_mpoly_factor_length(raw, Polynomial::context());
    for (long i = 0; i < count; ++i) {
      Polynomial base;
      fmpq_mpoly_factor_get_base(base.raw(), raw, i, Polynomial::context());
      result.factors.emplace_back(
          std::move(base), static_cast<int>(fmpq_mpoly_factor_get_exp_si(raw, i, Polynomial::context())));
    }
  }
  fmpq_mpoly_factor_clear(raw, Polynomial::context());
  if (!done) throw std::domain_error("factorisation too large to compute");
  return result;
}

std::string to_factored_string(const Polynomial& p, std::span<const std::string> names) {
  if (p.is_constant()) return p.constant().to_string();
  const Factorization f = factor(p);
  // FLINT's factors are monic; show them primitive, with integer coefficients, instead.
  Rational constant = f.constant;
  std::string product;
  for (const auto& [base, exponent] : f.factors) {
    Polynomial primitive = base;
    Rational content(1);
    fmpq_set(content.raw(), primitive.raw()->content);
    primitive *= Polynomial(Rational(1) / content);
    constant *= pow(content, exponent);
    if (!product.empty()) product += "*";
    const std::string text = primitive.to_string(names);
    const bool single = primitive.terms().size() == 1;
    product += single ? text : "(" + text + ")";
    if (exponent > 1) product += "^" + std::to_string(exponent);
  }
  if (constant == Rational(1)) return product;
  if (constant == Rational(-1)) return "-" + product;
  return (constant.is_integer() ? constant.to_string() : "(" + constant.to_string() + ")") + "*" + product;
}

}  // namespace subdiv
