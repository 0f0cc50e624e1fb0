#include "experiments/verifier/statement.h"

#include <algorithm>
#include <array>
#include <utility>

namespace subdiv::verifier {
namespace {

std::string trim(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  return std::string(text);
}

/// The text before and after the first, or last, separator; Rejected when there is none.
std::pair<std::string, std::string> parts(const std::string& text, const std::string& separator,
                                          bool last = false) {
  const std::size_t at = last ? text.rfind(separator) : text.find(separator);
  need(at != std::string::npos, "'" + trim(separator) + "' is missing");
  return {trim(text.substr(0, at)), trim(text.substr(at + separator.size()))};
}

bool is_word(const std::string& text) {
  return !text.empty() && (text[0] < '0' || text[0] > '9') &&
         std::all_of(text.begin(), text.end(), [](char c) {
           return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
         });
}

std::vector<std::string> names_in(const std::string& text) {
  std::vector<std::string> result;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    if (std::string name = trim(std::string_view(text).substr(begin, end - begin)); !name.empty())
      result.push_back(std::move(name));
    begin = end + 1;
  }
  return result;
}

class Checker {
 public:
  Checker(Context& context, const Witness& witness) : c_(context), witness_(witness) {}

  void line(const std::string& text) {
    const std::size_t space = std::min(text.find(' '), text.size());
    const std::string verb = text.substr(0, space);
    const std::string rest = trim(text.substr(space));
    if (verb == "#") return;
    if (verb == "let") return define(rest);
    if (verb == "def") return define_function(rest);
    if (verb == "for") return range(rest);
    if (verb == "root") return root(rest);
    if (verb == "value") return c_.values.push_back(value(rest));
    if (verb == "rows") return rows_line(rest);
    if (verb == "peak") {
      const auto [items, bound] = parts(rest, " > ");
      return cover(Condition::peak, true, scalars(value(items)), scalar(value(bound)));
    }
    if (verb == "radius") return radius(rest);
    if (verb == "least") return least(rest);
    if (verb == "minimum") return minimum(rest);
    comparison(text);
  }

 private:
  [[nodiscard]] Value value(const std::string& text) const { return evaluate(text, c_.names); }
  [[nodiscard]] Value answer(const Question& question) const { return value(witness_(question)); }
  static std::vector<Quotient> scalars(const Value& v) {
    std::vector<Quotient> result;
    for (const Value& item : list(v)) result.push_back(scalar(item));
    return result;
  }

  // ---- Definitions
  // ---------------------------------------------------------------------------------------------

  void define(const std::string& text) {
    const auto [name, body] = parts(text, "=");
    need(is_indeterminate(name) && !c_.ranges.contains(name), name + " is named twice");
    c_.names.values[name] = value(body);
  }
  [[nodiscard]] bool is_indeterminate(const std::string& name) const {
    return is_word(name) && !c_.names.values.contains(name) && !c_.roots.contains(name);
  }
  void define_function(const std::string& text) {
    const auto [head, body] = parts(text, " = ");
    const auto [name, parameters] = parts(head, "(");
    need(parameters.ends_with(')'), "')' is missing");
    need(is_word(name) && !is_built_in(name) && !c_.names.functions.contains(name), name + " is named twice");
    c_.names.functions[name] = {names_in(parameters.substr(0, parameters.size() - 1)), parse_term(body)};
  }
  Range interval(const std::string& text) const {
    need(text.size() > 4 && (text[0] == '[' || text[0] == '(') && (text.back() == ']' || text.back() == ')'),
         "an interval is needed");
    const auto [lower, upper] = parts(text.substr(1, text.size() - 2), ",", true);
    Range result{number(scalar(value(lower))), std::nullopt, text[0] == '(', text.back() == ')'};
    if (upper != "inf") result.upper = number(scalar(value(upper)));
    const bool is_point = result.upper && result.lower == *result.upper;
    need(is_point ? !result.lower_open && !result.upper_open
                  : (result.upper ? result.lower < *result.upper : result.upper_open),
         "the ends of an interval are reversed");
    return result;
  }
  void range(const std::string& text) {
    const auto [name, body] = parts(text, " in ");
    need(is_indeterminate(name), name + " has a value");
    c_.ranges[name] = interval(body);
  }
  void root(const std::string& text) {
    const auto [head, ends] = parts(text, " in ", true);
    const auto [x, body] = parts(head, " of ");
    const Quotient p = scalar(value(body));
    need(is_indeterminate(x) && !c_.ranges.contains(x) && p.is_polynomial(),
         "a root of a polynomial is needed");
    std::map<long, Rational> equation;
    for (const auto& [n, rest] : by_power(p.above, x)) equation[n] = number(Quotient(rest));
    const Range range = interval(ends);
    need(range.upper && !range.lower_open && !range.upper_open, "a closed interval is needed");
    const auto sign_at = [&](const Rational& at) { return number(substitute(p, x, at)).sign(); };
    need(
        !equation.empty() && equation.begin()->first >= 0 && sign_at(range.lower) * sign_at(*range.upper) < 0,
        "no change of sign");
    c_.ranges[x] = range;
    cover(Condition::nonzero, true, {derivative(p, x)}, Quotient());
    c_.roots[x] = std::move(equation);
    c_.names.roots.insert(x);
  }

