#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <thread>
#include <utility>

#include <CLI/CLI.hpp>

#include "experiments/cli/usage.h"
#include "experiments/cli/verbs.h"
#include "schemes/input_error.h"
#include "schemes/text.h"

namespace subdiv::cli {
namespace {

constexpr const char* exit_codes =
    "Exit codes: 0 done (refuted claims are results); 1 a comparison fails, a verdict changed or an\n"
    "experiment broke; 2 bad input or usage; 3 undecided within the budget.";

int default_jobs() { return static_cast<int>(std::max(1U, std::thread::hardware_concurrency())); }

void add_jobs(CLI::App& verb, int& jobs) {
  jobs = default_jobs();
  constexpr int most = 1024;
  verb.add_option("--jobs,-j", jobs, "Experiments that run at the same time (default: one a processor)")
      ->type_name("N")
      ->check(CLI::Range(1, most));
}

/// A finite number above 0.
CLI::Validator positive_number() {
  return {[](const std::string& text) {
            double value = 0;
            const bool number = CLI::detail::lexical_cast(text, value);
            return number && value > 0 && std::isfinite(value) ? ""
                                                               : "must be a positive number, not " + text;
          },
          "POSITIVE"};
}

/// The command line: CLI11 fills the options, the chosen verb's callback stands in `action`.
struct CommandLine {
  CLI::App app{
      "Analyses and optimises subdivision schemes, and regenerates, with proof, the claims of the papers.",
      "subdivlab"};
  std::function<int()> action;
  ReproduceOptions reproduce_options;
  CheckOptions check_options;
  AnalyzeOptions analyze_options;
  OptimizeOptions optimize_options;
  CertifyOptions certify_options;
  PlotOptions plot_options;
  EigenOptions eigen_options;
  RefineOptions refine_options;
  std::pair<std::string, std::string> refine_words;  // in the order in which they stand
  RingsOptions rings_options;
  BezierOptions bezier_options;
  MeasureOptions measure_options;
  SmoothOptions smooth_options;
  ProveOptions prove_options;
  VerifyOptions verify_options;
  ListOptions list_options;
  std::string shell;  // of completion

  CommandLine() {
    app.set_version_flag("--version", "subdivlab " SUBDIVLAB_VERSION);
    app.require_subcommand(1);
    app.footer(std::string("Example:  subdivlab reproduce 'area.*' --out /tmp/results\n\n"
                           "'subdivlab VERB --help' shows the options of a verb.\n") +
               exit_codes);
    add_reproduce();
    add_check();
    add_analyze();
    add_optimize();
    add_certify();
    add_plot();
    add_eigen();
    add_refine();
    add_rings();
    add_bezier();
    add_measure();
    add_smooth();
    add_prove();
    add_verify();
    add_list();
    add_completion();
    add_manual();
  }

  void add_reproduce() {
    auto& options = reproduce_options;
    CLI::App& verb =
        *app.add_subcommand("reproduce", "Run experiments, write the results folder, print the claims");
    verb.add_option("PATTERN", options.patterns,
                    "Claims by id, with * and ?: their experiments run (default: all)");
    verb.add_option("--claims", options.claims,
                    "Claims of your own, a JSON file, instead of those of the papers; --out is required then")
        ->type_name("FILE.json");
    verb.add_option("--out,-o", options.out, "The results folder to write (default: results)")
        ->type_name("DIR");
    add_jobs(verb, options.jobs);
    verb.footer(std::string("Examples:  subdivlab reproduce\n"
                            "           subdivlab reproduce 'family.*' 'area.r' --out /tmp/results\n"
                            "           subdivlab reproduce --claims mine.json --out my-results\n\n") +
                exit_codes);
    verb.callback([this] { action = [this] { return reproduce(reproduce_options); }; });
  }

  void add_check() {
    auto& options = check_options;
    CLI::App& verb = *app.add_subcommand("check", "Run experiments again and compare with a results folder");
    verb.add_option("PATTERN", options.patterns, "Claims by id, with * and ? (default: all)");
    verb.add_option(
            "--claims", options.claims,
            "Claims of your own, a JSON file, instead of those of the papers; --against is required then")
        ->type_name("FILE.json");
    verb.add_option("--against", options.against, "The results folder to compare with (default: results)")
        ->type_name("DIR");
    add_jobs(verb, options.jobs);
    verb.footer(std::string("Examples:  subdivlab check 'area.*' --against results\n"
                            "           subdivlab check --claims mine.json --against my-results\n\n") +
                exit_codes);
    verb.callback([this] { action = [this] { return check(check_options); }; });
  }

