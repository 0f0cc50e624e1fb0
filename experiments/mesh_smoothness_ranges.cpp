#include "experiments/mesh_smoothness_ranges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <map>
#include <optional>
#include <stdexcept>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "analysis/mesh/condition_end.h"
#include "analysis/mesh/mesh_condition.h"
#include "experiments/mesh_smoothness_text.h"
#include "schemes/algebra/thread_caches.h"
#include "schemes/mesh/jspline_mesh.h"

namespace subdiv {
namespace {

using Function = RationalFunction;

const std::string section = "jsplines 10";
const std::string by_cells =
    "Proved on whole intervals of s: roots counted in circles, in interval arithmetic, from the exact "
    "characteristic polynomials of the Fourier modes. ";
constexpr int most_valence = 30;
/// Valences whose ends are records of their own.
constexpr std::array claimed_valences{3, 5, 6, 8, 30};

/// The valences 3 .. 30 of the paper but the regular 4.
std::vector<int> paper_valences() {
  std::vector<int> result;
  for (int n = 3; n <= most_valence; ++n) {
    if (n != 4) result.push_back(n);
  }
  return result;
}

std::vector<int> all_valences() {
  std::vector<int> result = paper_valences();
  for (const int n : {31, 40}) result.push_back(n);
  return result;
}

ClaimHead end_head(const std::string& scheme, const std::string& text, int n, const std::string& side) {
  std::string definition = text;
  definition += eigenvalue_condition;
  definition += fmt::format(
      "The {} end of the interval of s around [0, 1], within [-2, 6], for which it holds, n = {}. ", side, n);
  definition += by_cells;
  definition +=
      "The end: in the last cell one eigenvalue or pair alone rivals lambda, and their difference is "
      "monotone; Newton's method for intervals finds its zero.";
  return finding(fmt::format("mesh.range.{}.n{}.{}", scheme, n, side), section, definition);
}

void append_heads(std::vector<ClaimHead>& table, const std::string& id, const std::string& text) {
  const std::string condition = text + eigenvalue_condition;
  table.push_back(finding("mesh.conjecture." + id + ".eigenvalues", section,
                          condition + by_cells +
                              "Valences 3 .. 30 but the regular 4, every s of the closed interval "
                              "[-1/4, 3/2]."));
  table.push_back(ClaimHead{
      "mesh.conjecture." + id + ".failure", "jsplines", "10",
      "not always smooth, especially at high valence with values of s near -2 or 6", ClaimKind::exact,
      condition + "Settled by its first half: at s = -7/4 and at s = 23/4 some valence of 3 .. 30 "
                  "fails, for which the limits are not C1 and injective for generic points."});
  table.push_back(finding(
      "mesh.range." + id + ".first-failure", section,
      condition + by_cells + "The least valence above 30 from which on, up to 60, it fails at s = 3/2."));
  for (const int n : claimed_valences) {
    table.push_back(end_head(id, text, n, "lower"));
    table.push_back(end_head(id, text, n, "upper"));
  }
}

// ---- Ends ------------------------------------------------------------------------------------------------

struct End {
  Rational low, high;          // the end lies between
  std::optional<Rival> rival;  // what reaches lambda there, its mode proved; none at a border of [-2, 6]
};

struct Ends {
  End lower;
  End upper;
};

const Rational from(-2);
const Rational to(6);

/// Cells from near to far from [0, 1].
std::vector<ConditionCell> outwards(const SpectralCondition& condition, const Rational& near,
                                    const Rational& far, const Rational& width) {
  if (near < far) return condition.cells(near, far, width);
  std::vector<ConditionCell> result = condition.cells(far, near, width);
  std::ranges::reverse(result);
  return result;
}

/// The end in a cell that begins where the condition holds: smaller cells as long as its proof needs them.
/// Throws std::logic_error when it is not proved.
End end_in(const SpectralCondition& condition, ConditionCell cell, bool above) {
  constexpr std::array bits{14L, 16L, 18L, 20L};
  for (const long k : bits) {
    const auto end = condition_end(condition, cell.lower, cell.upper);
    if (end && end->holds_below == above) return {end->at.lower(), end->at.upper(), end->rival};
    const auto parts = outwards(condition, above ? cell.lower : cell.upper, above ? cell.upper : cell.lower,
                                Rational::power_of_two(-k));
    const auto open = std::ranges::find(parts, Decision::undecided, &ConditionCell::holds);
    const bool begins =
        open == parts.begin() || (open == parts.begin() + 1 && parts.front().holds == Decision::yes);
    if (open == parts.end() || !begins) break;
    cell = *open;
  }
  throw std::logic_error(fmt::format("an end of the condition at valence {} is not proved near {}",
                                     condition.valence(), cell.lower.to_string()));
}

/// One end of the component around [0, 1], looked for outwards piece after piece.
End find_end(const SpectralCondition& condition, bool above) {
  const Rational border = above ? to : from;
  const Rational piece(above ? 1 : -1, 4);
  const Rational width = Rational::power_of_two(-12);
  Rational edge(above ? 1 : 0);
  while (!(edge == border)) {
    const Rational far = above ? std::min(edge + piece, border) : std::max(edge + piece, border);
    const std::vector<ConditionCell> cells = outwards(condition, edge, far, width);
    const ConditionCell* next = cells.data();
    if (next->holds == Decision::yes) {
      edge = above ? next->upper : next->lower;
      if (cells.size() == 1) continue;
      ++next;
      // The end may lie in the next piece.
      if (next == &cells.back() && next->holds == Decision::undecided && !(far == border)) continue;
    }
    return end_in(condition, *next, above);
  }
  return {border, border, std::nullopt};
}

Ends find_ends(const SpectralCondition& condition) {
  const auto middle = condition.cells(Rational(0), Rational(1), Rational::power_of_two(-12));
  if (middle.size() != 1 || middle[0].holds != Decision::yes) {
    throw std::logic_error("the condition is not proved on [0, 1]");
  }
  return {find_end(condition, false), find_end(condition, true)};
}

std::string rival_text(const Rival& rival) {
  if (rival.value.imag() != 0) {
    return fmt::format("a complex pair of mode {} exceeds lambda in modulus", rival.mode);
  }
  return fmt::format("{} eigenvalue of mode {} exceeds lambda{}",
                     rival.value.real() < 0 ? "a negative" : "a positive", rival.mode,
                     rival.value.real() < 0 ? " in modulus" : "");
}

struct Family {
  std::string name;
  ModeEquation turning;
  ModeEquation invariant;  // over Q(s, 1/n)