  // ---- Identities and signs
  // ------------------------------------------------------------------------------------

  /// The polynomial with powers of roots reduced by their equations.
  [[nodiscard]] Sparse reduced(Sparse p) const {
    for (const auto& [x, equation] : c_.roots) {
      const auto& [degree, leading] = *equation.rbegin();
      for (;;) {
        const auto by = by_power(p, x);
        if (by.empty() || by.rbegin()->first < degree) break;
        need(by.begin()->first >= 0, "a negative power of a root");
        const auto& [top, factor] = *by.rbegin();
        for (const auto& [n, c] : equation) {
          p = p +
              factor * power(Quotient::variable(x), n + top - degree).above * Quotient(-c / leading).above;
        }
      }
    }
    return p;
  }
  [[nodiscard]] bool has_root(const Sparse& p) const {
    return std::any_of(p.begin(), p.end(), [&](const auto& term) {
      return std::any_of(term.first.begin(), term.first.end(),
                         [&](const auto& f) { return c_.roots.contains(f.first); });
    });
  }
  [[nodiscard]] bool equal(const Value& a, const Value& b) const {
    if (a.is_list() || b.is_list()) {
      return a.is_list() && b.is_list() &&
             std::equal(a.items().begin(), a.items().end(), b.items().begin(), b.items().end(),
                        [&](const Value& x, const Value& y) { return equal(x, y); });
    }
    for (const Quotient* q : {&a.number(), &b.number()}) {
      if (has_root(q->below)) require_nonzero(q->below);
    }
    Quotient difference = a.number() - b.number();
    for (const auto& [x, equation] : c_.roots) {
      const auto by = by_power(difference.above, x);
      if (!by.empty() && by.begin()->first < 0) {
        const Range& range = c_.ranges.at(x);
        need(range.lower.sign() > 0 || range.upper->sign() < 0, x + " may be 0 in a denominator");
        difference = difference * power(Quotient::variable(x), -by.begin()->first);
      }
    }
    return reduced(difference.above).empty();
  }
  /// A denominator that the coefficients over the whole box keep away from 0.
  void require_nonzero(const Sparse& p) const {
    const auto [problem, box] = pose(Condition::nonzero, true, {reduced(p), {}}, c_.ranges);
    check_cover(problem, box, ".");
  }
  void cover(Condition condition, bool strict, std::vector<Quotient> items, const Quotient& bound) const {
    items.push_back(bound);
    std::vector<Sparse> denominators;
    for (const Quotient& q : items) {
      if (!q.is_polynomial() &&
          std::find(denominators.begin(), denominators.end(), q.below) == denominators.end())
        denominators.push_back(q.below);
    }
    std::vector<Sparse> polynomials;
    for (const Quotient& q : items) {  // times the square of the product of all denominators
      Sparse p = q.above;
      for (const Sparse& d : denominators) p = d == q.below ? p * d : p * d * d;
      polynomials.push_back(reduced(std::move(p)));
    }
    if (!strict) {
      for (const Sparse& d : denominators) require_nonzero(d);
    }
    const auto [problem, box] = pose(condition, strict, std::move(polynomials), c_.ranges);
    check_cover(problem, box, witness_({"cover", &problem, &box}));
  }
  /// a > b, or a >= b.
  void greater(const Quotient& a, const Quotient& b, bool strict) const {
    if (!strict && equal(a, b)) return;
    const Quotient difference = a - b;
    if (!difference.is_number()) return cover(Condition::sign, strict, {difference}, Quotient());
    const int sign = number(difference).sign();
    need(sign > 0 || (sign == 0 && !strict), "the inequality is false");
  }
  void rows(const Value& items, const Quotient& bound, bool strict) const {
    const bool is_matrix = !list(items).empty() && items.items()[0].is_list();
    for (const Value& row : is_matrix ? items.items() : std::vector<Value>{items}) {
      const std::vector<Quotient> entries = scalars(row);
      need(!entries.empty(), "an empty row");
      if (!bound.is_number() ||
          !std::all_of(entries.begin(), entries.end(), [](const Quotient& q) { return q.is_number(); })) {
        cover(Condition::rows, strict, entries, bound);
        continue;
      }
      Rational margin = number(bound);
      for (const Quotient& entry : entries) margin -= abs(number(entry));
      need(margin.sign() > 0 || (margin.sign() == 0 && !strict), "a sum of absolute values is too large");
    }
  }
  void rows_line(const std::string& text) const {
    const bool strict = text.find(" <= ") == std::string::npos;
    const auto [items, bound] = parts(text, strict ? " < " : " <= ");
    rows(value(items), scalar(value(bound)), strict);
  }
  void comparison(const std::string& text) const {
    for (const char* relation : {" == ", " != ", " >= ", " > "}) {
      if (text.find(relation) == std::string::npos) continue;
      const auto [left, right] = parts(text, relation);
      const Value a = value(left);
      const Value b = value(right);
      const std::string_view sign(relation);
      if (sign == " == ") return need(equal(a, b), "the two sides are not equal");
      const Quotient difference = scalar(a) - scalar(b);
      if (sign == " != ") return greater(difference * difference, Quotient(), true);
      return greater(scalar(a), scalar(b), sign == " > ");
    }
    throw Rejected("unknown statement");
  }

