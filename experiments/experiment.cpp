#include "experiments/experiment.h"

#include <algorithm>
#include <stdexcept>

namespace subdiv {

const ClaimHead& head(std::span<const ClaimHead> heads, const std::string& id) {
  const auto found = std::find_if(heads.begin(), heads.end(), [&](const ClaimHead& h) { return h.id == id; });
  if (found == heads.end()) throw std::logic_error("no claim '" + id + "' in the table");
  return *found;
}

}  // namespace subdiv