  [[nodiscard]] SpectralCondition at(int valence) const {
    return spectral_condition(turning, invariant, valence);
  }
};

Family family(const std::string& name, const MeshScheme<Function>& scheme) {
  return {name, turning_modes(scheme), invariant_modes(scheme)};
}

Enclosure enclosure(const End& end) {
  return certified(end.low, end.high, end.rival ? "Newton's method for intervals" : "cells");
}

/// All valences, on two threads.
std::map<int, Ends> all_ends(const Family& f) {
  const std::vector<int> all = all_valences();
  std::vector<Ends> found(all.size());
  const auto work = [&](std::size_t begin) {
    for (std::size_t i = begin; i < all.size(); i += 2) found[i] = find_ends(f.at(all[i]));
  };
  {
    std::exception_ptr failure;
    std::jthread other([&] {
      try {
        work(1);
      } catch (...) {
        failure = std::current_exception();
      }
      release_thread_caches();
    });
    work(0);
    other.join();
    if (failure) std::rethrow_exception(failure);
  }
  std::map<int, Ends> result;
  for (std::size_t i = 0; i < all.size(); ++i) result.emplace(all[i], std::move(found[i]));
  return result;
}

std::string end_note(const End& end, const std::string& beyond) {
  if (!end.rival) return "It holds up to this border of the range looked at.";
  return beyond + " it " + rival_text(*end.rival) + ".";
}

void add_ends(Results& results, std::span<const ClaimHead> heads, const Family& f,
              const std::map<int, Ends>& ends) {
  constexpr int digits = 15;
  Series series{"mesh-range-" + f.name, {"valence", "lower", "upper"}, {}};
  for (const auto& [n, e] : ends) {
    series.rows.push_back({std::to_string(n),
                           to_significant((e.lower.low + e.lower.high) / Rational(2), digits),
                           to_significant((e.upper.low + e.upper.high) / Rational(2), digits)});
    if (std::ranges::find(claimed_valences, n) == claimed_valences.end()) continue;
    const std::string id = fmt::format("mesh.range.{}.n{}.", f.name, n);
    results.claims.push_back(
        settle(head(heads, id + "lower"), enclosure(e.lower), end_note(e.lower, "Just below")));
    results.claims.push_back(
        settle(head(heads, id + "upper"), enclosure(e.upper), end_note(e.upper, "Just above")));
  }
  results.series.push_back(std::move(series));
}

/// Upper ends alone, which cost little at large valences: they tend to 1 (mesh.valence-limit).
void add_large_valences(Results& results, const Family& f) {
  constexpr int digits = 15;
  Series series{"mesh-range-" + f.name + "-upper", {"valence", "upper"}, {}};
  for (const int n : {30, 40, 60, 100, 200, 400}) {
    const End end = find_end(f.at(n), true);
    series.rows.push_back({std::to_string(n), to_significant((end.low + end.high) / Rational(2), digits)});
  }
  results.series.push_back(std::move(series));
}

// ---- The conjecture --------------------------------------------------------------------------------------

/// At s = 3/2 an eigenvalue of mode 0 is proved larger in modulus than all of mode 1.
bool mode_0_leads(const SpectralCondition& condition) {
  const Rational at(3, 2);
  const Rival rival = condition.rival(at);
  const Interval radius(std::sqrt(std::abs(rival.value) * rival.subdominant));
  const auto beyond = condition.beyond(at, at, radius);
  return beyond && (*beyond)[0] > 0 && (*beyond)[1] == 0;
}

Claim first_failure(const ClaimHead& head, const Family& f) {
  constexpr int most = 60;
  int first = most + 1;
  while (first - 1 > most_valence && mode_0_leads(f.at(first - 1))) --first;
  if (first > most || f.at(first - 1).decide(Rational(3, 2)) != Decision::yes) {
    throw std::logic_error("the first failure above valence 30 is not decided");
  }
  return settle(head, exact(Rational(first), "roots in circles"),
                "At s = 3/2 and these valences an eigenvalue of mode 0 is larger in modulus than all of mode "
                "1, and so it is just below 3/2; at the valence before the condition holds. The conjecture "
                "does not extend to all valences.");
}

/// The valence of 3 .. 30 whose range ends first on the side, its end apart from all others; 0 when that is
/// not decided.
int first_to_end(const std::map<int, Ends>& ends, bool above) {
  const auto is_first = [&](int n) {
    return std::ranges::all_of(paper_valences(), [&](int m) {
      if (m == n) return true;
      return above ? ends.at(n).upper.high < ends.at(m).upper.low
                   : ends.at(m).lower.high < ends.at(n).lower.low;
    });
  };
  for (const int n : paper_valences()) {
    if (is_first(n)) return n;
  }
  return 0;
}

void add_conjecture(Results& results, std::span<const ClaimHead> heads, const Family& f,
                    const std::map<int, Ends>& ends) {
  // It holds from end to end.
  const bool holds = std::ranges::all_of(paper_valences(), [&](int n) {
    return ends.at(n).lower.high <= Rational(-1, 4) && Rational(3, 2) <= ends.at(n).upper.low;
  });
  const int below = first_to_end(ends, false);
  const int above = first_to_end(ends, true);
  if (below == 0 || above == 0) throw std::logic_error("the first valence to end is not decided");
  constexpr int digits = 8;
  const std::string first =
      fmt::format("Of the valences 3 .. 30, {} is the first to end downwards, at {}, and {} upwards, at {}.",
                  below, to_significant(ends.at(below).lower.high, digits), above,
                  to_significant(ends.at(above).upper.low, digits));
  const std::string id = "mesh.conjecture." + f.name;
  results.claims.push_back(settle_statement(head(heads, id + ".eigenvalues"), holds, holds ? "true" : "false",
                                            "The ends -1/4 and 3/2 included. " + first +
                                                " With the characteristic maps: mesh.smooth." + f.name + ".",
                                            Rigour::certified));
  results.claims.push_back(first_failure(head(heads, "mesh.range." + f.name + ".first-failure"), f));
  std::string where;
  bool fails = true;
  for (const Rational& at : {Rational(-7, 4), Rational(23, 4)}) {
    std::string failing;
    for (const int n : paper_valences()) {
      if (f.at(n).decide(at) != Decision::no) continue;
      failing += failing.empty() ? "" : ", ";
      failing += std::to_string(n);
    }
    fails = fails && !failing.empty();
    where += fmt::format("{}s = {}: valences {}", where.empty() ? "" : "; ", at.to_string(), failing);
  }
  results.claims.push_back(settle_statement(
      head(heads, id + ".failure"), fails, where,
      "These are the valences proved to fail. \"Especially at high valence\" is no statement "
      "that a proof could settle. " +
          first,
      Rigour::certified));
}

}  // namespace

std::vector<ClaimHead> mesh_range_heads() {
  std::vector<ClaimHead> table{finding(
      "mesh.blend.as-printed", section,
      "The formula as printed, (1-s) Catmull-Clark + s Kobbelt: the end of the s > 0 for which the condition "
      "holds at valence 3. " +
          eigenvalue_condition)};
  append_heads(table, "directional", directional_scheme);
  append_heads(table, "literal", literal_scheme);
  return table;
}

void add_mesh_ranges(Results& results, std::span<const ClaimHead> heads) {
  const Function s = Function::variable(0);
  for (const Family& f :
       {family("directional", jspline_mesh(s)), family("literal", jspline_mesh_literal(s))}) {
    const std::map<int, Ends> ends = all_ends(f);
    add_ends(results, heads, f, ends);
    add_large_valences(results, f);
    add_conjecture(results, heads, f, ends);
    if (f.name != "literal") continue;
    // s and 1 - s change places.
    const Enclosure lower = enclosure(ends.at(3).lower);
    results.claims.push_back(
        settle(head(heads, "mesh.blend.as-printed"),
               certified(Rational(1) - lower.upper, Rational(1) - lower.lower, lower.method),
               "Below 3/2, the end that the paper gives for its conjecture, which is right for the formula "
               "with Sc and Sk interchanged: that settles the misprint."));
  }
}

}  // namespace subdiv
