// norm_k of a difference scheme beside the obvious loop. One run gives the ratio:
//   benchmarks --benchmark_filter=iterate_norm

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <benchmark/benchmark.h>

#include "analysis/iterate_norm.h"
#include "analysis/iterate_norm_range.h"
#include "schemes/jspline.h"

namespace subdiv {
namespace {

/// Expands D_k by scattering, level after level, then sums the residue classes: memory and time grow like n
/// 2^k.
double norm_by_scattering(const std::vector<double>& d, int k) {
  std::vector<double> product{1.0};
  for (int i = 0; i < k; ++i) {
    const std::size_t step = std::size_t{1} << i;
    std::vector<double> next(product.size() + step * (d.size() - 1), 0.0);
    for (std::size_t p = 0; p < product.size(); ++p) {
      for (std::size_t t = 0; t < d.size(); ++t) next[p + step * t] += product[p] * d[t];
    }
    product = std::move(next);
  }
  std::vector<double> sums(std::size_t{1} << k, 0.0);
  for (std::size_t p = 0; p < product.size(); ++p) sums[p & (sums.size() - 1)] += std::abs(product[p]);
  return *std::max_element(sums.begin(), sums.end());
}

/// The difference symbol of J_{-17/10}, seven taps before its division by (1+z)^(c+1).
Laurent<Rational> symbol(int continuity) {
  return difference_symbol(jspline(Rational(-17, 10)), continuity).value();
}

std::vector<double> in_double(const Laurent<Rational>& d) {
  std::vector<double> result;
  for (const Rational& c : d.coefficients()) result.push_back(c.to_double());
  return result;
}

void iterate_norm_obvious(benchmark::State& state) {
  const std::vector<double> d = in_double(symbol(static_cast<int>(state.range(1))));
  for (auto unused : state) benchmark::DoNotOptimize(norm_by_scattering(d, static_cast<int>(state.range(0))));
}

void iterate_norm_certified(benchmark::State& state) {
  const Laurent<Rational> d = symbol(static_cast<int>(state.range(1)));
  const auto k = static_cast<int>(state.range(0));
  const Enclosure norm = iterate_norm_enclosure(d, 2, k);
  const double middle = norm.midpoint().to_double();
  if (k <= 20 && std::abs(norm_by_scattering(in_double(d), k) - middle) > 1e-9 * middle) {
    state.SkipWithError("the two norms differ");
  }
  for (auto unused : state) benchmark::DoNotOptimize(iterate_norm_enclosure(d, 2, k));
}

void powers(benchmark::internal::Benchmark* b) {
  b->Unit(benchmark::kMillisecond)->ArgNames({"k", "continuity"});
  for (const long continuity : {0, 1, 2, 3}) b->Args({20, continuity});
}

void deep_powers(benchmark::internal::Benchmark* b) {
  powers(b);
  for (const long continuity : {0, 1, 2, 3}) b->Args({24, continuity});
}

/// The certified intervals of s for J_s and k = 1 .. 20.
void iterate_norm_intervals(benchmark::State& state) {
  NormRangeOptions options;
  options.interior = Rational(3, 2);
  const auto mask = jspline(RationalFunction::variable(0));
  const DifferenceFamily family = difference_family(mask, static_cast<int>(state.range(0)));
  for (auto unused : state) benchmark::DoNotOptimize(iterate_norm_ranges(family, options));
}

BENCHMARK(iterate_norm_obvious)->Apply(powers);
BENCHMARK(iterate_norm_certified)->Apply(deep_powers);
BENCHMARK(iterate_norm_intervals)->Unit(benchmark::kMillisecond)->ArgName("continuity")->DenseRange(1, 3);

}  // namespace
}  // namespace subdiv
