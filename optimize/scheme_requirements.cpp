#include "optimize/scheme_requirements.h"

#include <fmt/format.h>

#include "schemes/input_error.h"

namespace subdiv {

void lacks(const std::string& objective, const Scheme<RationalFunction>& scheme, const std::string& what) {
  throw InputError(fmt::format("objective {} and scheme {}: {}", objective, scheme.name, what));
}

RationalFunction limit_mean(const Scheme<RationalFunction>& scheme) {
  RationalFunction mean;
  bool is_last = true;
  for (auto step = scheme.steps.rbegin(); step != scheme.steps.rend(); ++step) {
    const RationalFunction own = sum(euler_derivative(step->symbol)) / sum(step->symbol);
    mean = is_last ? own / RationalFunction(scheme.arity() - 1)
                   : (mean + own) / RationalFunction(scheme.arity());
    is_last = false;
  }
  return mean;
}

void require_binary(const std::string& objective, const Scheme<RationalFunction>& scheme) {
  if (scheme.arity() == 2) return;
  lacks(objective, scheme, fmt::format("the objective needs arity 2, the scheme has {}", scheme.arity()));
}

void require_steps(const std::string& objective, const Scheme<RationalFunction>& scheme) {
  for (const Mask<RationalFunction>& step : scheme.steps) {
    const RationalFunction total = sum(step.symbol);
    if (total == RationalFunction(scheme.arity())) continue;
    lacks(
        objective, scheme,
        fmt::format("the coefficients of a step add up to {}, not to {}", total.to_string(), scheme.arity()));
  }
}

Rational constant_centre(const std::string& objective, const Scheme<RationalFunction>& scheme,
                         const RationalFunction& centre) {
  if (!centre.is_constant()) {
    lacks(objective, scheme, "the mask's centre moves with the parameters: " + centre.to_string());
  }
  return centre.constant();
}

void require_primal(const std::string& objective, const Scheme<RationalFunction>& scheme) {
  const Rational centre = constant_centre(objective, scheme, limit_mean(scheme));
  if (centre.sign() == 0) return;
  lacks(objective, scheme,
        fmt::format("the objective needs a primal scheme, centred at index 0; this one's centre is {}",
                    centre.to_string()));
}

}  // namespace subdiv
