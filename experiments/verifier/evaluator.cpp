#include "experiments/verifier/evaluator.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <functional>
#include <utility>

namespace subdiv::verifier {
namespace {

using Locals = std::map<std::string, Value>;

Value each(const std::function<Quotient(const Quotient&, const Quotient&)>& f, const Value& a,
           const Value& b) {
  need(a.is_list() == b.is_list() && a.items().size() == b.items().size(), "lists of different lengths");
  if (!a.is_list()) return f(a.number(), b.number());
  std::vector<Value> result;
  for (std::size_t i = 0; i < a.items().size(); ++i) result.push_back(each(f, a.items()[i], b.items()[i]));
  return result;
}

class Evaluation {
 public:
  explicit Evaluation(const Names& names) : names_(names) {}

  Value value(const Term& t, const Locals& locals) {
    need(++depth_ <= 2000, "an expression goes too deep");
    Value result = unbounded_value(t, locals);
    --depth_;
    return result;
  }

 private:
  Quotient number_at(const Term& t, const Locals& locals) { return scalar(value(t, locals)); }

  Value unbounded_value(const Term& t, const Locals& locals) {
    using Kind = Term::Kind;
    const auto operand = [&](std::size_t i) { return value(t.operands[i], locals); };
    switch (t.kind) {
      case Kind::number:
        return Quotient(t.value);
      case Kind::name: {
        if (const auto local = locals.find(t.name); local != locals.end()) return local->second;
        const auto known = names_.values.find(t.name);
        return known != names_.values.end() ? known->second : Value(Quotient::variable(t.name));
      }
      case Kind::list: {
        std::vector<Value> items;
        for (const Term& item : t.operands) items.push_back(value(item, locals));
        return items;
      }
      case Kind::index: {
        const Value a = operand(0);
        const long i = whole(scalar(operand(1)));
        need(i >= 0 && static_cast<std::size_t>(i) < list(a).size(), "an index is outside its list");
        return a.items()[static_cast<std::size_t>(i)];
      }
      case Kind::negate:
        return Value(Quotient(Rational(-1))) * operand(0);
      case Kind::add:
        return operand(0) + operand(1);
      case Kind::subtract:
        return operand(0) - operand(1);
      case Kind::multiply:
        return operand(0) * operand(1);
      case Kind::divide:
        return Value(Quotient(Rational(1)) / scalar(operand(1))) * operand(0);
      case Kind::power:
        return power(scalar(operand(0)), whole(scalar(operand(1))));
      case Kind::call:
        return call(t, locals);
    }
    throw Rejected("no expression");
  }

  Value call(const Term& t, const Locals& locals) {
    const auto count = [&](std::size_t n) {
      need(t.operands.size() == n, "the number of arguments of " + t.name);
    };
    if (const auto found = names_.functions.find(t.name); found != names_.functions.end()) {
      const Function& function = found->second;
      count(function.parameters.size());
      Locals inner;
      for (std::size_t i = 0; i < t.operands.size(); ++i)
        inner[function.parameters[i]] = value(t.operands[i], locals);
      return value(function.body, inner);
    }
    if (t.name == "if") {
      count(3);
      return value(t.operands[number(number_at(t.operands[0], locals)).sign() != 0 ? 1 : 2], locals);
    }
    if (t.name == "seq" || t.name == "sum") {
      count(4);
      return range(t, locals);
    }
    if (t.name == "coef" || t.name == "subst" || t.name == "diff" || t.name == "low" || t.name == "high") {
      count(t.name == "coef" || t.name == "subst" ? 3 : 2);
      need(t.operands[1].kind == Term::Kind::name, "a name is needed in " + t.name);
      return of_polynomial(t, locals);
    }
    std::vector<Value> arguments;
    for (const Term& operand : t.operands) arguments.push_back(value(operand, locals));
    count(t.name == "join" || t.name == "less" || t.name == "mod" ? 2 : 1);
    return of_values(t.name, arguments);
  }

  Value range(const Term& t, const Locals& locals) {
    need(t.operands[0].kind == Term::Kind::name, "a name is needed in " + t.name);
    const long last = whole(number_at(t.operands[2], locals));
    std::vector<Value> items;
    Locals inner = locals;
    for (long i = whole(number_at(t.operands[1], locals)); i <= last; ++i) {
      inner[t.operands[0].name] = Quotient(Rational(i));
      items.push_back(value(t.operands[3], inner));
    }
    if (t.name == "seq") return items;
    Value total = items.empty() ? Value(Quotient()) : items.front();
    for (std::size_t i = 1; i < items.size(); ++i) total = total + items[i];
    return total;
  }

  Value of_polynomial(const Term& t, const Locals& locals) {
    const Quotient f = number_at(t.operands[0], locals);
    const std::string& x = t.operands[1].name;
    need(!locals.contains(x) && !names_.values.contains(x) && !names_.roots.contains(x),
         x + " is no indeterminate in " + t.name);
    if (t.name == "diff") return derivative(f, x);
    if (t.name == "subst") return substitute(f, x, number_at(t.operands[2], locals));
    const auto below = by_power(f.below, x);
    need(below.size() == 1 && below.begin()->first == 0, t.name + " of a quotient");
    auto parts = by_power(f.above, x);
    if (t.name == "coef") {
      Quotient result(parts[whole(number_at(t.operands[2], locals))]);
      return result / Quotient(f.below);
    }
    need(!parts.empty(), t.name + " of 0");
    for (const auto& [n, coefficient] : parts) {  // which a root could make 0
      for (const std::string& root : names_.roots) {
        need(by_power(coefficient, root).contains(0) && by_power(coefficient, root).size() == 1,
             t.name + " of a polynomial with roots");
      }
    }
    return Quotient(Rational(t.name == "low" ? parts.begin()->first : parts.rbegin()->first));
  }

