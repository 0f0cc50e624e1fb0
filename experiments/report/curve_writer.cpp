#include "experiments/report/curve_writer.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "schemes/input_error.h"

namespace subdiv {
namespace {

constexpr std::size_t space_dimension = 3;
using Block = CurveBlock<double>;

void require_dimension(const CurveBlocks<double>& curve, bool possible, const std::string& what) {
  if (!possible) {
    throw InputError(
        fmt::format("the points have {} coordinates; {}; write .csv instead", curve.dimension(), what));
  }
}

template <class Visit>
void for_each_point(const CurveBlocks<double>& curve, Visit visit) {
  curve.for_each_block(0, curve.size(), [&](const Block& block) {
    for (std::size_t k = 0; k < block.count; ++k) visit(block.first + k, block.coordinates, k);
  });
}

void write_csv(OutputFile& file, const CurveBlocks<double>& curve) {
  const std::size_t dimension = curve.dimension();
  std::string text;
  for (std::size_t c = 0; c < dimension; ++c) {
    text += c == 0 ? "" : ",";
    text += dimension > space_dimension ? fmt::format("x{}", c + 1) : std::string(1, "xyz"[c]);
  }
  file.write(text + "\n");
  for_each_point(curve, [&](std::size_t, const auto& coordinates, std::size_t k) {
    text.clear();
    for (std::size_t c = 0; c < dimension; ++c) {
      append_number(text, coordinates[c][k]);
      text += c + 1 < dimension ? ',' : '\n';
    }
    file.write(text);
  });
}

void write_obj(OutputFile& file, const CurveBlocks<double>& curve, bool closed) {
  require_dimension(curve, curve.dimension() <= space_dimension, "an .obj file holds three");
  std::string text;
  for_each_point(curve, [&](std::size_t, const auto& coordinates, std::size_t k) {
    text = "v";
    for (std::size_t c = 0; c < space_dimension; ++c) {
      text += ' ';
      append_number(text, c < curve.dimension() ? coordinates[c][k] : 0);
    }
    file.write(text + "\n");
  });
  constexpr std::size_t per_line = 4096;  // readers take whole lines into memory
  const std::size_t segments = curve.size() - (closed ? 0 : 1);
  for (std::size_t begin = 0; begin < segments; begin += per_line) {
    text = "l";
    const std::size_t end = std::min(segments, begin + per_line);
    for (std::size_t i = begin; i <= end; ++i)
      fmt::format_to(std::back_inserter(text), " {}", i % curve.size() + 1);
    file.write(text + "\n");
  }
}

struct Frame {
  std::array<double, 2> lower{std::numeric_limits<double>::infinity(),
                              std::numeric_limits<double>::infinity()};
  std::array<double, 2> upper{-std::numeric_limits<double>::infinity(),
                              -std::numeric_limits<double>::infinity()};
};

Frame frame_of(const CurveBlocks<double>& curve) {
  Frame frame;
  for_each_point(curve, [&](std::size_t, const auto& coordinates, std::size_t k) {
    for (std::size_t c = 0; c < 2; ++c) {
      frame.lower[c] = std::min(frame.lower[c], coordinates[c][k]);
      frame.upper[c] = std::max(frame.upper[c], coordinates[c][k]);
    }
  });
  return frame;
}

void write_svg(OutputFile& file, const CurveBlocks<double>& curve, bool closed) {
  require_dimension(curve, curve.dimension() >= 2, "a drawing needs at least two");
  const Frame frame = frame_of(curve);
  const double width = frame.upper[0] - frame.lower[0];
  const double height = frame.upper[1] - frame.lower[1];
  const double size = std::max(width, height) > 0 ? std::max(width, height) : 1;
  constexpr double border = 0.05;
  constexpr double stroke = 0.004;
  constexpr double pixels = 800;
  const double margin = border * size;
  const double scale = pixels / (size + 2 * margin);
  const auto shown = [&](double extent) { return (extent + 2 * margin) * scale; };
  file.write(
      fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.6g}\" height=\"{1:.6g}\" "
                  "viewBox=\"0 0 {0:.6g} {1:.6g}\">\n<path fill=\"none\" stroke=\"black\" "
                  "stroke-width=\"{2:.4g}\" stroke-linejoin=\"round\" d=\"M",
                  shown(width), shown(height), stroke * pixels));
  for_each_point(curve, [&](std::size_t i, const auto& coordinates, std::size_t k) {
    const double x = (coordinates[0][k] - frame.lower[0] + margin) * scale;
    const double y = (frame.upper[1] - coordinates[1][k] + margin) * scale;
    if (!std::isfinite(x) || !std::isfinite(y)) throw InputError("a coordinate leaves the range of doubles");
    file.write(fmt::format("{}{:.7g} {:.7g}", i == 0 ? "" : " ", x, y));
  });
  file.write(closed ? " Z\"/>\n</svg>\n" : "\"/>\n</svg>\n");
}

}  // namespace

CurveFormat curve_format(const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  if (extension == ".csv" || path == "-" || path.string().starts_with("/dev/")) return CurveFormat::csv;
  if (extension == ".obj") return CurveFormat::obj;
  if (extension == ".svg") return CurveFormat::svg;
  throw InputError(path.string() +
                   ": curves are written to .csv, .obj or .svg files, or to - for standard output");
}

void append_number(std::string& text, double x) {
  if (!std::isfinite(x)) {
    throw InputError("a coordinate leaves the range of doubles (about 1.8e308); scale the points down");
  }
  std::array<char, 32> digits{};  // the longest double takes 24
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), x);
  text.append(digits.data(), static_cast<std::size_t>(end - digits.data()));
}

void write_curve(OutputFile& file, CurveFormat format, const CurveBlocks<double>& curve, bool closed) {
  switch (format) {
    case CurveFormat::csv:
      write_csv(file, curve);
      return;
    case CurveFormat::obj:
      write_obj(file, curve, closed);
      return;
    case CurveFormat::svg:
      write_svg(file, curve, closed);
      return;
  }
}

}  // namespace subdiv