  // ---- Norms and minima
  // ----------------------------------------------------------------------------------------

  /// At most: the balanced hull of the vertices is sent into `bound` times itself. At least: on an invariant
  /// space of dimension d the determinant of a product is that of d eigenvalues.
  void radius(const std::string& text) const {
    const bool at_most = text.find(" <= ") != std::string::npos;
    const auto [left, right] = parts(text, at_most ? " <= " : " >= ");
    const Value family = value(left);
    const Value bound = value(right);
    need(!list(family).empty() && !list(family.items()[0]).empty(), "matrices are needed");
    const std::size_t size = family.items()[0].items().size();
    for (const Value& matrix : family.items()) {
      need(list(matrix).size() == size, "matrices of different sizes");
      for (const Value& row : matrix.items()) need(scalars(row).size() == size, "a square matrix is needed");
    }
    const auto ask = [&](const char* word) { return answer({word, nullptr, nullptr, {family, bound}}); };
    if (at_most) {
      const Value vertices = ask("vertices");
      const Value images = ask("images");
      std::vector<Value> span;
      for (const Quotient& k : scalars(ask("span"))) {
        const long i = whole(k);
        need(i >= 0 && static_cast<std::size_t>(i) < list(vertices).size(), "there is no such vertex");
        span.push_back(vertices.items()[static_cast<std::size_t>(i)]);
      }
      need(span.size() == size, "the vertices do not span the space");
      greater(power(determinant(span), 2), Quotient(), true);
      need(list(images).size() == family.items().size() * vertices.items().size(), "an image is missing");
      std::size_t image = 0;
      for (const Value& matrix : family.items()) {
        for (const Value& vertex : vertices.items()) {
          need(equal(matrix * vertex, images.items()[image++] * vertices),
               "an image is not that combination");
        }
      }
      return rows(images, scalar(bound), false);
    }
    const std::vector<Quotient> word = scalars(ask("word"));
    const Value space = ask("space");
    const Value block = ask("block");
    need(!word.empty(), "an empty product");
    Value product;
    for (std::size_t k = 0; k < word.size(); ++k) {
      const long i = whole(word[k]);
      need(i >= 0 && static_cast<std::size_t>(i) < family.items().size(), "there is no such matrix");
      const Value& matrix = family.items()[static_cast<std::size_t>(i)];
      product = k == 0 ? matrix : product * matrix;
    }
    need(equal(product * space, space * block), "the space is not invariant");
    greater(determinant(transposed(space) * space), Quotient(), true);
    const auto length = static_cast<long>(word.size() * list(block).size());
    greater(power(determinant(block), 2), power(scalar(bound), 2 * length), false);
  }

