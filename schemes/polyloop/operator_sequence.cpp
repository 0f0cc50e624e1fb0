#include "schemes/polyloop/operator_sequence.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include "schemes/argument.h"
#include "schemes/scheme_file.h"
#include "schemes/text.h"

namespace subdiv {
namespace {

struct Named {
  std::string name;
  OperatorCall::Kind kind;
  std::vector<std::string> values;  // what stands in the parentheses
};

const std::array operators{
    Named{"refine", OperatorCall::Kind::refine, {}},
    Named{"split", OperatorCall::Kind::refine, {}},
    Named{"dual", OperatorCall::Kind::dual, {}},
    Named{"tuck", OperatorCall::Kind::tuck, {"t"}},
    Named{"untuck", OperatorCall::Kind::untuck, {}},
    Named{"tweak", OperatorCall::Kind::tweak, {"old", "new"}},
    Named{"J", OperatorCall::Kind::family, {"s"}},
};

std::string form_of(const Named& named) {
  std::string text = named.name;
  for (std::size_t i = 0; i < named.values.size(); ++i) text += (i == 0 ? "(" : ", ") + named.values[i];
  return named.values.empty() ? text : text + ")";
}

const std::string& all_forms() {
  static const std::string text = [] {
    std::vector<std::string> forms;
    for (const Named& named : operators) forms.push_back(form_of(named));
    return joined(forms);
  }();
  return text;
}

/// Of a word, be it none of ours: an error then names all of it.
bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || static_cast<unsigned char>(c) > '~';
}
bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Recursive descent; the depth of braces is limited, so that no text exhausts the stack.
class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) { result_.text = std::string(trimmed(text)); }

  OperatorSequence read() {
    result_.order = items(0);
    if (!at_end()) {
      reject(position_, peek() == '}' ? "there is no '{' before this '}'"
                                      : "expected ';' and the next operator, or ^N, found " + found());
    }
    return std::move(result_);
  }

 private:
  using Order = std::vector<std::size_t>;

  [[noreturn]] void reject(std::size_t position, const std::string& what) const {
    throw InputError("operators, " + located(text_, position, what));
  }
  void skip_space() {
    while (position_ < text_.size() &&
           std::string_view(" \t\r\n").find(text_[position_]) != std::string_view::npos)
      ++position_;
  }
  bool at_end() {
    skip_space();
    return position_ == text_.size();
  }
  char peek() { return at_end() ? '\0' : text_[position_]; }
  bool take(char c) {
    if (peek() != c) return false;
    ++position_;
    return true;
  }
  std::string found() { return at_end() ? "the end" : in_quotes(text_.substr(position_, 1)); }

  Order items(int depth) {
    Order order = item(depth);
    while (take(';')) {
      if (at_end() || peek() == '}') break;  // {tuck(s); tuck(-t);}
      append(order, item(depth), 1, position_);
    }
    return order;
  }

  Order item(int depth) {
    constexpr int deepest = 50;
    const std::size_t start = (skip_space(), position_);
    Order order;
    if (take('{')) {
      if (depth == deepest) reject(start, "braces in more than 50 braces");
      order = items(depth + 1);
      if (!take('}'))
        reject(position_, "expected ';' or the '}' of the '{' in column " + std::to_string(start + 1) +
                              ", found " + found());
    } else {
      order.push_back(result_.calls.size());
      result_.calls.push_back(call());
    }
    if (take('^')) {
      Order repeated;
      append(repeated, order, times(), start);
      return repeated;
    }
    return order;
  }

  void append(Order& order, const Order& more, std::size_t times, std::size_t position) const {
    if (more.size() > (longest_sequence - std::min(longest_sequence, order.size())) / times) {
      reject(position, "a sequence of more than " + std::to_string(longest_sequence) +
                           " operators; write a shorter one and repeat it");
    }
    for (std::size_t k = 0; k < times; ++k) order.insert(order.end(), more.begin(), more.end());
  }

  std::size_t times() {
    skip_space();
    const std::size_t start = position_;
    while (position_ < text_.size() && is_digit(text_[position_])) ++position_;
    std::size_t value = 0;
    const auto [end, error] = std::from_chars(text_.data() + start, text_.data() + position_, value);
    const bool too_many = error == std::errc::result_out_of_range;
    if (start == position_ || (value == 0 && !too_many))
      reject(start, "expected how often to repeat, a whole number from 1 on, found " +
                        in_quotes(text_.substr(start, std::max<std::size_t>(1, position_ - start))));
    return too_many ? longest_sequence + 1 : value;
  }

  OperatorCall call() {
    skip_space();
    const std::size_t start = position_;
    while (position_ < text_.size() &&
           (is_letter(text_[position_]) || (position_ > start && is_digit(text_[position_]))))
      ++position_;
    const std::string_view name = text_.substr(start, position_ - start);
    if (name.empty()) reject(start, "expected " + all_forms() + " or '{', found " + found());
    const Named& named = known(name, start);
    OperatorCall result{named.kind, {}, {}};
    if (named.values.empty()) {
      if (peek() == '(') reject(position_, named.name + " takes no value; what fits is " + form_of(named));
    } else {
      result.values = values(named);
    }
    result.text = std::string(trimmed(text_.substr(start, position_ - start)));
    return result;
  }

  const Named& known(std::string_view name, std::size_t start) const {
    const auto* const named = std::ranges::find(operators, name, &Named::name);
    if (named != operators.end()) return *named;
    std::vector<std::string> names;
    for (const Named& n : operators) names.push_back(n.name);
    const std::string base(name.substr(0, name.find_first_of("0123456789")));
    const bool is_power = base.size() < name.size() && std::ranges::find(names, base) != names.end();
    const std::string near =
        is_power ? "; did you mean '" + base + "^" + std::string(name.substr(base.size())) + "'?"
                 : suggestion(name, names);
    reject(start, "there is no operator " + in_quotes(name) + near + " Operators are " + all_forms());
  }

  std::vector<Expression> values(const Named& named) {
    const std::size_t open = position_;
    if (!take('(')) {
      reject(position_, named.name + " needs " + (named.values.size() == 1 ? "a value" : "two values") +
                            ": " + form_of(named));
    }
    std::size_t end = position_;
    for (int depth = 1; end < text_.size(); ++end) {
      if (text_[end] == '(') ++depth;
      if (text_[end] == ')' && --depth == 0) break;
    }
    if (end == text_.size()) reject(open, "this '(' has no ')'");
    const std::string_view inside = text_.substr(position_, end - position_);
    const std::vector<std::string_view> pieces = split_outside_parentheses(inside, ',');
    if (pieces.size() != named.values.size()) {
      reject(open, named.name + " takes " + std::to_string(named.values.size()) + " value" +
                       (named.values.size() == 1 ? "" : "s") + ", not " + std::to_string(pieces.size()) +
                       ": " + form_of(named));
    }
    std::vector<Expression> result;
    for (const std::string_view piece : pieces) {
      const auto place = static_cast<std::size_t>(piece.data() - text_.data());
      try {
        result.push_back(Expression::parse(piece));
      } catch (const InputError& error) {
        reject(piece.empty() ? open : place, "value of " + named.name + ", " + error.what());
      }
      add_names(result.back(), place);
    }
    position_ = end + 1;
    return result;
  }

  void add_names(const Expression& value, std::size_t place) {
    for (const std::string& name : value.names()) {
      if (std::ranges::find(result_.free_parameters, name) != result_.free_parameters.end()) continue;
      require_parameter_name(name, "operators, column " + std::to_string(place + 1));
      result_.free_parameters.push_back(name);
    }
    if (result_.free_parameters.size() > static_cast<std::size_t>(max_free_parameters)) {
      reject(place, "more than " + std::to_string(max_free_parameters) +
                        " free parameters: " + joined(result_.free_parameters, "and"));
    }
  }

  std::string_view text_;
  std::size_t position_ = 0;
  OperatorSequence result_;
};

}  // namespace

