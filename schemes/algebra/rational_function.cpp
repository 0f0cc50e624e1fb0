#include "schemes/algebra/rational_function.h"

namespace subdiv {
namespace {

/// The integer context inside the rational one: both describe x_0 .. x_7 in the same order.
const fmpz_mpoly_ctx_struct* context() { return Polynomial::context()->zctx; }

Polynomial from_integer_polynomial(const fmpz_mpoly_struct* p) {
  Polynomial result;
  fmpz_mpoly_set(result.raw()->zpoly, p, context());
  fmpq_one(result.raw()->content);
  fmpq_mpoly_reduce(result.raw(), Polynomial::context());
  return result;
}

}  // namespace

RationalFunction::RationalFunction() { fmpz_mpoly_q_init(value_, context()); }
RationalFunction::RationalFunction(int n) : RationalFunction() { fmpz_mpoly_q_set_si(value_, n, context()); }
RationalFunction::RationalFunction(const Rational& q) : RationalFunction() {
  fmpz_mpoly_q_set_fmpq(value_, q.raw(), context());
}
RationalFunction::RationalFunction(const Polynomial& p) : RationalFunction() {
  const fmpq_mpoly_struct* raw = p.raw();
  fmpz_mpoly_scalar_mul_fmpz(&value_->num, raw->zpoly, fmpq_numref(raw->content), context());
  fmpz_mpoly_set_fmpz(&value_->den, fmpq_denref(raw->content), context());
  fmpz_mpoly_q_canonicalise(value_, context());
}

RationalFunction RationalFunction::variable(int i) { return RationalFunction(Polynomial::variable(i)); }

RationalFunction::RationalFunction(const RationalFunction& o) : RationalFunction() {
  fmpz_mpoly_q_set(value_, o.value_, context());
}
RationalFunction::RationalFunction(RationalFunction&& o) noexcept : RationalFunction() {
  fmpz_mpoly_q_swap(value_, o.value_, context());
}
RationalFunction& RationalFunction::operator=(const RationalFunction& o) {
  if (this != &o) fmpz_mpoly_q_set(value_, o.value_, context());
  return *this;
}
RationalFunction& RationalFunction::operator=(RationalFunction&& o) noexcept {
  fmpz_mpoly_q_swap(value_, o.value_, context());
  return *this;
}
RationalFunction::~RationalFunction() { fmpz_mpoly_q_clear(value_, context()); }

RationalFunction& RationalFunction::operator+=(const RationalFunction& o) {
  fmpz_mpoly_q_add(value_, value_, o.value_, context());
  return *this;
}
RationalFunction& RationalFunction::operator-=(const RationalFunction& o) {
  fmpz_mpoly_q_sub(value_, value_, o.value_, context());
  return *this;
}
RationalFunction& RationalFunction::operator*=(const RationalFunction& o) {
  fmpz_mpoly_q_mul(value_, value_, o.value_, context());
  return *this;
}
RationalFunction& RationalFunction::operator/=(const RationalFunction& o) {
  if (o.is_zero()) throw std::domain_error("division by zero");
  fmpz_mpoly_q_div(value_, value_, o.value_, context());
  return *this;
}
bool operator==(const RationalFunction& a, const RationalFunction& b) {
  return fmpz_mpoly_q_equal(a.value_, b.value_, context()) != 0;
}

bool RationalFunction::is_zero() const { return fmpz_mpoly_is_zero(&value_->num, context()) != 0; }
bool RationalFunction::is_constant() const {
  return fmpz_mpoly_is_fmpz(&value_->num, context()) != 0 && fmpz_mpoly_is_fmpz(&value_->den, context()) != 0;
}
Rational RationalFunction::constant() const { return numerator().constant() / denominator().constant(); }
Polynomial RationalFunction::numerator() const { return from_integer_polynomial(&value_->num); }
Polynomial RationalFunction::denominator() const { return from_integer_polynomial(&value_->den); }

RationalFunction RationalFunction::derivative(int variable) const {
  const Polynomial n = numerator();
  const Polynomial d = denominator();
  return RationalFunction(n.derivative(variable) * d - n * d.derivative(variable)) / RationalFunction(d * d);
}

namespace {

/// "n/d" with parentheses only where they are needed.
std::string quotient_string(const std::string& above, bool above_is_product, const std::string& below) {
  const bool below_is_atom = below.find_first_of("*+- ") == std::string::npos ||
                             (below.front() == '(' && below.find(')') == below.size() - 1);
  return (above_is_product ? above : "(" + above + ")") + "/" + (below_is_atom ? below : "(" + below + ")");
}

}  // namespace

std::string RationalFunction::to_string(std::span<const std::string> names) const {
  const Polynomial above = numerator();
  const Polynomial below = denominator();
  if (below == Polynomial(1)) return above.to_string(names);
  const bool single = above.terms().size() <= 1;
  const std::string below_text = below.to_string(names);
  return quotient_string(above.to_string(names), single, below_text);
}

std::string RationalFunction::to_factored_string(std::span<const std::string> names) const {
  const Polynomial below = denominator();
  std::string above_text = subdiv::to_factored_string(numerator(), names);
  if (below == Polynomial(1)) return above_text;
  return quotient_string(above_text, true, subdiv::to_factored_string(below, names));
}

}  // namespace subdiv
