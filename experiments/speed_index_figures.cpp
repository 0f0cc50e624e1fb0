#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "experiments/speed_figure_parts.h"
#include "experiments/speed_printed.h"

namespace subdiv {
namespace {

using Function = RationalFunction;
using Line = std::vector<Spot>;

const Function s = Function::variable(0);
const Function q = Function(1) - s;

Spot direction(double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  return {std::cos(angle), std::sin(angle)};
}

/// The mean of the three knots of P_0, P_1, P_2; a = 1.
std::array<Function, 3> mean_knots() {
  const LineKnots<Function> knots = unit_speed_knots(s);
  return {Function(0), (knots[0] + knots[1]) / Function(3), (knots[0] + knots[1] + knots[2]) / Function(3)};
}

/// The nets of the first sectors as lines.
std::vector<Line> net_lines(Spot centre, int sectors, int rings, double unit) {
  std::vector<Line> lines;
  for (int k = 0; k < sectors; ++k) {
    for (int a = 0; a <= rings; ++a) {
      Line along;
      Line across;
      for (int b = 0; b <= rings; ++b) {
        along.push_back(in_sector(centre, k, unit * a, unit * b));
        across.push_back(in_sector(centre, k, unit * b, unit * a));
      }
      lines.push_back(std::move(along));
      lines.push_back(std::move(across));
    }
  }
  return lines;
}

/// The points p^ij that rules of sector 0 may read, with their labels.
std::vector<NamedSpot> labelled_net(Spot centre, double unit) {
  std::vector<NamedSpot> dots;
  for (int i = 1; i <= 4; ++i) {
    for (int j = 1; j <= 4; ++j) {
      if (i == 4 && j == 4) continue;
      const SectorPlace at = sector_place(3 - i, 3 - j);
      double a = 0;
      double b = 0;
      if (at.place >= 0) {
        const FanPlace place = sector_places(4, 2)[static_cast<std::size_t>(at.place)];
        a = unit * place.a;
        b = unit * place.b;
      }
      dots.push_back({fmt::format("{}{}", i, j), in_sector(centre, at.sector, a, b)});
    }
  }
  return dots;
}

}  // namespace

Spot in_sector(Spot centre, int k, double a, double b) {
  constexpr double turn = 360.0 / drawn_valence;
  const double first = 90 - turn / 2 + turn * k;
  return centre + a * direction(first) + b * direction(first + turn);
}

// Quarter turns take sectors to each other.
SectorNet<SymbolicPoint> mean_net() {
  const std::array<Function, 3> mean = mean_knots();
  std::vector<SymbolicPoint> points{{Function(0), Function(0)}};
  for (int k = 0; k < 4; ++k) {
    for (const FanPlace& place : sector_places(4, 2)) {
      SymbolicPoint p{mean.at(static_cast<std::size_t>(place.a)), mean.at(static_cast<std::size_t>(place.b))};
      for (int turn = 0; turn < k; ++turn) p = {-p[1], p[0]};
      points.push_back(std::move(p));
    }
  }
  return {4, std::move(points)};
}

bool equal_steps(const BezierPatch<SymbolicPoint>& patch, const SymbolicPoint& from,
                 const SymbolicPoint& size, std::size_t count) {
  bool equal = true;
  for (std::size_t k = 0; k < count; ++k) {
    const Function i = fraction<Function>(static_cast<long>(k / 4), 3);
    const Function j = fraction<Function>(static_cast<long>(k % 4), 3);
    equal = equal && patch[k][0] == from[0] - i * size[0] && patch[k][1] == from[1] - j * size[1];
  }
  return equal;
}

void add_speed_indices(Results& results, std::span<const ClaimHead> heads) {
  const auto net = mean_net();
  const auto refined = refined_net(net, ring_rules(s), vertex_weights(s, 4));
  bool follows = true;
  constexpr int inner_numbers = 7;
  for (int k = 1; k <= inner_numbers; ++k) {
    const int label = label_of_number(k);
    const SectorPlace at = sector_place(3 - label / 10, 3 - label % 10);
    const auto& coarse = at.place < 0 ? net.centre() : net.at(at.sector, at.place);
    const auto& fine = at.place < 0 ? refined.centre() : refined.at(at.sector, at.place);
    follows = follows && fine[0] == q * coarse[0] && fine[1] == q * coarse[1];
  }
  results.claims.push_back(
      settle_statement(head(heads, "figure.speed.5"), follows, "p̃_k = σ̄ p^ij, k = 1 .. 7"));

  PlaneDiagram diagram("speed-indices", "Indices ij of the net, and k of the refined one");
  const Spot left{0, 0};
  const Spot right{8.6, 0};
  constexpr double unit = 1.15;
  constexpr double fine_unit = 0.95;
  std::vector<NamedSpot> numbers;
  constexpr int count = 13;
  for (int k = 1; k <= count; ++k) {
    const int a = 3 - label_of_number(k) / 10;
    const int b = 3 - label_of_number(k) % 10;
    numbers.push_back({std::to_string(k), in_sector(right, 0, fine_unit * a, fine_unit * b)});
  }
  diagram.add_lines("net", net_lines(left, drawn_valence, 2, unit), style::thin);
  diagram.add_lines("refined", net_lines(right, drawn_valence, 3, fine_unit), style::thin);
  diagram.add_lines("net-sector", net_lines(left, 1, 2, unit), style::line);
  diagram.add_lines("refined-sector", net_lines(right, 1, 3, fine_unit), style::line);
  diagram.add_dots("labels", labelled_net(left, unit), style::dot);
  diagram.add_dots("numbers", numbers, style::dot);
  diagram.add_text("net p, labels ij", {left.x, -4.6});
  diagram.add_text("refined net, numbers k", {right.x, -4.6});
  diagram.add_to(results, {"figure.speed.5"});
}

void add_speed_border_indices(Results& results, std::span<const ClaimHead> heads) {
  const BezierPatch<SymbolicPoint> border = border_points(mean_net(), ring_rules(s), 0);
  const Function one(1);
  results.claims.push_back(settle_statement(
      head(heads, "figure.speed.10"), equal_steps(border, {one, one}, {one, one}, 15), "15 points t_ij"));

  PlaneDiagram diagram("speed-border-indices",
                       "Indices of the net p, and of the tensor border t of one sector");
  const Spot left{0, 0};
  const Spot right{7, -1.6};
  constexpr double unit = 1.15;
  constexpr double border_unit = 1.2;
  std::vector<NamedSpot> dots;
  for (int i = 0; i <= 3; ++i) {
    for (int j = 0; j <= 3; ++j) {
      if (i < 3 || j < 3)
        dots.push_back(
            {fmt::format("{}{}", i, j), in_sector(right, 0, border_unit * (3 - i), border_unit * (3 - j))});
    }
  }
  std::vector<Line> lines;
  for (int a = 0; a <= 3; ++a) {
    const auto spot = [&](int x, int y) { return in_sector(right, 0, border_unit * x, border_unit * y); };
    lines.push_back({spot(a, a == 0 ? 1 : 0), spot(a, 3)});
    lines.push_back({spot(a == 0 ? 1 : 0, a), spot(3, a)});
  }
  diagram.add_lines("net", net_lines(left, drawn_valence, 2, unit), style::thin);
  diagram.add_lines("net-sector", net_lines(left, 1, 2, unit), style::line);
  diagram.add_lines("border", lines, style::line);
  diagram.add_dots("labels", labelled_net(left, unit), style::dot);
  diagram.add_dots("indices", dots, style::dot);
  diagram.add_text("net p, labels rs", {left.x, -3.5});
  diagram.add_text("tensor border t, indices ij", {right.x, -3.5});
  diagram.add_to(results, {"figure.speed.10"});
}

}  // namespace subdiv
