#include "experiments/verifier/term.h"

#include <cctype>
#include <utility>

#include "experiments/verifier/quotient.h"

namespace subdiv::verifier {
namespace {

constexpr int deepest = 200;

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// Recursive descent; the grammar's levels from loose to tight are sum, product, sign, power, place.
class Parser {
 public:
  explicit Parser(std::string_view text) : text_(text) {}

  Term all() {
    Term result = sum();
    if (at_ != text_.size()) fail();
    return result;
  }

 private:
  [[noreturn]] void fail() const { throw Rejected("no expression: " + std::string(text_)); }
  bool take(char c) {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
    if (at_ == text_.size() || text_[at_] != c) return false;
    ++at_;
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
    return true;
  }
  static Term node(Term::Kind kind, Term a, Term b) {
    Term result{kind};
    result.operands.push_back(std::move(a));
    result.operands.push_back(std::move(b));
    return result;
  }
  Term sum() {
    if (++depth_ > deepest) fail();
    Term result = product();
    for (;;) {
      if (take('+')) {
        result = node(Term::Kind::add, std::move(result), product());
      } else if (take('-')) {
        result = node(Term::Kind::subtract, std::move(result), product());
      } else {
        --depth_;
        return result;
      }
    }
  }
  Term product() {
    Term result = sign();
    for (;;) {
      if (take('*')) {
        result = node(Term::Kind::multiply, std::move(result), sign());
      } else if (take('/')) {
        result = node(Term::Kind::divide, std::move(result), sign());
      } else {
        return result;
      }
    }
  }
  Term sign() {
    if (++depth_ > deepest) fail();
    Term result;
    if (take('-')) {
      result.kind = Term::Kind::negate;
      result.operands.push_back(sign());
    } else {
      result = place();
      if (take('^')) result = node(Term::Kind::power, std::move(result), sign());
    }
    --depth_;
    return result;
  }
  Term place() {
    Term result = atom();
    while (take('[')) {
      result = node(Term::Kind::index, std::move(result), sum());
      if (!take(']')) fail();
    }
    return result;
  }
  Term atom() {
    if (take('(')) {
      Term result = sum();
      if (!take(')')) fail();
      return result;
    }
    if (take('[')) return {Term::Kind::list, {}, {}, operands(']')};
    const std::size_t begin = at_;
    if (at_ < text_.size() && is_digit(text_[at_])) return number();
    while (at_ < text_.size() && is_word(text_[at_])) ++at_;
    if (begin == at_) fail();
    std::string name(text_.substr(begin, at_ - begin));
    if (take('(')) return {Term::Kind::call, {}, std::move(name), operands(')')};
    return {Term::Kind::name, {}, std::move(name), {}};
  }
  Term number() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && is_digit(text_[at_])) ++at_;
    if (at_ + 1 < text_.size() && text_[at_] == '.' && is_digit(text_[at_ + 1])) {
      ++at_;
      while (at_ < text_.size() && is_digit(text_[at_])) ++at_;
    }
    if (at_ < text_.size() && is_word(text_[at_])) fail();
    return {Term::Kind::number, Rational::parse(text_.substr(begin, at_ - begin)), {}, {}};
  }
  std::vector<Term> operands(char end) {
    std::vector<Term> result;
    if (take(end)) return result;
    do {
      result.push_back(sum());
    } while (take(','));
    if (!take(end)) fail();
    return result;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

}  // namespace

Term parse_term(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  return Parser(text).all();
}

}  // namespace subdiv::verifier
