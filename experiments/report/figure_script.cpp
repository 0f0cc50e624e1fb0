#include "experiments/report/figure_script.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include <fmt/format.h>

#include "experiments/report/figure_style.h"
#include "experiments/report/figure_text.h"
#include "experiments/report/utf8.h"

namespace subdiv {
namespace {

const Series& series_named(std::span<const Series> series, const Figure& figure, const std::string& name) {
  const auto found =
      std::find_if(series.begin(), series.end(), [&](const Series& s) { return s.name == name; });
  if (found == series.end()) {
    throw std::logic_error("figure '" + figure.name + "': there is no series '" + name + "'");
  }
  return *found;
}

std::size_t column_named(const Series& series, const std::string& name) {
  const auto found = std::find(series.columns.begin(), series.columns.end(), name);
  if (found == series.columns.end()) {
    throw std::logic_error("series '" + series.name + "': there is no column '" + name + "'");
  }
  return static_cast<std::size_t>(found - series.columns.begin());
}

void require_decimal(const Series& series, const std::string& cell) {
  try {
    if (cell.find('/') != std::string::npos) throw std::invalid_argument("'" + cell + "' is a fraction");
    (void)Rational::parse(cell);
  } catch (const std::invalid_argument& error) {
    throw std::logic_error("series '" + series.name + "': " + error.what() + "; figures need decimals");
  }
}

std::vector<std::size_t> columns_of(const Series& series, const Curve& curve) {
  std::vector<std::size_t> columns{column_named(series, curve.x), column_named(series, curve.y)};
  for (const std::string& name : curve.more) columns.push_back(column_named(series, name));
  return columns;
}

std::string data_block(const Series& series, const Curve& curve, std::size_t index) {
  const std::vector<std::size_t> columns = columns_of(series, curve);
  std::string text = "$data" + std::to_string(index) + " << end_of_data\n";
  for (const auto& row : series.rows) {
    const bool complete = std::ranges::none_of(columns, [&](std::size_t c) { return row.at(c).empty(); });
    for (std::size_t i = 0; complete && i < columns.size(); ++i) {
      require_decimal(series, row[columns[i]]);
      text += (i == 0 ? "" : " ") + row[columns[i]];
    }
    text += '\n';
  }
  return text + "end_of_data\n";
}

/// "1:2", and so on for more columns; "($1+5):($2+0)" for a curve that is moved.
std::string using_clause(const Curve& curve) {
  const bool moved = curve.right != 0 || curve.up != 0;
  std::string text = moved ? fmt::format("(${}+{}):(${}+{})", 1, curve.right, 2, curve.up) : "1:2";
  for (std::size_t i = 0; i < curve.more.size(); ++i) text += ":" + std::to_string(i + 3);
  return text;
}

double width_of(const std::string& text) {
  return style::character_width * static_cast<double>(display_width(plain_text(text)));
}

/// A text in lines, as an expression of gnuplot's.
std::string text_block(const std::string& text, std::size_t width) {
  std::string block;
  for (const std::string& line : wrapped(text, width))
    block += (block.empty() ? "" : ".\"\\n\".") + gnuplot_text(line);
  return block.empty() ? "''" : block;
}

std::size_t characters_in(double width) {
  return static_cast<std::size_t>(std::floor(width / style::character_width));
}

double height_of_lines(std::size_t lines) { return style::line_height * static_cast<double>(lines); }

/// The title in lines, centred on the canvas.
struct Title {
  std::vector<std::string> lines;

  static constexpr double edge = 7;
  [[nodiscard]] double height() const { return height_of_lines(lines.size()) + 2 * edge; }
  [[nodiscard]] std::string commands(double canvas) const {
    std::string text;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const double below = edge + height_of_lines(i) + style::line_height / 2;
      text += fmt::format("set label {} at screen 0.5, screen {:.6f} center\n", gnuplot_text(lines[i]),
                          1 - below / canvas);
    }
    return text;
  }
};

/// The key below the figure, in as many columns as have room.
struct Key {
  std::size_t columns = 0;
  std::size_t rows = 0;

