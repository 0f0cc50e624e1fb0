#include "experiments/certificates/find_cover.h"

#include <algorithm>
#include <cmath>

namespace subdiv {
namespace {

using verifier::Cell;
using verifier::Condition;
using verifier::Cover;

/// The axis along which coefficients differ most, times the degree, or nothing for constants.
std::size_t widest_axis(const Cover& cover, const Cell& cell) {
  std::size_t best = 0;
  double most = -1;
  std::size_t step = cell.coefficients[0].size();
  for (std::size_t axis = 0; axis < cover.degrees.size(); ++axis) {
    const std::size_t length = static_cast<std::size_t>(cover.degrees[axis]) + 1;
    step /= length;
    double variation = 0;
    for (const auto& table : cell.coefficients) {
      for (std::size_t i = 0; i + step < table.size(); ++i) {
        if (i / step % length == length - 1) continue;
        variation = std::max(variation, std::fabs(table[i + step].to_double() - table[i].to_double()));
      }
    }
    variation *= static_cast<double>(length);
    if (variation > most) {
      most = variation;
      best = axis;
    }
  }
  return best;
}

class Search {
 public:
  Search(const Cover& cover, std::size_t most_cells) : cover_(cover), left_(most_cells) {}

  void run(const Cell& cell, int depth) {
    if (left_ == 0 || depth > 60) throw verifier::Rejected("no cover was found");
    --left_;
    if (const std::string token = holding_token(cell); !token.empty()) {
      tokens_ += (tokens_.empty() ? "" : " ") + token;
      return;
    }
    if (cover_.names.empty()) throw verifier::Rejected("the sign is wrong");
    const std::size_t axis = widest_axis(cover_, cell);
    tokens_ += (tokens_.empty() ? "" : " ") + cover_.names[axis];
    const auto [first, second] = verifier::halves(cover_, cell, axis);
    run(first, depth + 1);
    run(second, depth + 1);
  }
  [[nodiscard]] const std::string& tokens() const { return tokens_; }

 private:
  [[nodiscard]] std::string holding_token(const Cell& cell) const {
    if (cover_.condition != Condition::peak) return verifier::holds(cover_, cell, ".") ? "." : "";
    for (std::size_t entry = 0; entry + 1 < cell.coefficients.size(); ++entry) {
      for (const char* sign : {"+", "-"}) {
        std::string token = sign + std::to_string(entry);
        if (verifier::holds(cover_, cell, token)) return token;
      }
    }
    return "";
  }

  const Cover& cover_;
  std::size_t left_;
  std::string tokens_;
};

}  // namespace

std::string find_cover(const Cover& cover, const Cell& cell, std::size_t most_cells) {
  Search search(cover, most_cells);
  search.run(cell, 0);
  return search.tokens();
}

}  // namespace subdiv
