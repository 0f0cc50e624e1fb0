#include <filesystem>
#include <iostream>

#include "experiments/cli/verbs.h"
#include "experiments/report/gnuplot.h"
#include "experiments/report/output_file.h"
#include "experiments/scheme_figures.h"
#include "schemes/input_error.h"
#include "schemes/text.h"

namespace subdiv::cli {

int plot(const PlotOptions& options) {
  const std::filesystem::path path = options.out;
  if (!is_standard_output(path) && path.extension() != ".svg")
    throw InputError("--out " + in_quotes(options.out) +
                     ": a figure is a .svg file, or - for standard output");
  require_gnuplot();
  const Results results = scheme_figure("figure", options.scheme, options.over);
  OutputFile file(path);
  file.write(draw_svg(results.figures.at(0), results.series));
  file.finish();
  return ExitCode::done;
}

}  // namespace subdiv::cli
