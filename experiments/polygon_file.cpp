#include "experiments/polygon_file.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fstream>
#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "experiments/report/files.h"
#include "schemes/algebra/rational.h"
#include "schemes/input_error.h"
#include "schemes/mesh/mesh_catalogue.h"
#include "schemes/text.h"

namespace subdiv {
namespace {

namespace fs = std::filesystem;

/// What is wrong with a number; the reader adds the place.
struct NumberError {
  std::string what;
};

template <class T>
T parse_number(std::string_view text);

template <>
Rational parse_number<Rational>(std::string_view text) {
  try {
    return Rational::parse(text);
  } catch (const std::exception& error) {  // not a number, or a division by zero
    throw NumberError{error.what()};
  }
}

template <>
double parse_number<double>(std::string_view text) {
  if (text.find('/') != std::string_view::npos) return parse_number<Rational>(text).to_double();
  const std::string_view digits = text.starts_with('+') ? text.substr(1) : text;
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error == std::errc::result_out_of_range) throw NumberError{in_quotes(text) + " does not fit a double"};
  if (error != std::errc() || end != digits.data() + digits.size() || digits.starts_with('+'))
    throw NumberError{in_quotes(text) + " is no number"};
  if (!std::isfinite(value)) throw NumberError{in_quotes(text) + " is not finite"};
  return value;
}

[[noreturn]] void reject(const fs::path& path, std::size_t line, const std::string& what) {
  throw InputError(path.string() + ":" + std::to_string(line) + ": " + what);
}

/// Calls visit(line number, text) for every line that is neither blank nor a comment.
void for_each_line(const fs::path& path, const std::function<void(std::size_t, std::string_view)>& visit) {
  std::error_code error;
  if (!fs::exists(path, error) || fs::is_directory(path, error)) (void)read_file(path);  // says why it fails
  if (!fs::is_regular_file(path, error))
    throw InputError(path.string() + ": is no regular file; points are read from files on disk");
  std::ifstream stream(path, std::ios::binary);
  if (!stream) (void)read_file(path);
  std::string line;
  for (std::size_t number = 1; std::getline(stream, line); ++number) {
    constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
    std::string_view text = line;
    if (number == 1 && text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
    text = trimmed(text);
    if (!text.empty() && text.front() != '#') visit(number, text);
  }
  if (stream.bad()) throw InputError(path.string() + ": cannot be read to its end");
}

void split(std::string_view text, char separator, std::vector<std::string_view>& fields) {
  fields.clear();
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    const std::string_view field = trimmed(text.substr(begin, end - begin));
    if (separator != ' ' || !field.empty()) fields.push_back(field);
    begin = end + 1;
  }
}

/// Whether the first line names the columns: different names, each beginning with a letter, and no "nan" or
/// "inf", which is meant as a number.
bool is_header(const std::vector<std::string_view>& fields) {
  const auto is_name = [](std::string_view text) {
    double value = 0;
    return !text.empty() && std::isalpha(static_cast<unsigned char>(text.front())) != 0 &&
           std::from_chars(text.data(), text.data() + text.size(), value).ec == std::errc::invalid_argument;
  };
  const std::set<std::string_view> different(fields.begin(), fields.end());
  return different.size() == fields.size() && std::all_of(fields.begin(), fields.end(), is_name);
}

template <class T>
PointList<T> read_csv(const fs::path& path) {
  PointList<T> list;
  bool first = true;
  std::vector<std::string_view> fields;
  for_each_line(path, [&](std::size_t line, std::string_view text) {
    split(text, ',', fields);
    const bool header = first && is_header(fields);
    if (first) list.coordinates.resize(fields.size());
    first = false;
    if (fields.size() != list.dimension()) {
      reject(path, line,
             "a point of " + std::to_string(fields.size()) + " coordinates where the lines above have " +
                 std::to_string(list.dimension()) + "; every line holds a point as x,y or x,y,z");
    }
    if (header) list.header.assign(fields.begin(), fields.end());
    if (header) return;
    for (std::size_t c = 0; c < fields.size(); ++c) {
      try {
        list.coordinates[c].push_back(parse_number<T>(fields[c]));
      } catch (const NumberError& error) {
        reject(path, line,
               "coordinate " + std::to_string(c + 1) + ": " + error.what +
                   "; expected an integer, a decimal or p/q");
      }
    }
  });
  return list;
}

/// The order in which the line element "l 1 2 -1" visits the vertices, 0-based; relative indices count from
/// the last vertex read.
std::vector<std::size_t> line_order(const fs::path& path, std::size_t line,
                                    const std::vector<std::string_view>& words, std::size_t vertices) {
  std::vector<std::size_t> order;
  for (std::size_t i = 1; i < words.size(); ++i) {
    const std::string_view text = words[i].substr(0, words[i].find('/'));  // v or v/vt
    long index = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), index);
    const auto count = static_cast<long>(vertices);
    if (index < 0) index += count + 1;
    if (error != std::errc() || end != text.data() + text.size() || index < 1 || index > count) {
      reject(path, line,
             in_quotes(words[i]) + " names no vertex: there are " + std::to_string(vertices) +
                 " above this line, counted from 1");
    }
    order.push_back(static_cast<std::size_t>(index - 1));
  }
  return order;
}

template <class T>
PointList<T> read_obj(const fs::path& path) {
  constexpr std::size_t dimension = 3;
  PointList<T> list{std::vector<std::vector<T>>(dimension), {}, std::nullopt};
  std::vector<std::size_t> order;
  std::vector<std::string_view> words;
  for_each_line(path, [&](std::size_t line, std::string_view text) {
    split(text, ' ', words);
    if (words.front() == "v") {
      if (words.size() != dimension + 1) reject(path, line, "a vertex has three coordinates: v x y z");
      for (std::size_t c = 0; c < dimension; ++c) {
        try {
          list.coordinates[c].push_back(parse_number<T>(words[c + 1]));
        } catch (const NumberError& error) {
          reject(path, line, "coordinate " + std::to_string(c + 1) + ": " + error.what);
        }
      }
    } else if (words.front() == "l") {
      if (!order.empty()) reject(path, line, "a second line element; the file may hold one curve");
      order = line_order(path, line, words, list.size());
      if (order.size() < 2) reject(path, line, "a line element visits at least two vertices");
    } else if (words.front() == "f") {
      reject(path, line,
             "a face; expected a polygon or a grid, given by its vertices alone; meshes take " +
                 joined(mesh_scheme_names()));
    }
  });
  if (order.empty()) return list;
  list.closed = order.front() == order.back();
  if (*list.closed) order.pop_back();
  for (std::vector<T>& coordinate : list.coordinates) {
    std::vector<T> visited;
    visited.reserve(order.size());
    for (const std::size_t i : order) visited.push_back(coordinate[i]);
    coordinate = std::move(visited);
  }
  return list;
}

}  // namespace

template <class T>
PointList<T> read_points(const fs::path& path) {
  const std::string extension = path.extension().string();
  if (extension != ".csv" && extension != ".obj")
    throw InputError(path.string() + ": points are read from .csv or .obj files");
  PointList<T> list = extension == ".csv" ? read_csv<T>(path) : read_obj<T>(path);
  if (list.size() == 0) {
    throw InputError(path.string() + ": no points; expected " +
                     (extension == ".csv" ? "a line x,y or x,y,z for each" : "a line v x y z for each"));
  }
  return list;
}

template PointList<double> read_points<double>(const fs::path&);
template PointList<Rational> read_points<Rational>(const fs::path&);

}  // namespace subdiv
