#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "experiments/mesh_formats.h"
#include "schemes/text.h"

namespace subdiv {
namespace {

/// The next line that says something, without its comment.
bool next_content(FileReader& reader, std::string_view& line) {
  while (reader.next_line(line)) {
    line = trimmed(without_comment(line));
    if (!line.empty()) return true;
  }
  return false;
}

/// The numbers of vertices, faces and edges; the last may be missing and is never right or wrong.
std::array<long long, 3> counts(FileReader& reader, std::string_view line) {
  std::array<long long, 3> result{};
  for (std::size_t i = 0; i < result.size(); ++i) {
    const std::string_view word = next_word(line);
    if (word.empty() && i == 2) break;
    if (word.empty()) reader.reject("expected the numbers of vertices, faces and edges");
    result[i] = to_integer(reader, word);
    if (result[i] < 0) reader.reject(in_quotes(word) + " is no number of elements");
  }
  if (!next_word(line).empty()) reader.reject("expected three numbers: of vertices, faces and edges");
  return result;
}

/// Reads the word OFF with what stands before it; says whether vertices carry more than coordinates.
bool carries_more(const FileReader& reader, std::string_view word) {
  constexpr std::string_view off = "OFF";
  if (!word.ends_with(off)) reader.reject("an .off file begins with the word OFF, not " + in_quotes(word));
  std::string_view before = word.substr(0, word.size() - off.size());
  const bool more = !before.empty();
  for (const std::string_view known : {"ST", "C", "N"}) {
    if (before.starts_with(known)) before.remove_prefix(known.size());
  }
  if (before.empty()) return more;
  reader.reject(in_quotes(word) + ": only vertices in space are read: OFF, COFF, NOFF, STOFF");
}

}  // namespace

void read_off(FileReader& reader, MeshFile& mesh) {
  std::string_view line;
  if (!next_content(reader, line)) reader.reject("an .off file begins with the word OFF; this one is empty");
  const bool more = carries_more(reader, next_word(line));
  if (trimmed(line).starts_with("BINARY"))
    reader.reject("binary .off files are not read; expected text, or a binary .ply file");
  if (trimmed(line).empty() && !next_content(reader, line))
    reader.reject("the file ends before the numbers of vertices, faces and edges");
  const auto [vertices, faces, edges] = counts(reader, line);

  const auto need = [&](const char* kind, long long read, long long claimed) {
    if (!next_content(reader, line))
      reader.reject(fmt::format("the file ends after {} of {} {}", read, claimed, kind));
  };
  constexpr std::size_t least_line = 6;  // "0 0 0" and its end: what a header may claim is not believed
  mesh.points.reserve(std::min(static_cast<std::size_t>(vertices), reader.left() / least_line));
  for (long long v = 0; v < vertices; ++v) {
    need("vertices", v, vertices);
    Point3 point{};
    for (double& coordinate : point) {
      const std::string_view word = next_word(line);
      if (word.empty()) reader.reject("a vertex has three coordinates: x y z");
      coordinate = to_coordinate(reader, word);
    }
    if (!more && !next_word(line).empty()) reader.reject("a vertex has three coordinates and no more: x y z");
    mesh.points.push_back(point);
  }
  std::vector<long long> corners;
  for (long long f = 0; f < faces; ++f) {
    need("faces", f, faces);
    const long long degree = to_integer(reader, next_word(line));
    if (degree < 0) reader.reject("a face begins with the number of its corners");
    corners.clear();
    for (long long i = 0; i < degree; ++i) {
      const std::string_view word = next_word(line);
      if (word.empty()) reader.reject(fmt::format("a face of {} corners lists {}", degree, i));
      corners.push_back(to_integer(reader, word));
    }
    constexpr int most_colours = 4;  // red, green, blue and opacity; or a number in a list of colours
    int colours = 0;
    for (std::string_view word = next_word(line); !word.empty(); word = next_word(line)) {
      (void)to_coordinate(reader, word);
      if (++colours > most_colours) reader.reject(fmt::format("more than {} corners and a colour", degree));
    }
    mesh.faces.add_face(corners);
    mesh.places.push_back(reader.line());
  }
  if (next_content(reader, line))
    reader.reject(fmt::format("more lines than the {} vertices and {} faces of the header", vertices, faces));
}

}  // namespace subdiv
