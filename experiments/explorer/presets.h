#pragma once

#include <string>
#include <vector>

namespace subdiv::explorer {

/// A curve of the documents: its steps as exact texts, {s} or {a, b}, the last of which repeats.
struct Preset {
  std::string group;
  std::string name;
  std::vector<std::vector<std::string>> steps;
  std::vector<std::string> claims;  // ids
  std::string note;                 // what it is for
  bool retrofit = false;
};

[[nodiscard]] const std::vector<Preset>& presets();

/// A polygon of experiments/data, by the name of its file without .csv.
struct StoredPolygon {
  std::string name;
  std::string title;
  bool open = false;
};

[[nodiscard]] const std::vector<StoredPolygon>& stored_polygons();

}  // namespace subdiv::explorer