  /// Affine entries: weights that cancel the variables bound the norm from below by a constant.
  void least(const std::string& text) const {
    const auto [head, place] = parts(text, " at ", true);
    const auto [left, right] = parts(head, " == ", true);
    const auto [what, over] = parts(left, " over ", true);
    const auto [norm, items_text] = parts(what, " ");
    need(norm == "max" || norm == "sum", "max or sum is needed");
    const bool is_max = norm == "max";
    const Value items = value(items_text);
    const Value bound = value(right);
    Value at = value(place);
    if (!at.is_list()) at = std::vector<Value>{at};
    const std::vector<std::string> names = names_in(over);
    std::vector<Value> variables;
    for (const std::string& x : names) {
      need(is_indeterminate(x) && !c_.ranges.contains(x), x + " does not run over all numbers");
      variables.emplace_back(Quotient::variable(x));
    }
    const Value dual = answer(
        {"dual", nullptr, nullptr, {Value(Quotient(Rational(is_max ? 1 : 0))), items, variables, bound, at}});
    need(list(dual).size() == list(items).size() && at.items().size() == names.size(),
         "a weight for each entry, a place for each variable");
    rows(is_max ? dual : as_rows(dual), Rational(1), false);
    const Quotient combined = scalar(dual * items);
    std::vector<Value> there = items.items();
    for (std::size_t i = 0; i < names.size(); ++i) {
      need(equal(derivative(combined, names[i]), Quotient()), "the weights leave a variable");
      for (Value& entry : there) entry = substitute(scalar(entry), names[i], scalar(at.items()[i]));
    }
    need(equal(combined, bound), "the weights give another bound");
    rows(is_max ? as_rows(there) : there, scalar(bound), false);
  }
  static Value as_rows(const Value& row) {
    std::vector<Value> result;
    for (const Value& entry : row.items()) result.emplace_back(std::vector<Value>{entry});
    return result;
  }

  /// Outside [a, b] some entry exceeds the value; within it one entry falls to `place`, another rises from
  /// it.
  void minimum(const std::string& text) {
    const auto [head, place] = parts(text, " at ", true);
    const auto [left, right] = parts(head, " == ", true);
    const auto [what, x] = parts(left, " over ", true);
    const auto [norm, items_text] = parts(what, " ");
    need(norm == "max" && c_.ranges.contains(x) && is_indeterminate(x),
         "'minimum max .. over' a variable with a range is needed");
    const Value items = value(items_text);
    const Value bound = value(right);
    const Quotient at = scalar(value(place));
    const Range whole_range = c_.ranges.at(x);
    const std::vector<Value> about{items, bound, at};
    const Range near = interval(trim(witness_({"near", nullptr, nullptr, about, x})));
    const auto [falling, rising] = parts(trim(witness_({"active", nullptr, nullptr, about, x})), " ");
    need(near.upper && near.lower >= whole_range.lower &&
             (!whole_range.upper || *near.upper <= *whole_range.upper),
         "'near' leaves the interval");
    for (const Quotient* q : {&scalar(bound), &at})
      need(equal(derivative(*q, x), Quotient()), "the minimum depends on its variable");
    for (const Value& entry : list(items)) {
      const Quotient there = substitute(scalar(entry), x, at);
      greater(scalar(bound), there, false);
      greater(scalar(bound), Quotient() - there, false);
    }
    const auto pick = [&](const std::string& token) {
      need(token.size() > 1 && token.size() < 8 && (token[0] == '+' || token[0] == '-') &&
               token.find_first_not_of("0123456789", 1) == std::string::npos &&
               std::stoul(token.substr(1)) < items.items().size(),
           "no entry " + token);
      return Quotient(Rational(token[0] == '+' ? 1 : -1)) *
             scalar(items.items()[std::stoul(token.substr(1))]);
    };
    for (const std::string& token : {falling, rising})
      need(equal(substitute(pick(token), x, at), bound), "entry " + token + " is not active");
    c_.ranges[x] = {near.lower, near.upper, false, false};
    greater(Quotient(), derivative(pick(falling), x), true);
    greater(derivative(pick(rising), x), Quotient(), true);
    greater(at, near.lower, true);
    greater(*near.upper, at, true);
    const std::array<Range, 2> sides{Range{whole_range.lower, near.lower, whole_range.lower_open, false},
                                     Range{*near.upper, whole_range.upper, false, whole_range.upper_open}};
    for (const Range& side : sides) {
      c_.ranges[x] = side;
      if (!side.upper || side.lower < *side.upper)
        cover(Condition::peak, true, scalars(items), scalar(bound));
    }
    c_.ranges[x] = whole_range;
  }

  Context& c_;
  const Witness& witness_;
};

}  // namespace

void check_line(const std::string& line, Context& context, const Witness& witness) {
  Checker(context, witness).line(line);
}

}  // namespace subdiv::verifier
