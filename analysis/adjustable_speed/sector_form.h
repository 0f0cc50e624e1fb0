#pragma once

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "schemes/adjustable_speed/sector_net.h"
#include "schemes/adjustable_speed/speed_rules.h"
#include "schemes/algebra/ring.h"

namespace subdiv {

/// A combination of the points of a net with two rings around a vertex (SectorNet), for all valences at once,
/// as sector k sees it:
///
///   vertex P_0 + sum of mean_p M_p + sum of at_(o, p) P_{k+o, p},
///
/// M_p the mean over all sectors of the points at place p. Sectors k + o are counted without returning to the
/// first one: an identity between forms holds for every valence n, where o is taken modulo n. Weights are not
/// 0, so that equal forms are equal term by term.
template <ExactRing R>
struct SectorForm {
  R vertex = R(0);        ///< weight of P_0
  std::map<int, R> mean;  ///< mean_p by the place p
  /// At_(o, p) by the sector o, counted from the own one, and the place p.
  std::map<std::pair<int, int>, R> at;

  /// The sum of all weights: 1 for an affine combination.
  [[nodiscard]] R sum() const {
    R result = vertex;
    for (const auto& [place, weight] : mean) result = result + weight;
    for (const auto& [point, weight] : at) result = result + weight;
    return result;
  }
  [[nodiscard]] R mean_weight(int place) const { return weight_of(mean, place); }
  [[nodiscard]] R weight(int sector, int place) const { return weight_of(at, std::pair{sector, place}); }

  friend bool operator==(const SectorForm& a, const SectorForm& b) {
    return a.vertex == b.vertex && a.mean == b.mean && a.at == b.at;
  }

 private:
  template <class Map, class Key>
  static R weight_of(const Map& map, const Key& key) {
    const auto found = map.find(key);
    return found == map.end() ? R(0) : found->second;
  }
};

/// Adds to one weight of a map; weights that become 0 are dropped.
template <class R, class Key>
void add_to_weight(std::map<Key, R>& weights, const Key& key, const R& summand) {
  R& weight = weights.try_emplace(key, R(0)).first->second;
  weight = weight + summand;
  if (is_zero(weight)) weights.erase(key);
}

/// sum += weight form.
template <ExactRing R>
void add_weighted(SectorForm<R>& sum, const R& weight, const SectorForm<R>& form) {
  sum.vertex = sum.vertex + weight * form.vertex;
  for (const auto& [place, w] : form.mean) add_to_weight(sum.mean, place, R(weight * w));
  for (const auto& [point, w] : form.at) add_to_weight(sum.at, point, R(weight * w));
}

/// The form as the sector `sectors` steps counter-clockwise sees it.
template <ExactRing R>
SectorForm<R> turned(const SectorForm<R>& form, int sectors) {
  SectorForm<R> result{form.vertex, form.mean, {}};
  for (const auto& [point, w] : form.at) result.at.emplace(std::pair{point.first + sectors, point.second}, w);
  return result;
}

/// Its mean over all sectors.
template <ExactRing R>
SectorForm<R> averaged(const SectorForm<R>& form) {
  SectorForm<R> result{form.vertex, form.mean, {}};
  for (const auto& [point, w] : form.at) add_to_weight(result.mean, point.second, w);
  return result;
}

/// The points of a net as forms of those of another: a net like any other for apply, border_points.
template <ExactRing R>
class FormNet {
 public:
  /// The net itself.
  FormNet() {
    vertex_.vertex = R(1);
    for (std::size_t p = 0; p < SectorNet<R>::places; ++p) {
      SectorForm<R> own;
      own.at.emplace(std::pair{0, static_cast<int>(p)}, R(1));
      places_.push_back(std::move(own));
    }
  }
  /// The vertex, and the places of the own sector.
  FormNet(SectorForm<R> vertex, std::vector<SectorForm<R>> places)
      : vertex_(std::move(vertex)), places_(std::move(places)) {}

  [[nodiscard]] const SectorForm<R>& centre() const { return vertex_; }
  /// The point at a place of a sector, its form as that sector sees it.
  [[nodiscard]] SectorForm<R> at(int sector, int place) const {
    return turned(places_[static_cast<std::size_t>(place)], sector);
  }
  friend bool operator==(const FormNet& a, const FormNet& b) {
    return a.vertex_ == b.vertex_ && a.places_ == b.places_;
  }

 private:
  SectorForm<R> vertex_;
  std::vector<SectorForm<R>> places_;
};

/// The form of the points of `net` as one of the points that `net` itself is made of.
template <ExactRing R>
SectorForm<R> substituted(const SectorForm<R>& form, const FormNet<R>& net) {
  SectorForm<R> result;
  add_weighted(result, form.vertex, net.centre());
  for (const auto& [place, w] : form.mean) add_weighted(result, w, averaged(net.at(0, place)));
  for (const auto& [point, w] : form.at) add_weighted(result, w, net.at(point.first, point.second));
  return result;
}

/// outer of the points that inner gives.
template <ExactRing R>
FormNet<R> composed(const FormNet<R>& outer, const FormNet<R>& inner) {
  std::vector<SectorForm<R>> places;
  for (std::size_t p = 0; p < SectorNet<R>::places; ++p)
    places.push_back(substituted(outer.at(0, static_cast<int>(p)), inner));
  return {substituted(outer.centre(), inner), std::move(places)};
}

/// alpha of the vertex, beta of the mean of its edge neighbours and gamma of that of the (1, 1).
template <ExactRing R>
SectorForm<R> central_form(const R& alpha, const R& beta, const R& gamma) {
  SectorForm<R> result;
  result.vertex = alpha;
  add_to_weight(result.mean, sector_place(1, 0).place, beta);
  add_to_weight(result.mean, sector_place(1, 1).place, gamma);
  return result;
}

/// One step of adjustable speed (refined_net).
template <ExactRing R>
FormNet<R> step_of_speed(const R& sigma, const VertexWeights<R>& weights) {
  const std::vector<SectorStencil<R>> rules = refined_places(sigma);
  std::vector<SectorForm<R>> places;
  for (std::size_t p = 0; p < SectorNet<R>::places; ++p) places.push_back(apply(rules[p], FormNet<R>(), 0));
  return {central_form(R(R(1) - weights.beta - weights.gamma), weights.beta, weights.gamma),
          std::move(places)};
}

/// The net over other knots (changed_net).
template <ExactRing R>
FormNet<R> change_of_knots(const LineKnots<R>& from, const LineKnots<R>& to) {
  std::vector<SectorForm<R>> places;
  for (const SectorStencil<R>& rule : changed_places(from, to))
    places.push_back(apply(rule, FormNet<R>(), 0));
  return {FormNet<R>().centre(), std::move(places)};
}

}  // namespace subdiv