  void add_analyze() {
    auto& options = analyze_options;
    CLI::App& verb = *app.add_subcommand("analyze", "Say everything that can be said of a scheme");
    verb.add_option("SCHEME", options.scheme,
                    "NAME or FILE.json, parameters after a colon; steps joined by +, the last repeats")
        ->required();
    verb.add_option("--budget", options.budget,
                    "Time for a joint spectral radius; then the enclosure reached is the answer")
        ->type_name("SECONDS")
        ->check(positive_number())
        ->capture_default_str();
    verb.add_flag(
        "--rounded", options.rounded,
        "Take each decimal in a scheme file as rounded: an interval of half a unit of its last digit");
    verb.add_flag("--json", options.json, "Machine-readable output; numbers are strings");
    verb.footer(std::string("Examples:  subdivlab analyze jspline:s=3/2\n"
                            "           subdivlab analyze jspline:s=-33/26+jspline:s=3/2 --json\n"
                            "           subdivlab analyze four-point:w=w      (w stays free)\n"
                            "           subdivlab analyze my-scheme.json:w=1/16\n"
                            "           subdivlab analyze decimals.json --rounded --budget 5\n\n") +
                exit_codes);
    verb.callback([this] { action = [this] { return analyze(analyze_options); }; });
  }

  void add_optimize() {
    auto& options = optimize_options;
    CLI::App& verb =
        *app.add_subcommand("optimize", "Minimise an objective over free parameters, with proof");
    verb.add_option("SCHEME", options.scheme, "The scheme; names as values leave parameters free")
        ->required();
    verb.add_option("--over", options.over, "A range for each free parameter")
        ->type_name("s=LO..HI[,...]")
        ->required();
    verb.add_option("--objective", options.objective, "What to minimise: see 'subdivlab list objectives'")
        ->type_name("NAME[:option=value,...]")
        ->required();
    verb.add_option("--norm", options.norm,
                    "The norm of the residuals: l1, l2 or linf; on a polygon linf when not given")
        ->type_name("NORM")
        ->check(CLI::IsMember({"l1", "l2", "linf"}));
    verb.add_option("--polygon", options.polygon,
                    "A closed polygon, .csv (x,y[,z] a line) or .obj, for objectives of its curve")
        ->type_name("FILE");
    verb.add_flag("--json", options.json, "Machine-readable output; numbers are strings");
    verb.footer(std::string("Examples:  subdivlab optimize jspline:s=r+jspline:s=3/2 --over r=-2..2 "
                            "--objective vertex --norm linf\n"
                            "           subdivlab optimize jspline:s=s --over s=0..1 --objective "
                            "fit-bspline:degree=2 --norm l1\n"
                            "           subdivlab optimize jspline:s=s --over s=0..4 --objective area "
                            "--polygon polygon.csv\n\n") +
                exit_codes);
    verb.callback([this] { action = [this] { return optimize(optimize_options); }; });
  }

  void add_certify() {
    auto& options = certify_options;
    CLI::App& verb = *app.add_subcommand("certify", "Prove smoothness for whole ranges of parameters");
    verb.add_option("SCHEME", options.scheme, "The scheme; names as values leave parameters free")
        ->required();
    verb.add_option("--over", options.over, "A range for each free parameter")
        ->type_name("s=LO..HI[,...]")
        ->required();
    constexpr int most = 1000;
    verb.add_option("--continuity", options.continuity, "C^M: the differences of order M + 1 decide")
        ->type_name("M")
        ->check(CLI::Range(0, most))
        ->required();
    verb.add_option("--budget", options.budget, "Time; what is left then is undecided")
        ->type_name("SECONDS")
        ->check(positive_number())
        ->capture_default_str();
    verb.add_flag("--json", options.json, "Machine-readable output; numbers are strings");
    verb.footer(std::string("Examples:  subdivlab certify jspline:s=s --over s=-3..7 --continuity 1\n"
                            "           subdivlab certify jspline:a=a,b=b --over a=-4..7,b=-5..10 "
                            "--continuity 1 --json\n\n") +
                exit_codes);
    verb.callback([this] { action = [this] { return certify(certify_options); }; });
  }

