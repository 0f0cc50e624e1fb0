#include "experiments/simple_polygons.h"

#include <filesystem>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

#include "experiments/report/csv.h"
#include "experiments/report/files.h"
#include "schemes/input_error.h"

namespace subdiv {
namespace {

std::vector<PlanePolygon> read_family() {
  const std::filesystem::path path = std::filesystem::path(SUBDIVLAB_DATA_DIR) / "simple-polygons.csv";
  const CsvRows rows = from_csv(read_file(path));
  std::vector<PlanePolygon> family;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    try {
      if (rows[i].size() != 3) throw std::invalid_argument(fmt::format("it has {} columns", rows[i].size()));
      const Rational number = Rational::parse(rows[i][0]);
      if (number == Rational(static_cast<std::int64_t>(family.size()) + 1)) family.emplace_back();
      if (family.empty() || number != Rational(static_cast<std::int64_t>(family.size())))
        throw std::invalid_argument("polygon " + rows[i][0] + " is out of order");
      family.back().emplace_back(Rational::parse(rows[i][1]), Rational::parse(rows[i][2]));
    } catch (const std::invalid_argument& error) {
      throw InputError(
          fmt::format("{}:{}: {}; a line holds polygon,x,y", path.string(), i + 1, error.what()));
    }
  }
  if (family.empty()) throw InputError(path.string() + ": no polygons");
  return family;
}

}  // namespace

const std::vector<PlanePolygon>& simple_polygons() {
  static const std::vector<PlanePolygon> family = read_family();
  return family;
}

const std::string& simple_polygons_text() {
  static const std::string text =
      "the 200 simple polygons of data/simple-polygons.csv (4 to 12 vertices, seed 20080229)";
  return text;
}

Claim settle_share(const ClaimHead& head, int count, int total, std::string note, Rigour rigour) {
  Enclosure value = exact(Rational(count, total), "counted");
  value.rigour = rigour;
  const std::string counted = fmt::format("{} of {}.{}{}", count, total, note.empty() ? "" : " ", note);
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
