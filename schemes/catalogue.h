#pragma once

#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "schemes/algebra/polynomial.h"
#include "schemes/mask.h"

namespace subdiv {

/// A parameter of a family: a real number, or a whole one from a range.
struct Parameter {
  std::string name;                                  ///< as it is written
  std::string meaning;                               ///< in a few words
  std::string default_value;                         ///< an expression; empty when a value must be given
  bool whole = false;                                ///< else real
  long least = 0;                                    ///< of a whole parameter
  long greatest = std::numeric_limits<long>::max();  ///< of a whole parameter
  long step = 1;                                     ///< whole values are least, least + step, ..

  [[nodiscard]] bool is_required() const { return default_value.empty(); }
  /// "a whole number from 0 to 200", "an even number from 2 to 64", "a real number".
  [[nodiscard]] std::string range() const;
};

/// One way to give a family's parameters, and the mask that they determine: polynomials over Q in the real
/// parameters, x_0 for the first of them, x_1 for the second; whole parameters are passed by value, in the
/// order of `parameters`.
struct FamilyForm {
  std::vector<Parameter> parameters;                      ///< in the order in which they are listed
  Mask<Polynomial> (*mask)(std::span<const long> whole);  ///< the mask at whole values
};

/// A named family of schemes.
struct Family {
  std::string name;                  ///< as it is written
  std::vector<std::string> aliases;  ///< other names for the same
  std::string summary;               ///< one line
  std::string source;                ///< who introduced it
  std::vector<FamilyForm> forms;     ///< ways to give the parameters
};

/// Every family, in the order in which they are listed.
[[nodiscard]] std::span<const Family> catalogue();

/// The family with this name or alias. Throws InputError that suggests the nearest name and lists all.
[[nodiscard]] const Family& find_family(std::string_view name);

/// The form of the family that takes parameters of these names. Throws InputError for names that no form
/// takes (suggesting the nearest), names of different forms, and missing parameters that have no default.
[[nodiscard]] const FamilyForm& find_form(const Family& family, std::span<const std::string> given);

/// "jspline takes s, or a and b"; "four-point takes w (1/16)": the parameters with their defaults.
[[nodiscard]] std::string usage(const Family& family);

}  // namespace subdiv
