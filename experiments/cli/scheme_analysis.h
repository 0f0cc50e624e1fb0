#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/decision.h"
#include "experiments/report/record.h"
#include "schemes/scheme_description.h"

namespace subdiv::cli {

/// A mask as text: coefficients of the indices first, first + 1, ..
struct MaskText {
  int first = 0;
  std::vector<std::string> coefficients;
};

/// A mask that may not exist, and then why.
struct MaskAnswer {
  std::optional<MaskText> mask;
  std::string reason;
};

struct StepText {
  std::string name;
  std::vector<std::pair<std::string, std::string>> parameters;
  MaskText mask;
};

/// An eigenvalue of the repeating step: a closed form, or a real or complex enclosure, or the irreducible
/// factor of the characteristic polynomial (in x) of which it is a root.
struct EigenvalueText {
  std::optional<std::string> value;
  std::optional<DecimalEnds> real;
  std::optional<DecimalEnds> imaginary;
  std::optional<std::string> roots_of;
  int multiplicity = 1;
};

/// That limits are C^order, or may be: with a free parameter, for which values of it.
struct ContinuityText {
  int order = -1;
  std::string set;                      // necessary condition: all values of the parameter for which it holds
  std::optional<DecimalEnds> interval;  // certified: an open interval of the parameter
  std::optional<DecimalEnds> norm;      // certified without a parameter: below 1
  std::string exact_norm;               // its value where it is a known rational number
  int power = 0;                        // certified: the power of the iterate whose norm is below 1
};

/// A real number as text: its ends, its closed form where it has one, and both in short for people.
struct EnclosureText {
  DecimalEnds ends;
  std::string exact;
  std::string line;  // "3-log2(73/100) = 3.454031630894707..", "2", "1.0000 +- 7e-13", "in [1.9, 2.1]"
  Rigour rigour = Rigour::certified;
  Status status = Status::closed;
};

/// Continuity and Hoelder exponent, of a scheme's differences or of its limits (analysis/hoelder.h).
struct SmoothnessText {
  int continuity = -1;        // C^continuity is proved; -1: nothing
  int continuity_limit = -1;  // and nothing above this one is possible
  Decision converges = Decision::undecided;
  EnclosureText exponent;
  Decision attained = Decision::undecided;
  int factors = 0;       // smoothing factors of the symbol
  EnclosureText radius;  // joint spectral radius of the transition matrices of what they leave
  EnclosureText growth;  // of the first differences from step to step: below 1 for convergent schemes
  std::vector<std::string> words;  // products with that radius

  [[nodiscard]] bool closed() const {
    return continuity == continuity_limit && exponent.status == Status::closed;
  }
};

/// What can be said about smoothness of the repeating step. Without free parameters: decided by the joint
/// spectral radius, with a power of the difference scheme whose norm is below 1 and Reif's necessary
/// condition as second routes (at most one entry each). With a free parameter: sets of it from these two.
struct RegularityText {
  std::string parameter;  // the free one that the sets speak of; empty without
  std::vector<ContinuityText> certified;
  std::vector<ContinuityText> necessary;  // of the scheme, in the sense of its differences
  std::optional<SmoothnessText> scheme;
  std::optional<SmoothnessText> limits;
  Decision independent_shifts = Decision::undecided;
  std::string shift_factor;  // t(z) of analysis/unstable_shifts.h; empty when it is 1
  std::optional<EnclosureText> l2_exponent;
  std::optional<EnclosureText> single_matrix_radius;  // for symbols that are not negative
  std::vector<std::string> assumptions;               // sum rules that rounded coefficients only allow

  [[nodiscard]] bool closed() const { return scheme && scheme->closed() && limits->closed(); }
};

struct SchemeAnalysis {
  std::string text;  // as written
  int arity = 2;
  std::vector<std::string> free_parameters;
  std::vector<StepText> steps;
  std::pair<std::string, std::string> support;
  std::string parametric_shift;
  int sum_rules = 0;
  int generation_degree = 0;
  std::optional<int> reproduction_degree;
  std::string skipped;  // why eigenvalues and other answers were left out; else empty
  std::string remark;   // a suspicion about rounded coefficients; else empty
  std::vector<EigenvalueText> eigenvalues;
  MaskAnswer limit_mask;
  MaskAnswer tangent_mask;
  MaskAnswer area_mask;
  RegularityText regularity;
};

/// Everything that can be said of a scheme, exact over the smallest ring that holds its masks; over intervals
/// when no exact ring does or its decimals are rounded. The joint spectral radius may take the given time.
/// Throws InputError when the scheme is not affinely invariant or has no limit mask (J_s at s = -6).
[[nodiscard]] SchemeAnalysis analyse(const SchemeDescription& description, double seconds);

}  // namespace subdiv::cli
