#pragma once

#include <string>
#include <vector>

#include "analysis/enclosure.h"
#include "schemes/algebra/rational_function.h"

namespace subdiv {

/// The norm of a vector of residuals. l2 stands for the sum of squares (its minimisers are those of the
/// root).
enum class Norm { l1, l2, linf };

/// A closed range of one parameter.
struct Range {
  Rational lower;  ///< at most upper
  Rational upper;  ///< belongs to the range
};

/// Minimise the norm of a vector of residuals over a box of parameters: residuals are rational functions over
/// Q of x_0 .. x_{n-1}, with denominators that do not vanish on the box.
struct Problem {
  std::vector<RationalFunction> residuals;  ///< r_i
  Norm norm = Norm::linf;                   ///< what is minimised of them
  std::vector<Range> box;                   ///< one a parameter, in the order of the variables
  std::vector<std::string> names;           ///< of the parameters, for messages
};

/// Where the solver gives up.
struct Options {
  /// Largest width of the minimiser's enclosure that counts as done.
  Rational width = Rational(1, 1000000000000000);
  long precision = 192;      ///< bits of interval arithmetic
  int max_boxes = 200000;    ///< of branch and bound
  int max_precision = 1024;  ///< bits up to which a test that fails is repeated
  int starts = 24;           ///< of the local solver, spread over the box deterministically
};

/// Why the solver stopped. Only `proved` claims anything about the whole box; everything else leaves rigour
/// approximate.
enum class Termination {
  proved,  ///< every minimiser in the box lies in the enclosure; it is unique unless the message says less
  not_unique,  ///< the minimum is proved, its minimisers are several or a continuum: the enclosure holds one
               ///< of them
  out_of_boxes,      ///< branch and bound ran out: the local minimum is verified, globality is not
  not_isolated,      ///< the local critical point could not be verified
  pole_in_box,       ///< a residual's denominator may vanish on the box
  no_local_minimum,  ///< no start of the local solver converged
  local,             ///< the best of several local searches; nothing is proved
};

/// What was found, and what of it is proved.
struct Summary {
  Termination termination = Termination::no_local_minimum;  ///< why the solver stopped
  std::vector<Enclosure> minimiser;                         ///< one a parameter
  Enclosure minimum;  ///< l1: sum of |r_i|; linf: max |r_i|; l2: sum of r_i^2
  /// Indices of the residuals that determine the minimiser (linf: attain the maximum; l1: vanish there).
  std::vector<int> active;
  /// Of some problems of one parameter whose minimum is 0: every value in the range where it is attained.
  std::vector<Enclosure> zeros;
  int boxes = 0;        ///< examined by branch and bound
  std::string method;   ///< "exact LP with dual certificate", "Sturm", "Krawczyk and branch and bound"
  std::string message;  ///< one sentence for a user
};

/// Minimises and certifies; see the files named in method for how. Throws InputError when box and parameters
/// do not match or a range is empty.
[[nodiscard]] Summary minimise(const Problem& problem, const Options& options = {});

/// "l1", "l2" or "linf".
[[nodiscard]] std::string to_string(Norm norm);
/// The termination in a few words, as the program prints it.
[[nodiscard]] std::string to_string(Termination termination);

}  // namespace subdiv