  static Value of_values(const std::string& name, const std::vector<Value>& v) {
    if (name == "det") return determinant(v[0]);
    if (name == "len") return Quotient(Rational(static_cast<std::int64_t>(list(v[0]).size())));
    if (name == "join") {
      std::vector<Value> items = list(v[0]);
      items.insert(items.end(), list(v[1]).begin(), list(v[1]).end());
      return items;
    }
    if (name == "max" || name == "min") {
      std::vector<Rational> numbers;
      for (const Value& item : list(v[0])) numbers.push_back(number(scalar(item)));
      need(!numbers.empty(), name + " of nothing");
      return Quotient(name == "max" ? *std::max_element(numbers.begin(), numbers.end())
                                    : *std::min_element(numbers.begin(), numbers.end()));
    }
    const Rational a = number(scalar(v[0]));
    if (name == "abs") return Quotient(abs(a));
    if (name == "floor") return Quotient(floor(a));
    if (name == "less") return Quotient(Rational(a < number(scalar(v[1])) ? 1 : 0));
    if (name == "mod") {
      const Rational b = number(scalar(v[1]));
      need(b.sign() != 0, "division by zero");
      return Quotient(a - b * floor(a / b));
    }
    throw Rejected("unknown function " + name);
  }

  const Names& names_;
  int depth_ = 0;
};

}  // namespace

bool is_built_in(const std::string& name) {
  static const std::set<std::string> names{"if",  "seq",  "sum",   "coef", "subst", "diff",
                                           "low", "high", "det",   "len",  "join",  "less",
                                           "abs", "mod",  "floor", "max",  "min"};
  return names.contains(name);
}

const Quotient& scalar(const Value& v) {
  need(!v.is_list(), "a list stands where a number is needed");
  return v.number();
}

const std::vector<Value>& list(const Value& v) {
  need(v.is_list(), "a number stands where a list is needed");
  return v.items();
}

Value operator+(const Value& a, const Value& b) {
  return each([](const Quotient& x, const Quotient& y) { return x + y; }, a, b);
}
Value operator-(const Value& a, const Value& b) {
  return each([](const Quotient& x, const Quotient& y) { return x - y; }, a, b);
}

Value operator*(const Value& a, const Value& b) {
  if (!a.is_list() && !b.is_list()) return a.number() * b.number();
  std::vector<Value> result;
  if (!a.is_list()) {
    for (const Value& x : b.items()) result.push_back(a * x);
    return result;
  }
  if (!b.is_list()) return b * a;
  need(!a.items().empty() && !b.items().empty(), "an empty list in a product");
  if (a.items()[0].is_list()) {
    for (const Value& row : a.items()) result.push_back(row * b);
    return result;
  }
  if (b.items()[0].is_list()) {
    const Value columns = transposed(b);
    for (const Value& column : columns.items()) result.push_back(a * column);
    return result;
  }
  need(a.items().size() == b.items().size(), "lists of different lengths");
  Quotient sum;
  for (std::size_t i = 0; i < a.items().size(); ++i) sum = sum + scalar(a.items()[i]) * scalar(b.items()[i]);
  return sum;
}

Value transposed(const Value& matrix) {
  need(!list(matrix).empty(), "an empty list where a matrix is needed");
  std::vector<std::vector<Value>> columns(list(matrix.items()[0]).size());
  for (const Value& row : matrix.items()) {
    need(list(row).size() == columns.size(), "rows of different lengths");
    for (std::size_t j = 0; j < columns.size(); ++j) columns[j].push_back(row.items()[j]);
  }
  return std::vector<Value>(columns.begin(), columns.end());
}

/// Laplace's expansion row by row, the sum kept by the set of columns used.
Quotient determinant(const Value& matrix) {
  const std::size_t n = list(matrix).size();
  need(n <= 20, "a determinant is too large");
  std::map<std::uint32_t, Quotient> minors{{0, Quotient(Rational(1))}};
  for (const Value& row : matrix.items()) {
    need(list(row).size() == n, "a square matrix is needed");
    std::map<std::uint32_t, Quotient> next;
    for (const auto& [used, minor] : minors) {
      for (std::size_t j = 0; j < n; ++j) {
        const Quotient& entry = scalar(row.items()[j]);
        if ((used >> j & 1U) != 0 || entry.above.empty()) continue;
        const Quotient sign(Rational(std::popcount(used >> j) % 2 == 0 ? 1 : -1));
        Quotient& sum = next[used | 1U << j];
        sum = sum + sign * minor * entry;
      }
    }
    minors = std::move(next);
  }
  const auto full = minors.find((1U << n) - 1);
  return full == minors.end() ? Quotient() : full->second;
}

Value evaluate(const Term& term, const Names& names) { return Evaluation(names).value(term, {}); }

}  // namespace subdiv::verifier
