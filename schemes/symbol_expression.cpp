#include "schemes/symbol_expression.h"

namespace subdiv {

WrittenProduct written_product(const Expression& expression) {
  using Kind = Expression::Kind;
  WrittenProduct result;
  std::vector<WrittenFactor> pending{{expression.root(), 1}};
  while (!pending.empty()) {
    const WrittenFactor factor = pending.back();
    pending.pop_back();
    const Expression::Node& node = expression.nodes()[factor.root];
    switch (node.kind) {
      case Kind::multiply:
        pending.push_back({node.right, factor.power});
        pending.push_back({node.left, factor.power});
        break;
      case Kind::divide:
        pending.push_back({node.right, -factor.power});
        pending.push_back({node.left, factor.power});
        break;
      case Kind::negate:
        if (factor.power % 2 != 0) result.sign = -result.sign;
        pending.push_back({node.left, factor.power});
        break;
      case Kind::power:
        if (node.exponent != 0) pending.push_back({node.left, factor.power * node.exponent});
        break;
      default:
        result.factors.push_back(factor);
    }
  }
  return result;
}

}  // namespace subdiv