  static constexpr double line_height = 22.5;  // gnuplot's, for its font size
  static constexpr double edge = 7;
  [[nodiscard]] double height() const {
    return rows == 0 ? 0 : line_height * static_cast<double>(rows) + 2 * edge;
  }
  [[nodiscard]] std::string commands(double canvas) const {
    if (rows == 0) return "unset key\n";
    return fmt::format(
        "set key at screen 0.5, screen {:.6f} center bottom horizontal Left reverse samplen 2.5 width 0 "
        "height 0 "
        "maxcols {}\n",
        edge / canvas, columns);
  }
};

Key key_of(const Figure& figure) {
  const double room = figure.picture ? 460 : 360;  // gnuplot fits columns into the axes
  constexpr double sample = 50;                    // with the space about it
  double widest = 0;
  std::size_t count = 0;
  for (const Curve& curve : figure.curves) {
    if (curve.label.empty()) continue;
    widest = std::max(widest, width_of(curve.label) + sample);
    ++count;
  }
  if (count == 0) return {};
  const auto most = std::max<std::size_t>(1, static_cast<std::size_t>(room / widest));
  const std::size_t rows = (count + most - 1) / most;
  return {(count + rows - 1) / rows, rows};
}

struct Box {
  double left = INFINITY;
  double right = -INFINITY;
  double bottom = INFINITY;
  double top = -INFINITY;

  void extend(double x, double y, double beside = 0, double above = 0) {
    left = std::min(left, x - beside);
    right = std::max(right, x + beside);
    bottom = std::min(bottom, y - above);
    top = std::max(top, y + above);
  }
};

double number_in(const std::string& cell) { return Rational::parse(cell).to_double(); }

Box extent_of(const Figure& figure, std::span<const Series> series) {
  Box box;
  for (const Curve& curve : figure.curves) {
    const Series& data = series_named(series, figure, curve.series);
    const std::size_t x = column_named(data, curve.x);
    const std::size_t y = column_named(data, curve.y);
    for (const auto& row : data.rows) {
      if (row[x].empty() || row[y].empty()) continue;
      box.extend(number_in(row[x]) + curve.right, number_in(row[y]) + curve.up);
    }
  }
  return box;
}

constexpr double margin = 8;             // about a picture
constexpr double tallest_picture = 400;  // without title and key

/// How far a text stands from its point, in units of the canvas.
std::pair<double, double> offset_of(const FigureText& text) {
  constexpr double line = 22.5;  // gnuplot's height of a character
  double right = 0;
  double up = 0;
  const std::size_t at = text.place.find("offset ");
  if (at == std::string::npos ||
      std::sscanf(text.place.c_str() + at, "offset %lf,%lf", &right, &up) != 2)  // NOLINT(cert-err34-c)
    return {0, 0};
  return {right * style::character_width, up * line};
}

std::string canvas_commands(double height) {
  return fmt::format(
      "set terminal svg size {},{:.0f} fixed font 'Helvetica,{}' enhanced background '#ffffff' name 'f'\n",
      style::canvas_width, height, style::font_size);
}

/// Canvas and ranges of a picture: as wide as the canvas, or as high as pictures may be, names included.
std::string picture_layout(const Figure& figure, std::span<const Series> series, const Title& title,
                           const Key& key) {
  constexpr double room = style::canvas_width - 2 * margin;
  constexpr double pen = 6;  // what lines and dots take beside their points
  const Box shapes = extent_of(figure, series);
  Box box = shapes;
  double scale = 0;                       // units of the canvas for one of the picture
  for (int pass = 0; pass < 4; ++pass) {  // the room that names take depends on the scale, and it on the room
    scale = std::min(room / (box.right - box.left), tallest_picture / (box.top - box.bottom));
    box = shapes;
    box.extend(shapes.left, shapes.bottom, pen / scale, pen / scale);
    box.extend(shapes.right, shapes.top, pen / scale, pen / scale);
    for (const FigureText& text : figure.texts) {
      const double width = (width_of(text.text) + 2 * style::character_width) / scale;
      const double middle = text.place.starts_with("left")    ? width / 2
                            : text.place.starts_with("right") ? -width / 2
                                                              : 0;
      const auto [right, up] = offset_of(text);
      box.extend(text.x + middle + right / scale, text.y + up / scale, width / 2,
                 style::line_height / 2 / scale);
    }
  }
  const double below = key.height() + margin;
  const double canvas = std::ceil(title.height() + scale * (box.top - box.bottom) + below);
  const double height = canvas - title.height() - below;
  const double spare = (room / scale - (box.right - box.left)) / 2;
  return canvas_commands(canvas) +
         fmt::format(
             "unset border; unset tics\n"
             "set lmargin at screen {:.6f}; set rmargin at screen {:.6f}\n"
             "set bmargin at screen {:.6f}; set tmargin at screen {:.6f}\n"
             "set xrange [{:.8g}:{:.8g}]; set yrange [{:.8g}:{:.8g}]\n",
             margin / style::canvas_width, 1 - margin / style::canvas_width, below / canvas,
             (below + height) / canvas, box.left - spare, box.right + spare, box.bottom,
             box.bottom + height / scale) +
         title.commands(canvas) + key.commands(canvas);
}

std::string plot_layout(const Figure& figure, const Title& title, const Key& key) {
  constexpr double area = 220;
  constexpr double numbers = 38;  // below the axis
  constexpr double x_label_room = 400;
  const std::size_t x_characters = characters_in(x_label_room);
  const double below = numbers + height_of_lines(wrapped(figure.x_label, x_characters).size()) + key.height();
  constexpr double number = 6;  // what the highest number on the axis stands above it
  const double canvas = std::ceil(title.height() + number + area + below);
  return canvas_commands(canvas) +
         fmt::format(
             "set border 3 lw 1\nset tics nomirror\nset grid lt 1 lw 1 lc rgb '{}'\n"
             "set rmargin at screen {:.6f}\nset bmargin at screen {:.6f}; set tmargin at screen {:.6f}\n"
             "set xlabel {} offset 0,0.5\nset ylabel {}\n",
             style::faint, 1 - 2 * margin / style::canvas_width, below / canvas, (below + area) / canvas,
             text_block(figure.x_label, x_characters), text_block(figure.y_label, characters_in(area))) +
         title.commands(canvas) + key.commands(canvas);
}

}  // namespace

