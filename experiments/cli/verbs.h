#pragma once

#include <string>
#include <vector>

namespace subdiv::cli {

/// What the program answers to its caller; a refuted claim is a result and not a failure.
enum ExitCode : int {
  done = 0,
  differs = 1,    // a comparison fails, a verdict changed, an experiment broke
  bad_input = 2,  // bad input or usage
  undecided = 3,  // the budget ran out before an answer
};

struct ReproduceOptions {
  std::vector<std::string> patterns;
  std::string claims;  // a file of one's own claims (experiments/own_claims.h) instead of the built-in ones
  std::string out;     // empty: results, which with claims of one's own is an error
  int jobs = 1;
};
/// Runs experiments, writes the results folder and prints the table of claims.
[[nodiscard]] int reproduce(const ReproduceOptions& options);

struct CheckOptions {
  std::vector<std::string> patterns;
  std::string claims;   // as for reproduce
  std::string against;  // empty: results, which with claims of one's own is an error
  int jobs = 1;
};
/// Runs experiments, prints how they differ from a results folder, writes nothing.
[[nodiscard]] int check(const CheckOptions& options);

struct AnalyzeOptions {
  std::string scheme;
  double budget = 30;    // seconds for each joint spectral radius
  bool rounded = false;  // decimals in scheme files stand for intervals of half a unit of their last digit
  bool json = false;
};
/// Prints everything that can be said of a scheme.
[[nodiscard]] int analyze(const AnalyzeOptions& options);

struct OptimizeOptions {
  std::string scheme;
  std::string over;       // "r=-2..2,s=0..1"
  std::string objective;  // "vertex", "fit-bspline:degree=2"
  std::string norm;       // l1, l2 or linf; may be empty with a polygon
  std::string polygon;    // the file of the polygon that the objective is about; empty for none
  bool json = false;
};
/// Minimises a named objective over a box of the scheme's free parameters, with proof.
[[nodiscard]] int optimize(const OptimizeOptions& options);

struct PlotOptions {
  std::string scheme;
  std::string over;  // "w=0..1/10": the exponent over the only free parameter; empty: the basis function
  std::string out;   // .svg, or - for standard output
};
/// Draws the basis function of a scheme, or its smoothness over a parameter.
[[nodiscard]] int plot(const PlotOptions& options);

struct CertifyOptions {
  std::string scheme;
  std::string over;  // "w=0..1/10"; a range may be one value, w=1/16..1/16
  int continuity = 0;
  double budget = 10;  // seconds
  bool json = false;
};
/// Proves or refutes a class of continuity for all values of the scheme's free parameters in a box.
[[nodiscard]] int certify(const CertifyOptions& options);

struct EigenOptions {
  std::string scheme;   // a mesh scheme; at most one free parameter
  std::string valence;  // "5" or "3..30"
  std::string over;     // "s=LO..HI" for the free parameter
  bool json = false;
};
/// Eigenvalues and characteristic maps at extraordinary vertices, one answer a valence.
[[nodiscard]] int eigen(const EigenOptions& options);

struct RefineOptions {
  std::string scheme;
  int levels = 0;
  std::string input;        // .csv or .obj; .obj, .off or .ply for a mesh
  std::string out;          // .csv, .obj, .svg or - for standard output; .obj, .off, .ply, .svg for a mesh
  std::string open;         // clamped, reflected or empty for closed: a curve, or the rows of a grid
  std::string open_across;  // the same for the columns of a grid
  std::string grid;         // "ROWSxCOLUMNS", or empty for a curve
  std::string details;      // .csv: level,index,dx,dy
  std::string retrofit;     // direct, iteration or empty
  bool limit = false;       // limit points instead of the refined ones
  int threads = 0;          // for meshes; 0: one a processor
};
/// Refines a polygon, a grid or a mesh and writes it as it comes.
[[nodiscard]] int refine(const RefineOptions& options);

struct RingsOptions {
  std::string input;            // a mesh, .obj, .off or .ply
  std::string sigma;            // "1/2,3/4": a speed a step; empty for no steps
  std::string out;              // .obj, .off, .ply, .svg or - for standard output; may be empty
  std::string control_points;   // .obj (free-form) or .bv; may be empty
  int catmull_clark_steps = 0;  // before the rings
  int tessellation = 4;         // of each patch, N x N quads
  bool fill = false;            // a cap for each hole
  bool rings_only = false;      // leave out the patches of regular faces
  bool json = false;
};
/// Writes the Catmull-Clark surface of a mesh in bicubic patches, with rings of adjustable speed around
/// extraordinary vertices, and prints what they leave open.
[[nodiscard]] int rings(const RingsOptions& options);

struct BezierOptions {
  std::string input;  // .csv or .obj
  int degree = 3;
  double tolerance = 0;  // 0: not given
  int depth = -1;        // -1: not given
  std::string out;       // .csv, .obj, .svg or - for standard output
  bool json = false;
};
/// Draws consecutive Bezier curves as a polyline and prints how far it may be from them.
[[nodiscard]] int bezier(const BezierOptions& options);

struct MeasureOptions {
  std::string input;
  std::string open;    // whether the polygon is open: clamped, reflected for a scheme; "plain" without
  std::string scheme;  // measure the levels of its refinements, too
  int levels = 0;
  std::string against;   // a second polygon
  double tolerance = 0;  // of distances; 0 for a millionth of the extent
  bool local = false;    // estimates at every vertex and edge, of the finest level
  bool json = false;
};
/// Prints length, area, normal jerk and distances of polygons.
[[nodiscard]] int measure(const MeasureOptions& options);

struct SmoothOptions {
  std::string input;
  std::string operators;  // "tuck(1/2); tuck(-53/100)"
  long repeat = 1;
  std::string open;  // drop or keep; empty for closed
  std::string json;  // a file for the report, - for standard output; may be empty
  std::string out;   // .csv, .obj, .svg or - for standard output
};
/// Applies a sequence of polyloop operators to a polygon, writes it, and prints what was kept of it.
[[nodiscard]] int smooth(const SmoothOptions& options);

struct ProveOptions {
  std::vector<std::string> files;  // of statements
  std::string out;                 // the folder for the certificates
  std::string claims = "results";  // the results folder whose values fill in the statements
};
/// Finds the witnesses of statements and writes their certificates.
[[nodiscard]] int prove(const ProveOptions& options);

struct VerifyOptions {
  std::vector<std::string> paths{"results/certificates"};  // folders and files
  bool print_statement = false;
  bool missing = false;  // list the claims without certificate
};
/// Checks certificates, and their values against the claims.json beside the folder.
[[nodiscard]] int verify(const VerifyOptions& options);

struct ListOptions {
  std::string what;  // schemes, claims, objectives, definitions, or empty for all
  bool json = false;
};
[[nodiscard]] int list(const ListOptions& options);

/// Reads the command line and runs the verb; prints help, the version and errors of usage. Returns the exit
/// code.
[[nodiscard]] int run_command_line(int argc, const char* const* argv);

}  // namespace subdiv::cli
