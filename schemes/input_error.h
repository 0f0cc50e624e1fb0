#pragma once

#include <stdexcept>
#include <string>

namespace subdiv {

/// Input that a user can mend: the message names the place (file and line, option, or parameter), what is
/// wrong and what would be right. The program prints it and ends with exit code 2.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace subdiv
