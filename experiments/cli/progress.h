#pragma once

#include <cstddef>
#include <string>

namespace subdiv::cli {

/// A bar on standard error that counts finished experiments; silent unless standard error is a terminal. The
/// bar is taken away when the object ends.
class Progress {
 public:
  explicit Progress(std::size_t total);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  void finished(const std::string& name);

 private:
  void draw(const std::string& name) const;

  std::size_t total_;
  std::size_t done_ = 0;
  bool shown_;
};

}  // namespace subdiv::cli