std::string figure_script(const Figure& figure, std::span<const Series> series) {
  constexpr std::size_t title_characters = 51;
  const Title title{wrapped(figure.title, title_characters)};
  const Key key = key_of(figure);
  std::string script = "set encoding utf8\n" + (figure.picture ? picture_layout(figure, series, title, key)
                                                               : plot_layout(figure, title, key));
  std::string plots;
  for (std::size_t i = 0; i < figure.curves.size(); ++i) {
    const Curve& curve = figure.curves[i];
    script += data_block(series_named(series, figure, curve.series), curve, i);
    plots += (i == 0 ? "plot " : ", ") + ("$data" + std::to_string(i)) + " using " + using_clause(curve) +
             " with " + (curve.style.empty() ? style::curve(i) : curve.style) +
             (curve.label.empty() ? " notitle" : " title " + gnuplot_text(curve.label));
  }
  for (const FigureText& text : figure.texts)
    script += fmt::format("set label {} at {:.8g},{:.8g} {} front\n", gnuplot_text(text.text), text.x, text.y,
                          text.place);
  if (!figure.setup.empty()) script += figure.setup + "\n";
  return script + plots + "\n";
}

std::string figure_description(const Figure& figure) {
  const auto listed = [](const auto& items, const auto& text_of) {
    std::string list;
    for (const auto& item : items) {
      const std::string text = plain_text(text_of(item));
      if (!text.empty()) list += (list.empty() ? "" : "; ") + text;
    }
    return list;
  };
  const std::string curves = listed(figure.curves, [](const Curve& curve) { return curve.label; });
  const std::string names = listed(figure.texts, [](const FigureText& text) { return text.text; });
  return (figure.picture ? std::string("A picture of shapes.")
                         : fmt::format("A plot of {} against {}.", plain_text(figure.y_label),
                                       plain_text(figure.x_label))) +
         (curves.empty() ? "" : " Key: " + curves + ".") + (names.empty() ? "" : " Names: " + names + ".");
}

}  // namespace subdiv
