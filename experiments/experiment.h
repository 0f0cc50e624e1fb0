#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "experiments/claim.h"

namespace subdiv {

/// A table of numbers behind a figure or a claim: results/series/NAME.csv. Cells are decimal strings, so that
/// exact and certified digits survive; the first column is the abscissa.
struct Series {
  std::string name;
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
};

/// One curve of a figure: two columns (by header name) of a series, or more where the style takes more
/// ("boxxyerror": x y, then the ends in x and in y), drawn in a gnuplot style.
struct Curve {
  std::string series;
  std::string x;
  std::string y;
  std::string label;       // shown in the key; empty hides it
  std::string style = {};  // from report/figure_style.h; empty: the look of curve i of a figure
  std::vector<std::string> more = {};
  double right = 0;  // the drawing moves the curve by this in x and y: panels side by side
  double up = 0;
};

/// A text in a figure, in the coordinates of its curves.
struct FigureText {
  std::string text;
  double x = 0;
  double y = 0;
  std::string place = "center";  // gnuplot's: "left offset 0.8,0" (in widths and heights of characters)
};

/// A figure: results/figures/NAME.svg, drawn by gnuplot from series alone, byte-identical on every run. Its
/// style, and how its texts are written: report/figure_style.h.
struct Figure {
  std::string name;
  std::string title;
  std::string x_label;
  std::string y_label;
  std::vector<Curve> curves;
  std::string setup;                     // further gnuplot commands before the plot: ranges, logscale
  std::vector<std::string> claims = {};  // ids of the claims that the figure shows; a prefix that ends in "."
                                         // stands for all below it
  std::vector<FigureText> texts = {};
  bool picture = false;  // shapes in one scale, without axes
};

struct Results {
  std::vector<Claim> claims;
  std::vector<Series> series;
  std::vector<Figure> figures;
};

/// One section of the documents: its claims, known before anything runs, and the computation that settles
/// every one of them. run must return each head of the table exactly once; the registry checks it.
struct Experiment {
  std::string name;   // "area"
  std::string title;  // "Area preservation (js-report 8, jsplines 8)"
  std::function<std::span<const ClaimHead>()> heads;
  std::function<Results()> run;
};

/// Every experiment, in the order of the documents' sections. The one list that names them (registry.cpp).
[[nodiscard]] std::span<const Experiment> experiments();

/// The head with this id in a table; std::logic_error when there is none.
[[nodiscard]] const ClaimHead& head(std::span<const ClaimHead> heads, const std::string& id);

}  // namespace subdiv
