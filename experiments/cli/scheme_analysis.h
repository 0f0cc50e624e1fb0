#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

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

/// What can be said about smoothness of the repeating step's limits: certified by a power of the difference
/// scheme whose norm is below 1, and Reif's necessary condition. Without free parameters one entry each at
/// most.
struct RegularityText {
  std::string parameter;  // the free one that the sets speak of; empty without
  std::vector<ContinuityText> certified;
  std::vector<ContinuityText> necessary;
  bool closed = false;  // both say the same
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
  int reproduction_degree = 0;
  std::string skipped;  // why eigenvalues, area mask and regularity were left out; else empty
  std::vector<EigenvalueText> eigenvalues;
  MaskAnswer limit_mask;
  MaskAnswer tangent_mask;
  MaskAnswer area_mask;
  RegularityText regularity;
};

/// Everything that can be said of a scheme, exact over the smallest ring that holds its masks. Throws
/// InputError when no exact ring does, or when the scheme has no limit mask (J_s at s = -6).
[[nodiscard]] SchemeAnalysis analyse(const SchemeDescription& description);

}  // namespace subdiv::cli
