#pragma once

#include <array>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace subdiv {

/// Pictures of surfaces: what popping of their silhouettes is measured on (js-report 9, figure 11; jsplines
/// 11, figure 16).

/// An orthographic view: x runs to the right and y up in the picture, depth towards the eye.
struct View {
  Eigen::Vector3d right;    ///< of unit length
  Eigen::Vector3d up;       ///< of unit length
  Eigen::Vector3d towards;  ///< of unit length, from the picture to the eye

  [[nodiscard]] Eigen::Vector2d project(const Eigen::Vector3d& p) const { return {right.dot(p), up.dot(p)}; }
  [[nodiscard]] double depth(const Eigen::Vector3d& p) const { return towards.dot(p); }
};

/// Seen from the direction given, the z axis upright. Throws std::invalid_argument for a direction without a
/// horizontal part.
[[nodiscard]] View view_from(const Eigen::Vector3d& direction);

/// A filled triangle of a picture, either way round; it may be flat.
using PictureTriangle = std::array<Eigen::Vector2d, 3>;

/// A quad a, b, c, d of a surface is drawn as the triangles a, b, c and a, c, d.
void append_quad(std::vector<PictureTriangle>& picture, const View& view, const Eigen::Vector3d& a,
                 const Eigen::Vector3d& b, const Eigen::Vector3d& c, const Eigen::Vector3d& d);

/// Areas of the sets of points that pictures cover.
struct PictureAreas {
  double first = 0;       ///< of the first picture
  double second = 0;      ///< of the second one
  double difference = 0;  ///< covered by one of them alone
};

/// Two pictures compared. Along each of `lines` horizontal lines, spread evenly over the height of both, the
/// covered intervals are exact up to rounding; between the lines the midpoint rule holds, with an error of
/// the order of height x width / lines^2. Throws std::invalid_argument for fewer than one line.
[[nodiscard]] PictureAreas compare_pictures(std::span<const PictureTriangle> first,
                                            std::span<const PictureTriangle> second, int lines);

}  // namespace subdiv
