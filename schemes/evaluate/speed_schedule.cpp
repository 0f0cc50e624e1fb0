#include "schemes/evaluate/speed_schedule.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "schemes/input_error.h"

namespace subdiv {
namespace {

/// Speeds are at least 2^-64 from 0 and 1, weights at most 2^400: far more digits are left than double has.
constexpr long precision = 1024;
constexpr long finest = 64;

SectorStencil<double> rounded(const SectorStencil<Interval>& stencil) {
  SectorStencil<double> result{stencil.centre.to_double(), {}};
  for (const auto& term : stencil.terms)
    result.terms.push_back({term.sector, term.place, term.weight.to_double()});
  return result;
}
std::vector<SectorStencil<double>> rounded(const std::vector<SectorStencil<Interval>>& stencils) {
  std::vector<SectorStencil<double>> result;
  for (const auto& stencil : stencils) result.push_back(rounded(stencil));
  return result;
}
SpeedStep<double> rounded(const SpeedStep<Interval>& step) {
  SpeedStep<double> result{rounded(step.change),
                           {step.rules.sigma.to_double(), rounded(step.rules.refined), {}}};
  for (std::size_t k = 0; k < step.rules.border.size(); ++k) {
    if (step.rules.border[k]) result.rules.border[k] = rounded(*step.rules.border[k]);
  }
  return result;
}

/// As it stands in messages, where hundreds of digits say nothing.
std::string shown(const Algebraic& sigma) {
  constexpr std::size_t most = 60;
  constexpr int digits = 6;
  std::string text = sigma.to_string();
  if (text.size() <= most) return text;
  return "near " + to_significant(sigma.to_interval().midpoint(), digits);
}

/// A bound of the points at a place, the same in all sectors, and of their errors; all but `tiny` times the
/// greatest coordinate.
struct Size {
  double magnitude = 0;
  double error = 0;
  double tiny = 0;  // the errors of underflow, times the least positive double
};
/// Rounding to nearest is off by at most this times the number.
constexpr double unit = std::numeric_limits<double>::epsilon() / 2;

/// The net in bounds: the vertex and the places of a sector.
struct NetSize {
  Size centre;
  std::array<Size, SectorNet<double>::places> places;
};

/// A sum of `terms` products: each weight, product and partial sum is off by less than a unit, and a product
/// that underflows by less than the least positive double; sums do not underflow.
class SumSize {
 public:
  void add(double weight, const Size& point) {
    sum_.magnitude += std::abs(weight) * point.magnitude;
    sum_.error += std::abs(weight) * point.error;
    sum_.tiny += std::abs(weight) * point.tiny;
    ++terms_;
  }
  [[nodiscard]] Size get() const {
    const double relative = (terms_ + 2) * unit;
    // The last factor covers the rounding of these sums themselves.
    return {sum_.magnitude * (1 + 2 * relative),
            (sum_.error + relative * sum_.magnitude) * (1 + 2 * relative),
            (sum_.tiny + terms_) * (1 + 2 * relative)};
  }

