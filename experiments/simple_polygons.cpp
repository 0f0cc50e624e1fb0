#include "experiments/simple_polygons.h"

#include <filesystem>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "experiments/data.h"
#include "experiments/polygon_file.h"
#include "schemes/input_error.h"

namespace subdiv {
namespace {

std::vector<PlanePolygon> read_family() {
  const std::filesystem::path path = data_folder() / "simple-polygons.csv";
  const PointList<Rational> points = read_points<Rational>(path);
  if (points.dimension() != 3) throw InputError(path.string() + ": expected lines polygon,x,y");
  std::vector<PlanePolygon> family;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Rational& number = points.coordinates[0][i];
    if (number == Rational(static_cast<std::int64_t>(family.size()) + 1)) family.emplace_back();
    if (family.empty() || number != Rational(static_cast<std::int64_t>(family.size()))) {
      throw InputError(
          fmt::format("{}: point {}: polygon {} is out of order", path.string(), i + 1, number.to_string()));
    }
    family.back().emplace_back(points.coordinates[1][i], points.coordinates[2][i]);
  }
  return family;
}

}  // namespace

const std::vector<PlanePolygon>& simple_polygons() {
  static const std::vector<PlanePolygon> family = read_family();
  return family;
}

Polyline in_double(const PlanePolygon& polygon) {
  std::vector<std::vector<double>> coordinates(2);
  for (const auto& [x, y] : polygon) {
    coordinates[0].push_back(x.to_double());
    coordinates[1].push_back(y.to_double());
  }
  return make_polyline(std::move(coordinates), true);
}

const std::string& simple_polygons_text() {
  static const std::string text =
      "the 200 simple polygons of data/simple-polygons.csv (4 to 12 vertices, seed 20080229)";
  return text;
}

Claim settle_share(const ClaimHead& head, int count, int total, std::string note, Rigour rigour) {
  Enclosure value = exact(Rational(count, total), "counted");
  value.rigour = rigour;
  const std::string counted =
      fmt::format("So it is on {} of {}.{}{}", count, total, note.empty() ? "" : " ", note);
  if (!head.printed) {
    const Verdict verdict = rigour == Rigour::approximate ? Verdict::undecided : Verdict::established;
    return settle_as(head, verdict, value, counted);
  }
  const bool holds = 2 * count > total;
  if (rigour == Rigour::approximate)
    return settle_as(head, holds ? Verdict::consistent : Verdict::inconsistent, value, counted);
  return settle_as(head, holds ? Verdict::reproduced : Verdict::refuted, value, counted);
}

}  // namespace subdiv
