#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "schemes/argument.h"
#include "schemes/catalogue.h"
#include "schemes/scheme_file.h"

namespace subdiv {

/// One step of a scheme as written: a family of the catalogue or a scheme file, with a value for every
/// parameter.
struct StepDescription {
  std::string text;                        ///< "jspline:s=3/2"
  const Family* family = nullptr;          ///< exactly one of family and file is set
  const FamilyForm* form = nullptr;        ///< of the family
  std::shared_ptr<const SchemeFile> file;  ///< see family
  std::vector<Argument> arguments;         ///< in the order of the declared parameters, defaults filled in
  std::vector<long> whole;                 ///< the values of the form's whole parameters

  [[nodiscard]] const std::string& name() const { return file ? file->name : family->name; }
  [[nodiscard]] int arity() const { return file ? file->arity : form->mask(whole).arity; }
};

/// A scheme as written, before anything is evaluated; schemes/instantiate.h gives its masks over any ring.
struct SchemeDescription {
  std::string text;                    ///< as written
  std::vector<StepDescription> steps;  ///< the last repeats
  /// Names that stand in values without a value of their own, by first appearance. The same name in several
  /// values is the same parameter; free parameter i is the indeterminate x_i.
  std::vector<std::string> free_parameters;
  bool rounded = false;  ///< decimals in the masks of files are roundings
};

/// How a scheme as written is understood.
struct SchemeOptions {
  /// Take every decimal in the mask or symbol of a scheme file as known to half a unit of its last digit
  /// only. The sum of the coefficients then has to reach the arity within these tolerances instead of
  /// exactly.
  bool rounded = false;
};

/// Reads
///
///     SCHEME = STEP { + STEP }                   the last step repeats for ever
///     STEP   = (NAME | FILE.json) [ : parameter = value { , parameter = value } ]
///
/// A value is an exact expression (schemes/expression.h); a sum in it stands in parentheses. A name in a
/// value leaves a parameter free. Reads the files, checks parameters and values, and that every mask exists
/// at the given values, is not zero and sums to the arity. Throws InputError with the place, what is wrong
/// and what would be right.
[[nodiscard]] SchemeDescription parse_scheme(std::string_view text, const SchemeOptions& options = {});

}  // namespace subdiv
