#include "schemes/expression.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <utility>

namespace subdiv {
namespace {

constexpr std::size_t longest_text = 100'000;
constexpr int deepest_nesting = 100;
constexpr long largest_exponent = 1000;

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

/// A number of at most four digits; larger ones come out as 10000, beyond every limit.
long small_number(std::string_view digits) {
  constexpr long beyond = 10'000;
  long result = 0;
  for (const char c : digits) result = std::min(beyond, 10 * result + (c - '0'));
  return result;
}

/// Recursive descent over the grammar in the header; writes nodes in post-order.
class Parser {
 public:
  explicit Parser(std::string_view text) : text_(text) {}

  std::vector<Expression::Node> parse() {
    if (text_.size() > longest_text) {
      throw InputError(located(text_, 0,
                               "the expression has " + std::to_string(text_.size()) +
                                   " characters; at most " + std::to_string(longest_text) + " are read"));
    }
    if (trimmed(text_).empty())
      throw InputError("empty expression: expected a number, such as -33/26 or 0.5");
    sum();
    skip_space();
    if (position_ < text_.size()) fail(leftover());
    return std::move(nodes_);
  }

 private:
  using Kind = Expression::Kind;
  using Node = Expression::Node;

  [[noreturn]] void fail(const std::string& what) const { throw InputError(located(text_, position_, what)); }

  [[nodiscard]] char peek(std::size_t ahead = 0) const {
    return position_ + ahead < text_.size() ? text_[position_ + ahead] : '\0';
  }
  void skip_space() {
    while (position_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[position_])) != 0)
      ++position_;
  }
  /// Takes the character when it comes next.
  bool accept(char c) {
    skip_space();
    if (position_ >= text_.size() || text_[position_] != c) return false;
    ++position_;
    return true;
  }
  [[nodiscard]] std::string found() const {
    if (position_ == text_.size()) return "the text ends";
    if (static_cast<unsigned char>(peek()) > '~') return "found a character that is not ASCII (minus is '-')";
    return "found " + in_quotes(text_.substr(position_, 1));
  }
  [[nodiscard]] std::string leftover() const {
    const char c = peek();
    if (c == ')') return "')' without its '('";
    if (c == ',') return "unexpected ','; decimals have a point";
    if (is_letter(c) || is_digit(c) || c == '(' || c == '.')
      return "expected an operator; write a product with '*'";
    return "expected an operator, " + found();
  }

  void sum() {
    const std::size_t start = product();
    for (;;) {
      skip_space();
      const std::size_t at = position_;
      const bool plus = accept('+');
      if (!plus && !accept('-')) return;
      const std::size_t left = nodes_.size() - 1;
      product();
      push(plus ? Kind::add : Kind::subtract, start, at, left);
    }
  }

  /// Returns where its text starts.
  std::size_t product() {
    const std::size_t start = signed_power();
    for (;;) {
      skip_space();
      const std::size_t at = position_;
      const bool times = accept('*');
      if (!times && !accept('/')) return start;
      const std::size_t left = nodes_.size() - 1;
      signed_power();
      push(times ? Kind::multiply : Kind::divide, start, at, left);
    }
  }

  std::size_t signed_power() {
    skip_space();
    const std::size_t start = position_;
    bool negative = false;
    while (true) {
      if (accept('-')) {
        negative = !negative;
      } else if (!accept('+')) {
        break;
      }
    }
    power();
    if (negative) push(Kind::negate, start, start, nodes_.size() - 1);
    return start;
  }

  void power() {
    skip_space();
    const std::size_t start = position_;
    atom();
    skip_space();
    const std::size_t at = position_;
    if (!accept('^')) return;
    const long exponent = integer_exponent();
    const std::size_t end = position_;
    push(Kind::power, start, at, nodes_.size() - 1, exponent);
    nodes_.back().end = end;
    skip_space();
    if (peek() == '^') fail("a tower of powers needs parentheses");
  }

  long integer_exponent() {
    const bool enclosed = accept('(');
    const bool negative = accept('-');
    if (!negative) accept('+');
    skip_space();
    const std::size_t start = position_;
    const std::string_view written = digits();
    if (written.empty() || peek() == '.' || is_letter(peek()) || (enclosed && !accept(')'))) {
      fail("an exponent must be a whole number written out, such as z^3 or z^(-2); " + found());
    }
    const long magnitude = small_number(written);
    if (magnitude > largest_exponent) {
      position_ = start;
      fail("exponents go up to " + std::to_string(largest_exponent));
    }
    return negative ? -magnitude : magnitude;
  }