  void add_plot() {
    auto& options = plot_options;
    CLI::App& verb = *app.add_subcommand("plot", "Draw a basis function, or smoothness over a parameter");
    verb.add_option("SCHEME", options.scheme, "The scheme; with --over one parameter stays free")->required();
    verb.add_option("--over", options.over,
                    "Draw the Hoelder exponent and the certified ranges over the free parameter")
        ->type_name("s=LO..HI");
    verb.add_option("--out,-o", options.out, "A .svg file; - for standard output")
        ->type_name("FIGURE.svg")
        ->required();
    verb.footer(
        std::string("Examples:  subdivlab plot jspline:s=3/2 -o basis.svg\n"
                    "           subdivlab plot four-point:w=w --over w=0..1/4 -o smoothness.svg\n\n") +
        exit_codes);
    verb.callback([this] { action = [this] { return plot(plot_options); }; });
  }

  void add_eigen() {
    auto& options = eigen_options;
    CLI::App& verb = *app.add_subcommand(
        "eigen", "Eigenvalues and characteristic maps at extraordinary vertices of meshes");
    verb.add_option("SCHEME", options.scheme, "A mesh scheme; a name as a value leaves its parameter free")
        ->required();
    verb.add_option("--valence", options.valence, "The valences, one answer each")
        ->type_name("N|LO..HI")
        ->required();
    verb.add_option("--over", options.over, "A range for the free parameter: where the condition holds")
        ->type_name("s=LO..HI");
    verb.add_flag("--json", options.json, "Machine-readable output; numbers are strings");
    verb.footer(
        std::string("Condition: 1 > lambda > all other moduli, lambda real, of mode 1 and simple there (Reif "
                    "1995).\n\n"
                    "Examples:  subdivlab eigen catmull-clark --valence 3..30\n"
                    "           subdivlab eigen jspline-mesh:s=s --valence 5 --over s=-2..6 --json\n\n") +
        exit_codes);
    verb.callback([this] { action = [this] { return eigen(eigen_options); }; });
  }

  void add_refine() {
    auto& options = refine_options;
    CLI::App& verb = *app.add_subcommand("refine", "Refine a polygon, a grid or a mesh");
    verb.add_option("SCHEME", refine_words.first, "The scheme, with a value for every parameter");
    verb.add_option("INPUT", refine_words.second,
                    "Control points: .csv (x,y[,z] a line) or .obj; a mesh: .obj, .off or .ply");
    verb.add_option("--scheme", options.scheme, "The scheme, instead of SCHEME")->type_name("SCHEME");
    constexpr int most = 62;
    verb.add_option("--levels,-k", options.levels, "How often: K steps of the scheme")
        ->type_name("K")
        ->check(CLI::Range(0, most))
        ->required();
    verb.add_option("--out,-o", options.out,
                    "A .csv, .obj or .svg file, of a mesh .obj, .off, .ply or .svg; - for standard output")
        ->type_name("OUTPUT")
        ->required();
    const CLI::IsMember ends({"clamped", "reflected"});
    verb.add_option("--open", options.open,
                    "An open curve, or open rows of a grid: clamped or reflected ends")
        ->type_name("ENDS")
        ->check(ends);
    verb.add_option("--grid", options.grid, "The points are a grid, a row after the other")
        ->type_name("ROWSxCOLUMNS");
    verb.add_option("--open-across", options.open_across, "Open columns of a grid")
        ->type_name("ENDS")
        ->check(ends);
    verb.add_option("--details", options.details,
                    "Points moved at their levels: .csv lines level,index,dx,dy[,dz]")
        ->type_name("FILE");
    verb.add_option("--retrofit", options.retrofit,
                    "Make the limit pass through the points: direct, or by the papers' iteration")
        ->type_name("HOW")
        ->check(CLI::IsMember({"direct", "iteration"}));
    verb.add_flag("--limit", options.limit,
                  "Write the limit points of the last level, of a mesh with normals");
    constexpr int most_threads = 1024;
    verb.add_option("--threads", options.threads, "Threads for a mesh (default: one a processor)")
        ->type_name("N")
        ->check(CLI::Range(1, most_threads));
    verb.footer(std::string("Examples:  subdivlab refine jspline:s=1/2 square.csv --levels 5 -o curve.svg\n"
                            "           subdivlab refine jspline:s=3/2 path.csv --open clamped -k 8 -o -\n"
                            "           subdivlab refine bspline:degree=3 torus.csv --grid 4x6 -k 3 -o "
                            "torus.obj\n"
                            "           subdivlab refine --scheme jspline-mesh:s=1/2 mesh.obj -o out.ply "
                            "--levels 4\n\n") +
                exit_codes);
    verb.callback([this] {
      take_refine_words();
      action = [this] { return refine(refine_options); };
    });
  }

