#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "schemes/argument.h"
#include "schemes/catalogue.h"
#include "schemes/mesh/mesh_scheme.h"

namespace subdiv {

/// A named family of schemes for meshes; its parameters are real numbers.
struct MeshFamily {
  std::string name;                    ///< as it is written
  std::string summary;                 ///< one line
  std::string source;                  ///< who introduced it
  std::vector<Parameter> parameters;   ///< all real
  MeshSplit split = MeshSplit::quads;  ///< which faces it makes
  /// Made for one extraordinary vertex and the rings of surface around it (schemes/adjustable_speed/): there
  /// are no rules for whole meshes.
  bool rings_only = false;
};

/// Every family of mesh schemes, in the order in which they are listed.
[[nodiscard]] std::span<const MeshFamily> mesh_catalogue();

/// Their names.
[[nodiscard]] std::vector<std::string> mesh_scheme_names();

/// Whether a scheme as written ("loop", "jspline-mesh:s=1/2") begins with the name of a mesh scheme.
[[nodiscard]] bool names_mesh_scheme(std::string_view text);

/// "jspline-mesh takes s"; "loop takes no parameters".
[[nodiscard]] std::string usage(const MeshFamily& family);

/// A mesh scheme as written, before anything is evaluated.
struct MeshSchemeDescription {
  std::string text;                    ///< "jspline-mesh:s=1/2"
  const MeshFamily* family = nullptr;  ///< that it names
  std::vector<Argument> arguments;     ///< one for each parameter of the family, in its order
  /// Names that stand in values without a value of their own, by first appearance; free parameter i is the
  /// indeterminate x_i.
  std::vector<std::string> free_parameters;
};

/// Reads NAME [ : parameter = value { , parameter = value } ], values as parse_scheme does; a name in a value
/// leaves a parameter free. Throws InputError for unknown names (suggesting the nearest; names of schemes for
/// curves are told apart), for parameters that are unknown or missing, for '+', and for values at which the
/// scheme does not exist: jspline-mesh at s = 9, adjustable-speed outside (0, 1).
[[nodiscard]] MeshSchemeDescription parse_mesh_scheme(std::string_view text);

/// The values of the family's parameters, in its order, over the rings of mesh_scheme; free_values and errors
/// as there.
template <class R>
[[nodiscard]] std::vector<R> parameter_values(const MeshSchemeDescription& description,
                                              std::span<const R> free_values = {});

/// The described scheme over R = double, Interval, Rational, Algebraic or RationalFunction; free_values[i]
/// stands for the free parameter i (std::domain_error unless there is one for each). Throws InputError where
/// a value or the scheme does not exist (also where an interval does not exclude it), OutsideRingError for a
/// root that R does not hold. The weights of loop-1987 are rational at the valences 3, 4 and 6 only: its
/// rules throw std::domain_error at others over Rational and RationalFunction. Throws InputError for families
/// that make rings only.
template <class R>
[[nodiscard]] MeshScheme<R> mesh_scheme(const MeshSchemeDescription& description,
                                        std::span<const R> free_values = {});

/// The scheme over the rational functions of its free parameters, x_i for free parameter i. Where x_t is
/// given, t = turn_variable, it stands for cos(2 pi/n) in rules at a vertex of valence n.
[[nodiscard]] MeshScheme<RationalFunction> symbolic_mesh_scheme(const MeshSchemeDescription& description,
                                                                std::optional<int> turn_variable = {});

}  // namespace subdiv