 private:
  Size sum_;
  double terms_ = 0;
};

Size size_of(const SectorStencil<double>& stencil, const NetSize& net) {
  SumSize sum;
  sum.add(stencil.centre, net.centre);
  for (const auto& term : stencil.terms)
    sum.add(term.weight, net.places[static_cast<std::size_t>(term.place)]);
  return sum.get();
}

void change_places(NetSize& net, const std::vector<SectorStencil<double>>& stencils) {
  const NetSize before = net;
  for (std::size_t p = 0; p < stencils.size(); ++p) net.places[p] = size_of(stencils[p], before);
}

/// The vertex by its rule: sums of n points each, of equal weights.
Size centre_size(const NetSize& net, const VertexWeights<double>& weights, int valence) {
  const double n = valence;
  SumSize sum;
  sum.add(1 - weights.beta - weights.gamma, net.centre);
  for (int sector = 0; sector < valence; ++sector) {
    sum.add(weights.beta / n, net.places[static_cast<std::size_t>(sector_place(1, 0).place)]);
    sum.add(weights.gamma / n, net.places[static_cast<std::size_t>(sector_place(1, 1).place)]);
  }
  Size result = sum.get();
  // The vertex's own share is the difference of rounded numbers.
  result.error += 4 * unit * net.centre.magnitude;
  return result;
}

/// Raises the bound to what the border of a net and its parts are off.
void include_border(RoundingBound& bound, const RingRules<double>& rules, const NetSize& net) {
  Size worst;
  for (const auto& stencil : rules.border) {
    if (!stencil) continue;
    const Size size = size_of(*stencil, net);
    worst.magnitude = std::max(worst.magnitude, size.magnitude);
    worst.error = std::max(worst.error, size.error);
    worst.tiny = std::max(worst.tiny, size.tiny);
  }
  // De Casteljau's means split it, three levels in each direction. At each the weights sigma and 1 - sigma
  // are off by two units together, products and sum by one each, and two products may underflow.
  constexpr double levels = 6;
  bound.relative = std::max(bound.relative, worst.error + 4 * levels * unit * worst.magnitude);
  bound.tiny = std::max(bound.tiny, worst.tiny + 2 * levels);
}

double above(double x) { return std::nextafter(x, std::numeric_limits<double>::infinity()); }

}  // namespace

SpeedSchedule::SpeedSchedule(std::vector<Algebraic> speeds) : speeds_(std::move(speeds)) {
  const Algebraic least(Rational::power_of_two(-finest));
  double outside = 1;
  for (const Algebraic& sigma : speeds_) {
    const Algebraic rest = Algebraic(1) - sigma;
    if (sigma.sign() <= 0 || rest.sign() <= 0) {
      throw InputError(fmt::format(
          "speed {}: speeds lie between 0 and 1, both excluded; 1/2 is Catmull-Clark's", shown(sigma)));
    }
    if (sigma < least || rest < least) {
      throw InputError(
          fmt::format("speed {}: so near {} nothing of a ring is left in double; keep 2^-{} away",
                      shown(sigma), sigma < least ? 0 : 1, finest));
    }
    enclosures_.push_back(sigma.to_interval(precision));
    least_width_ = std::min(least_width_, outside * enclosures_.back().to_double());
    outside *= rest.to_interval(precision).to_double();
    least_width_ = std::min(least_width_, outside);
  }
  for (std::size_t k = 0; k < speeds_.size(); ++k) {
    // As speed_steps does, but equal speeds are told by their exact values.
    if (k > 0 && speeds_[k] == speeds_[k - 1]) {
      steps_.push_back({{}, steps_.back().rules});
      continue;
    }
    const LineKnots<Interval> before =
        k == 0 ? uniform_knots<Interval>() : unit_speed_knots(enclosures_[k - 1]);
    steps_.push_back(rounded(SpeedStep<Interval>{changed_places(before, unit_speed_knots(enclosures_[k])),
                                                 ring_rules(enclosures_[k])}));
  }
}

std::vector<VertexWeights<double>> SpeedSchedule::weights(int valence) const {
  std::vector<VertexWeights<double>> result;
  for (const Interval& sigma : enclosures_) {
    const VertexWeights<Interval> exact = vertex_weights(sigma, valence);
    result.push_back({exact.beta.to_double(), exact.gamma.to_double()});
  }
  return result;
}

RoundingBound SpeedSchedule::rounding(int valence) const {
  NetSize net;
  net.centre.magnitude = 1;
  for (Size& place : net.places) place.magnitude = 1;
  RoundingBound bound;
  const std::vector<VertexWeights<double>> of_vertex = weights(valence);
  for (std::size_t k = 0; k < steps_.size(); ++k) {
    change_places(net, steps_[k].change);
    if (k == 0) include_border(bound, steps_[k].rules, net);  // later on it is the one of the step before
    const Size centre = centre_size(net, of_vertex[k], valence);
    change_places(net, steps_[k].rules.refined);
    net.centre = centre;
    include_border(bound, steps_[k].rules, net);
  }
  return bound;
}

double RoundingBound::of(double greatest) const {
  return above(above(relative * greatest) + above(tiny * std::numeric_limits<double>::denorm_min()));
}

}  // namespace subdiv
