#include <algorithm>

#include "experiments/mesh_formats.h"
#include "schemes/text.h"

namespace subdiv {
namespace {

/// "v x y z" or "v x y z red green blue".
Point3 vertex(const FileReader& reader, std::string_view text) {
  Point3 point{};
  for (double& coordinate : point) {
    const std::string_view word = next_word(text);
    if (word.empty()) reader.reject("a vertex has three coordinates: v x y z");
    coordinate = to_coordinate(reader, word);
  }
  constexpr int colours = 3;
  int more = 0;
  while (!next_word(text).empty()) ++more;
  if (more != 0 && more != colours)
    reader.reject("a vertex has three coordinates, with or without three of its colour: v x y z");
  return point;
}

/// "3", "3/1", "3//2" or "3/1/2", 0-based. Vertices may follow below, so only find_fault knows the largest.
long long corner(const FileReader& reader, std::string_view word, std::size_t vertices) {
  const std::size_t slash = word.find('/');
  const std::string_view rest = slash == std::string_view::npos ? "" : word.substr(slash);
  if (rest.find_first_not_of("/-0123456789") != std::string_view::npos ||
      std::count(rest.begin(), rest.end(), '/') > 2) {
    reader.reject(in_quotes(word) + " is no corner; expected a, a/b, a//c or a/b/c");
  }
  const long long index = to_integer(reader, word.substr(0, slash));
  if (index > 0) return index - 1;
  const auto count = static_cast<long long>(vertices);
  if (index == 0 || index < -count) {
    reader.reject(in_quotes(word) + " names no vertex: there are " + std::to_string(vertices) +
                  " above this line, counted from 1, or from the last one down from -1");
  }
  return count + index;
}

}  // namespace

void read_obj(FileReader& reader, MeshFile& mesh) {
  std::vector<long long> corners;
  bool curve = false;
  for (std::string_view line; reader.next_line(line);) {
    line = without_comment(line);
    const std::string_view keyword = next_word(line);
    if (keyword == "v") {
      mesh.points.push_back(vertex(reader, line));
    } else if (keyword == "f") {
      corners.clear();
      for (std::string_view word = next_word(line); !word.empty(); word = next_word(line))
        corners.push_back(corner(reader, word, mesh.points.size()));
      mesh.faces.add_face(corners);
      mesh.places.push_back(reader.line());
    } else if (keyword == "l") {
      curve = true;
    }
  }
  if (curve && mesh.faces.faces() == 0)
    reader.reject("the file holds a curve, with line elements and no faces; curves take schemes for curves");
}

}  // namespace subdiv
