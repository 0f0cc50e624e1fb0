#include "experiments/cli/local_estimates.h"

#include <cmath>
#include <iostream>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "analysis/polyloop/local_geometry.h"
#include "experiments/report/utf8.h"
#include "schemes/input_error.h"

namespace subdiv::cli {
namespace {

using Json = nlohmann::ordered_json;

/// One vertex, and the edge that begins there where it has a jerk.
struct Row {
  std::size_t vertex = 0;  // from 0, as the points come
  VertexGeometry at;
  std::vector<double> jerk;  // empty where the edge has no neighbours on both sides
  double normal_jerk = 0;
};

std::vector<Row> rows_of(const Polyline& polyline) {
  require_local_estimates(polyline);
  const bool closed = polyline.topology.closed;
  const std::vector<VertexGeometry> vertices = vertex_geometry(polyline);
  const std::vector<std::vector<double>> jerks = edge_jerks(polyline);
  const std::vector<double> normal = normal_jerks(polyline);
  std::vector<Row> rows;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    Row row{i + (closed ? 0 : 1), vertices[i], {}, 0};
    if (i < jerks.size()) {
      row.jerk = jerks[i];
      row.normal_jerk = normal[i];
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

/// Numbers as strings that read back as the same doubles; "inf" for infinite radii.
std::string number(double x) { return fmt::format("{}", x); }

Json list(std::span<const double> values) {
  Json json = Json::array();
  for (const double x : values) json.push_back(number(x));
  return json;
}

/// x + 0 shows no -0.
std::string joined_numbers(std::span<const double> values) {
  std::string text;
  for (const double x : values) text += fmt::format("{}{:.8g}", text.empty() ? "" : " ", x + 0.0);
  return text.empty() ? "-" : text;
}

}  // namespace

void require_local_estimates(const Polyline& polyline) {
  constexpr std::size_t least = 3;
  const std::size_t n = curve_size(polyline.topology);
  const bool closed = polyline.topology.closed;
  if (!closed && n < least) {
    throw InputError(
        fmt::format("--local: no vertex of an open polygon of {} points lies between two others; give at "
                    "least {}, or leave --open out",
                    n, least));
  }
  std::size_t vertex = closed ? 0 : 1;
  for (const VertexGeometry& at : vertex_geometry(polyline)) {
    if (!std::isfinite(at.circle_curvature) || !std::isfinite(at.parabola_curvature)) {
      throw InputError(fmt::format(
          "--local: the curvature at vertex {} (from 0) is beyond the range of doubles (1.8e308): "
          "its neighbours are too near to each other; scale the points",
          vertex));
    }
    ++vertex;
  }
}

Json local_estimates_json(const Polyline& polyline) {
  Json json = Json::array();
  for (const Row& row : rows_of(polyline)) {
    Json at = {{"vertex", row.vertex},
               {"velocity", list(row.at.velocity)},
               {"acceleration", list(row.at.acceleration)},
               {"tangent", list(row.at.tangent)},
               {"normal", list(row.at.normal)},
               {"circle_radius", number(row.at.circle_radius())},
               {"parabola_radius", number(row.at.parabola_radius())},
               {"circle_curvature", number(row.at.circle_curvature)},
               {"parabola_curvature", number(row.at.parabola_curvature)}};
    if (!row.jerk.empty()) {
      at["jerk"] = list(row.jerk);
      at["normal_jerk"] = number(row.normal_jerk);
    }
    json.push_back(std::move(at));
  }
  return json;
}

void print_local_estimates(const Polyline& polyline) {
  const std::vector<Row> rows = rows_of(polyline);
  constexpr std::size_t narrow = 8;
  constexpr std::size_t wide = 17;
  constexpr std::size_t coordinate = 16;
  const std::size_t vector = 2 + coordinate * std::max<std::size_t>(polyline.coordinates.size(), 1);
  std::cout << padded("vertex", narrow) << padded("velocity", vector) << padded("acceleration", vector)
            << padded("radius, circle", wide) << padded("radius, parabola", wide)
            << padded("jerk of the next edge", vector) << "its normal part\n";
  for (const Row& row : rows) {
    std::cout << padded(std::to_string(row.vertex), narrow) << padded(joined_numbers(row.at.velocity), vector)
              << padded(joined_numbers(row.at.acceleration), vector)
              << padded(fmt::format("{:.8g}", row.at.circle_radius()), wide)
              << padded(fmt::format("{:.8g}", row.at.parabola_radius()), wide)
              << padded(joined_numbers(row.jerk), vector)
              << (row.jerk.empty() ? "-" : fmt::format("{:.8g}", row.normal_jerk + 0.0)) << "\n";
  }
}

}  // namespace subdiv::cli