OperatorSequence parse_operators(std::string_view text) { return Reader(text).read(); }

std::vector<PolyloopOperator<double>> operators_in_double(const OperatorSequence& sequence) {
  if (!sequence.free_parameters.empty()) {
    throw InputError("operators " + in_quotes(sequence.text) + ": " +
                     joined(sequence.free_parameters, "and") +
                     (sequence.free_parameters.size() == 1 ? " has" : " have") +
                     " no value; write numbers, such as tuck(1/2)");
  }
  const auto exact = operators_of<Interval>(sequence, {}, IntervalLiteral{});
  std::vector<PolyloopOperator<double>> result;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    PolyloopOperator<double> rounded{exact[i].period, {}, exact[i].moves_vertices};
    for (const Laurent<Interval>& row : exact[i].rows) {
      for (const Interval& x : row.coefficients()) {
        if (!x.is_finite() || !std::isfinite(x.midpoint().to_double())) {
          throw InputError("operators, " + in_quotes(sequence.calls[i].text) +
                           ": a value leaves the range of doubles (about 1.8e308)");
        }
      }
      rounded.rows.push_back(
          map_coefficients(row, [](const Interval& x) { return x.midpoint().to_double(); }));
    }
    result.push_back(std::move(rounded));
  }
  return result;
}

}  // namespace subdiv