  /// "refine SCHEME INPUT", or "refine --scheme SCHEME INPUT".
  void take_refine_words() {
    auto& [scheme, input] = refine_words;
    if (refine_options.scheme.empty()) {
      if (scheme.empty()) throw CLI::RequiredError("SCHEME");
      if (input.empty()) throw CLI::RequiredError("INPUT");
      refine_options.scheme = scheme;
      refine_options.input = input;
      return;
    }
    if (scheme.empty()) throw CLI::RequiredError("INPUT");
    if (!input.empty()) throw CLI::ExcludesError("SCHEME", "--scheme");
    refine_options.input = scheme;
  }

  void add_rings() {
    auto& options = rings_options;
    CLI::App& verb = *app.add_subcommand(
        "rings", "Surface rings of adjustable speed around extraordinary vertices of a mesh of quads");
    verb.add_option("INPUT", options.input, "A mesh: .obj, .off or .ply")->required();
    verb.add_option("--sigma", options.sigma,
                    "Speeds between 0 and 1, one a step; 1/2 is Catmull-Clark's (default: no steps)")
        ->type_name("S[,S...]");
    verb.add_option("--out,-o", options.out,
                    "The surface, each patch as quads: .obj in groups, .off, .ply or .svg; - for standard "
                    "output")
        ->type_name("OUTPUT");
    verb.add_option("--control-points", options.control_points,
                    "The patches: .obj with free-form surfaces, or .bv for BezierView")
        ->type_name("FILE");
    verb.add_flag("--catmull-clark-step", options.catmull_clark_steps,
                  "Refine the mesh once first (twice when given twice): quads, and extraordinary vertices "
                  "apart from each other and from borders");
    verb.add_flag("--fill", options.fill, "Fill what the last ring leaves open with bicubic caps");
    constexpr int most = 1024;
    verb.add_option("--tessellation", options.tessellation, "N x N quads for each patch")
        ->type_name("N")
        ->check(CLI::Range(1, most))
        ->capture_default_str();
    verb.add_flag("--rings-only", options.rings_only, "Leave out the patches of regular faces");
    verb.add_flag("--json", options.json,
                  "Machine-readable report of patches and holes; numbers are strings");
    verb.footer(
        std::string("Order: regular faces, then ring 1 of every extraordinary vertex, ring 2, .., caps; in "
                    ".obj files groups regular, ring_1, .., cap.\n\n"
                    "Examples:  subdivlab rings mesh.obj --sigma 1/2,3/4 -o rings.obj\n"
                    "           subdivlab rings mesh.ply --sigma 3/4,3/4 --fill --tessellation 8 -o "
                    "surface.ply --control-points patches.bv\n\n") +
        exit_codes);
    verb.callback([this] { action = [this] { return rings(rings_options); }; });
  }

  void add_bezier() {
    auto& options = bezier_options;
    CLI::App& verb =
        *app.add_subcommand("bezier", "Draw Bezier curves as a polyline, with a proven distance");
    verb.add_option("INPUT", options.input,
                    "Control points of consecutive curves, .csv (x,y[,z] a line) or .obj: 1 + N k of them, "
                    "the last of a curve the first of the next")
        ->required();
    constexpr int most_degree = 1000;
    verb.add_option("--degree", options.degree, "The degree of every curve")
        ->type_name("N")
        ->check(CLI::Range(1, most_degree))
        ->capture_default_str();
    verb.add_option("--tolerance", options.tolerance,
                    "Halve each part until its chord is proved to be this near to the curve")
        ->type_name("T")
        ->check(positive_number());
    constexpr int most_depth = 62;
    verb.add_option("--depth,-k", options.depth,
                    "Halve K times and draw the control polygons, whatever the distance")
        ->type_name("K")
        ->check(CLI::Range(0, most_depth));
    verb.add_option("--out,-o", options.out, "The polyline: .csv, .obj, .svg, or - for standard output")
        ->type_name("OUTPUT")
        ->required();
    verb.add_flag("--json", options.json,
                  "Machine-readable report of segments and the distance; numbers are strings");
    verb.footer(std::string("Examples:  subdivlab bezier letter.csv --tolerance 0.01 -o letter.svg\n"
                            "           subdivlab bezier arch.obj --degree 2 --depth 4 -o arch.obj\n\n") +
                exit_codes);
    verb.callback([this] { action = [this] { return bezier(bezier_options); }; });
  }

