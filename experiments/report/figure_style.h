#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

/// The one style of all figures. They are made for a column of 85 mm = 241 pt: the canvas is 480 units wide,
/// so that a unit is half a point there. Text is 15 units (7.5 pt), indices 13.2 (6.6 pt), no line is thinner
/// than 1 unit (0.5 pt). Colours are Okabe & Ito's, which colour-blind readers tell apart; for print in grey
/// every further curve of a plot has a dash or a marker of its own as well.
///
/// A plot has axes with labels, a grid, its key below the axes (it never covers a curve) and a title that
/// breaks into lines. A picture (Figure::picture) shows shapes: one scale in both directions, no axes, names
/// beside what they name. Text is plain but for indices and powers: "J_{3/8}", "C^m".
///
/// Figures name what a line is for; the functions here say how that is drawn, as gnuplot's "with" clause.
namespace subdiv::style {

inline constexpr int canvas_width = 480;
inline constexpr int font_size = 15;
inline constexpr double character_width = 9;  // of the widest font that stands in for Helvetica, on average
inline constexpr double line_height = 19;

inline constexpr std::string_view blue = "#0072b2";
inline constexpr std::string_view vermilion = "#d55e00";
inline constexpr std::string_view green = "#009e73";
inline constexpr std::string_view purple = "#cc79a7";
inline constexpr std::string_view orange = "#e69f00";
inline constexpr std::string_view sky = "#56b4e9";
inline constexpr std::string_view yellow = "#f0e442";  // for regions alone: too pale for lines
inline constexpr std::string_view black = "#000000";
inline constexpr std::string_view dark = "#555555";
inline constexpr std::string_view grey = "#808080";
inline constexpr std::string_view pale = "#c0c0c0";
inline constexpr std::string_view faint = "#e4e4e4";  // the grid

/// The same for surfaces, red x 65536 + green x 256 + blue; the light on them makes further shades.
inline constexpr unsigned lit_orange = 0xE69F00;
inline constexpr unsigned lit_sky = 0x56B4E9;
inline constexpr unsigned lit_vermilion = 0xD55E00;
inline constexpr unsigned lit_grey = 0xC8C8C8;
inline constexpr unsigned flat_blue = 0x0072B2;

/// The curves that a figure is about, from 0: colour and dash (from the seventh on they repeat).
[[nodiscard]] std::string curve(std::size_t i, double width = 2);
/// The dash of curve i in another colour, for lines on regions.
[[nodiscard]] std::string dashed(std::size_t i, std::string_view colour, double width = 1.5);
/// Curve i through measured points: colour and marker.
[[nodiscard]] std::string marked(std::size_t i, double size = 0.5);
/// Points alone, in the colour and with the marker of curve i.
[[nodiscard]] std::string points(std::size_t i, double size = 0.7);
/// The curve of a picture with one curve beside its control polygon.
[[nodiscard]] std::string in_colour(std::string_view colour, double width = 2);
/// A region, filled; or half transparent with a border, for those that overlap.
[[nodiscard]] std::string region(std::string_view colour);
[[nodiscard]] std::string glass(std::string_view colour);

inline const std::string polygon = "lines lw 1.2 lc rgb '#808080'";  // control polygons and nets
inline const std::string target = "lines lw 6 lc rgb '#c0c0c0'";     // what another curve should run along
inline const std::string guide = "lines lw 1 dt (4,4) lc rgb '#000000'";
inline const std::string thin = "lines lw 1 lc rgb '#c0c0c0'";  // of diagrams: what stands behind
inline const std::string line = "lines lw 1.2 lc rgb '#555555'";
inline const std::string thick = "lines lw 2 lc rgb '#0072b2'";
inline const std::string dot = "points pt 7 ps 0.45 lc rgb '#000000'";
inline const std::string pale_dot = "points pt 7 ps 0.45 lc rgb '#c0c0c0'";
inline const std::string bright_dot = "points pt 5 ps 0.5 lc rgb '#d55e00'";

/// Clauses for Figure::setup: axes in powers of ten, and thin dashed lines across the whole plot.
inline const std::string log_x = "set logscale x; set format x '10^{/*1.1 %T}'\n";
inline const std::string log_y = "set logscale y; set format y '10^{/*1.1 %T}'\n";
[[nodiscard]] std::string across(const std::string& y);
[[nodiscard]] std::string upright(const std::string& x);

}  // namespace subdiv::style
