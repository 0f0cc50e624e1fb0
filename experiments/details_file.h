#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <vector>

namespace subdiv {

/// A detail as read: point `index` of level `level` is moved by `displacement`.
template <class T>
struct DetailRecord {
  int level = 0;
  long long index = 0;
  std::vector<T> displacement;
};

/// Reads the details of multi-resolution design, T = double or Rational: a .csv file with lines
/// level,index,dx,dy or with as many displacements as `dimension`, after an optional header. Throws
/// InputError as read_points does, and for levels and indices that are no whole numbers from 0 on.
template <class T>
[[nodiscard]] std::vector<DetailRecord<T>> read_details(const std::filesystem::path& path,
                                                        std::size_t dimension);

}  // namespace subdiv