  void add_measure() {
    auto& options = measure_options;
    CLI::App& verb = *app.add_subcommand("measure", "Measure polygons and their refinements");
    verb.add_option("INPUT", options.input, "The points: .csv (x,y[,z] a line) or .obj")->required();
    verb.add_option("--open", options.open,
                    "An open polygon: plain, or with the ends of a scheme, clamped or reflected")
        ->type_name("ENDS")
        ->check(CLI::IsMember({"plain", "clamped", "reflected"}));
    CLI::Option& scheme =
        *verb.add_option("--scheme", options.scheme, "Measure its refinements, too")->type_name("SCHEME");
    constexpr int most = 62;
    verb.add_option("--levels,-k", options.levels, "How often to refine")
        ->type_name("K")
        ->check(CLI::Range(0, most))
        ->needs(&scheme);
    verb.add_option("--against", options.against, "Another polygon: the Hausdorff distance between them")
        ->type_name("FILE");
    verb.add_option("--tolerance", options.tolerance,
                    "Width of the bounds of distances (default: a millionth of the extent)")
        ->type_name("T")
        ->check(positive_number());
    verb.add_flag("--local", options.local,
                  "Velocity, acceleration, curvature radii and jerk at every vertex, of the finest level");
    verb.add_flag("--json", options.json, "Machine-readable output; numbers are strings");
    verb.footer(std::string("Examples:  subdivlab measure square.csv\n"
                            "           subdivlab measure square.csv --scheme jspline:s=3/8 --levels 6\n"
                            "           subdivlab measure curve.csv --against other.csv --tolerance 1e-9\n"
                            "           subdivlab measure square.csv --local\n\n") +
                exit_codes);
    verb.callback([this] { action = [this] { return measure(measure_options); }; });
  }

  void add_smooth() {
    auto& options = smooth_options;
    CLI::App& verb = *app.add_subcommand("smooth", "Smooth a polygon by a sequence of operators");
    verb.add_option("INPUT", options.input, "The points: .csv (x,y[,z] a line) or .obj")->required();
    verb.add_option("--operators", options.operators,
                    "refine, split, dual, tuck(t), untuck, tweak(old, new), J(s), separated by ;, {..}^N to "
                    "repeat")
        ->type_name("SEQUENCE")
        ->required();
    constexpr long most = 1000000;
    verb.add_option("--repeat", options.repeat, "How often to apply the sequence")
        ->type_name("N")
        ->check(CLI::Range(1L, most))
        ->capture_default_str();
    verb.add_option("--open", options.open,
                    "An open polygon: vertices whose rules reach beyond its ends are dropped, or keep their "
                    "places")
        ->type_name("ENDS")
        ->check(CLI::IsMember({"drop", "keep"}));
    verb.add_option("--json", options.json, "Write a machine-readable report; numbers are strings")
        ->type_name("REPORT");
    verb.add_option("--out,-o", options.out, "A .csv, .obj or .svg file; - for standard output")
        ->type_name("OUTPUT")
        ->required();
    verb.footer(
        std::string(
            "Examples:  subdivlab smooth noisy.csv --operators 'tuck(1/2); tuck(-53/100)' --repeat 20 "
            "-o smooth.svg\n"
            "           subdivlab smooth path.csv --open keep --operators 'refine; dual^2' -o -\n\n") +
        exit_codes);
    verb.callback([this] { action = [this] { return smooth(smooth_options); }; });
  }

