// Hoelder exponents by invariant polytopes, proved to 10 digits and more, beside the norm of the 20th power,
// which bounds the same number within some percent. One run gives the ratio:
//   benchmarks --benchmark_filter=hoelder

#include <benchmark/benchmark.h>

#include "analysis/hoelder.h"
#include "analysis/iterate_norm.h"
#include "schemes/deslauriers_dubuc.h"
#include "schemes/dyn_floater_hormann.h"
#include "schemes/jspline.h"
#include "tests/analysis/daubechies.h"

namespace subdiv {
namespace {

/// The width that was reached is shown with the time.
void measure(benchmark::State& state, const auto& form) {
  double width = 0;
  for (auto _ : state) width = smoothness_report(form).limits.exponent.width().to_double();
  state.counters["width"] = width;
}

void hoelder_daubechies(benchmark::State& state) {
  measure(state, testing::daubechies(static_cast<int>(state.range(0))));
}

void hoelder_deslauriers_dubuc(benchmark::State& state) {
  measure(state, normal_form(deslauriers_dubuc<Rational>(static_cast<int>(state.range(0)))));
}

/// The leading product has complex eigenvalues.
void hoelder_dyn_floater_hormann(benchmark::State& state) {
  measure(state, normal_form(dyn_floater_hormann(Rational(27, 2000))));
}

void hoelder_jspline(benchmark::State& state) {
  measure(state, normal_form(jspline(Rational(689, 1000), Rational(689, 1000))));
}

void hoelder_of_power_20(benchmark::State& state) {
  const NormalForm<Rational> form = normal_form(dyn_floater_hormann(Rational(27, 2000)));
  constexpr int power = 20;
  for (auto _ : state) benchmark::DoNotOptimize(iterate_norm_enclosure(form.b, form.arity, power));
}

BENCHMARK(hoelder_daubechies)->DenseRange(2, 10, 2)->Unit(benchmark::kMillisecond);
BENCHMARK(hoelder_deslauriers_dubuc)->DenseRange(4, 10, 2)->Unit(benchmark::kMillisecond);
BENCHMARK(hoelder_dyn_floater_hormann)->Unit(benchmark::kMillisecond);
BENCHMARK(hoelder_jspline)->Unit(benchmark::kMillisecond);
BENCHMARK(hoelder_of_power_20)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace subdiv