  void atom() {
    skip_space();
    const char c = peek();
    if (is_digit(c) || (c == '.' && is_digit(peek(1)))) return number();
    if (is_letter(c)) return name();
    const std::size_t start = position_;
    if (accept('(')) return enclosed_sum(start);
    fail("expected a number, a name or '(', " + found());
  }

  void enclosed_sum(std::size_t opening) {
    if (++depth_ > deepest_nesting)
      fail("more than " + std::to_string(deepest_nesting) + " nested parentheses");
    sum();
    if (!accept(')'))
      fail("expected ')' for the '(' of column " + std::to_string(opening + 1) + ", " + found());
    --depth_;
    Node& inner = nodes_.back();
    inner.begin = opening;
    inner.end = position_;
  }

  /// Takes the digits that come next, if any.
  std::string_view digits() {
    const std::size_t start = position_;
    while (is_digit(peek())) ++position_;
    return text_.substr(start, position_ - start);
  }

  void number() {
    const std::size_t start = position_;
    digits();
    const bool has_point = peek() == '.';
    if (has_point) ++position_;
    const long decimals = has_point ? static_cast<long>(digits().size()) : 0;
    const std::size_t sign = peek(1) == '-' || peek(1) == '+' ? 1 : 0;
    const bool has_exponent = (peek() == 'e' || peek() == 'E') && is_digit(peek(1 + sign));
    const long exponent = has_exponent ? decimal_exponent(start) : 0;
    Node node{.kind = Kind::number, .begin = start, .end = position_, .position = start};
    node.value = Rational::parse(text_.substr(start, position_ - start));
    if (has_point || has_exponent) node.half_unit = pow(Rational(10), exponent - decimals) / Rational(2);
    add_leaf(std::move(node));
  }

  long decimal_exponent(std::size_t number_start) {
    ++position_;
    const bool negative = peek() == '-';
    if (negative || peek() == '+') ++position_;
    const long exponent = small_number(digits());
    if (exponent > largest_exponent) {
      position_ = number_start;
      fail("a decimal's exponent is at most " + std::to_string(largest_exponent));
    }
    return negative ? -exponent : exponent;
  }

  void name() {
    const std::size_t start = position_;
    while (is_letter(peek()) || is_digit(peek())) ++position_;
    const std::string_view word = text_.substr(start, position_ - start);
    skip_space();
    const std::size_t opening = position_;
    if (!accept('(')) {
      if (word == "sqrt") fail("expected '(' after sqrt, " + found());
      Node node{.kind = Kind::name, .begin = start, .end = start + word.size(), .position = start};
      node.name = word;
      return add_leaf(std::move(node));
    }
    if (word != "sqrt") {
      position_ = start;
      fail("unknown function " + in_quotes(word) + "; only sqrt is known, and a product needs '*'");
    }
    enclosed_sum(opening);
    push(Kind::square_root, start, start, nodes_.size() - 1);
    nodes_.back().end = position_;
  }

  /// An operator over the node `left` and, for two operands, the last node.
  void push(Kind kind, std::size_t start, std::size_t at, std::size_t left, long exponent = 0) {
    const std::size_t right = nodes_.size() - 1;
    Node node{
        .kind = kind, .begin = start, .end = nodes_.back().end, .position = at, .left = left, .right = right};
    node.exponent = exponent;
    node.first = nodes_[left].first;
    nodes_.push_back(std::move(node));
  }

  void add_leaf(Node node) {
    node.first = node.left = node.right = nodes_.size();
    nodes_.push_back(std::move(node));
  }

  std::string_view text_;
  std::size_t position_ = 0;
  int depth_ = 0;
  std::vector<Node> nodes_;
};

}  // namespace

Expression Expression::parse(std::string_view text) {
  const std::string_view inner = trimmed(text);
  return Expression(std::string(inner), Parser(inner).parse());
}

std::vector<std::string> Expression::names(std::size_t root) const {
  std::vector<std::string> result;
  for (std::size_t i = nodes_[root].first; i <= root; ++i) {
    if (nodes_[i].kind != Kind::name) continue;
    if (std::find(result.begin(), result.end(), nodes_[i].name) == result.end())
      result.push_back(nodes_[i].name);
  }
  return result;
}

bool Expression::has_decimals(std::size_t root) const {
  const auto at = [&](std::size_t i) { return nodes_.begin() + static_cast<std::ptrdiff_t>(i); };
  return std::any_of(at(nodes_[root].first), at(root) + 1,
                     [](const Node& n) { return n.half_unit.sign() != 0; });
}

}  // namespace subdiv