  void add_prove() {
    auto& options = prove_options;
    CLI::App& verb = *app.add_subcommand("prove", "Find the certificates of statements");
    verb.add_option("FILE", options.files, "Files of statements (experiments/certificates/README.md)")
        ->required();
    verb.add_option("--out,-o", options.out, "The folder to write to, ID.txt for each claim")
        ->type_name("DIR")
        ->required();
    verb.add_option("--claims", options.claims,
                    "The results folder with the values that $exact, $lower and $upper stand for")
        ->type_name("DIR")
        ->capture_default_str();
    verb.footer(std::string("Example:  subdivlab prove mine.statements -o /tmp/certificates\n\n") +
                exit_codes);
    verb.callback([this] { action = [this] { return prove(prove_options); }; });
  }

  void add_verify() {
    auto& options = verify_options;
    CLI::App& verb =
        *app.add_subcommand("verify", "Check certificates in exact arithmetic, without searching");
    verb.add_option("PATH", options.paths, "Folders of certificates, or single ones")->capture_default_str();
    verb.add_flag("--print-statement", options.print_statement, "Say in words what each one proves");
    verb.add_flag("--missing", options.missing,
                  "List the exact or certified claims that have no certificate");
    verb.footer(std::string("Example:  subdivlab verify results/certificates --missing\n\n") + exit_codes);
    verb.callback([this] { action = [this] { return verify(verify_options); }; });
  }

  void add_list() {
    auto& options = list_options;
    CLI::App& verb =
        *app.add_subcommand("list", "Name the schemes, the claims, the objectives, the definitions");
    verb.add_option("WHAT", options.what,
                    "schemes, claims, objectives or definitions, of which your own claims can be made "
                    "(default: all)")
        ->check(CLI::IsMember({"schemes", "claims", "objectives", "definitions"}));
    verb.add_flag("--json", options.json, "Machine-readable output");
    verb.footer("Examples:  subdivlab list schemes\n           subdivlab list claims --json");
    verb.callback([this] { action = [this] { return list(list_options); }; });
  }

  void add_completion() {
    CLI::App& verb =
        *app.add_subcommand("completion", "Print a script that teaches a shell verbs, options and values");
    verb.add_option("SHELL", shell, "The shell")->required()->check(CLI::IsMember({"bash", "zsh", "fish"}));
    verb.footer(
        "Examples:  source <(subdivlab completion bash)\n"
        "           subdivlab completion fish | source");
    verb.callback([this] {
      action = [this] {
        const std::vector<VerbUsage> verbs = usage_of(app);
        std::cout << (shell == "bash"  ? bash_completion(verbs)
                      : shell == "zsh" ? zsh_completion(verbs)
                                       : fish_completion(verbs));
        return static_cast<int>(ExitCode::done);
      };
    });
  }

  void add_manual() {
    CLI::App& verb = *app.add_subcommand("manual", "Print the manual page");
    verb.footer("Example:  subdivlab manual | man -l -");
    verb.callback([this] {
      action = [this] {
        std::cout << manual_page(usage_of(app));
        return static_cast<int>(ExitCode::done);
      };
    });
  }
};

/// CLI11 speaks of an unexpected argument when a verb is misspelt; this names the verbs.
std::string usage_message(const CLI::App& app, const CLI::ParseError& error, int argc,
                          const char* const* argv) {
  std::vector<std::string> verbs;
  for (const CLI::App* verb : app.get_subcommands(nullptr)) verbs.push_back(verb->get_name());
  const std::string first = argc > 1 ? argv[1] : "";
  if (app.get_subcommands().empty() && !first.starts_with('-')) {
    if (first.empty()) return "no verb is given: one of " + joined(verbs);
    return "there is no verb " + in_quotes(first) + suggestion(first, verbs) + " The verbs are " +
           joined(verbs, "and");
  }
  return error.what();
}

}  // namespace

int run_command_line(int argc, const char* const* argv) {
  CommandLine line;
  try {
    line.app.parse(argc, argv);
  } catch (const CLI::Success& answer) {  // --help and --version
    line.app.exit(answer, std::cout, std::cerr);
    return ExitCode::done;
  } catch (const CLI::ParseError& error) {
    std::cerr << "subdivlab: " << usage_message(line.app, error, argc, argv)
              << "\n'subdivlab --help' shows examples\n";
    return ExitCode::bad_input;
  }
  try {
    return line.action();
  } catch (const InputError& error) {
    std::cerr << "subdivlab: " << error.what() << "\n";
    return ExitCode::bad_input;
  } catch (const std::exception& error) {
    std::cerr << "subdivlab: internal error: " << error.what() << "\n";
    return ExitCode::differs;
  }
}

}  // namespace subdiv::cli
