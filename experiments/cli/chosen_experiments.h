#pragma once

#include <string>
#include <vector>

#include "experiments/experiment.h"

namespace subdiv::cli {

/// The built-in experiments, or those of a file of one's own claims where one is named.
[[nodiscard]] std::vector<Experiment> chosen_experiments(const std::string& claims_file);

/// The results folder of a run: the one given, else "results". With a file of one's own claims it must be
/// given, by the named option, and may not hold claims that are not in the file: InputError.
[[nodiscard]] std::string chosen_folder(const std::string& given, const std::string& claims_file,
                                        const std::string& option);
void require_own_folder(const std::string& folder, const std::string& claims_file,
                        const std::vector<Experiment>& own);

}  // namespace subdiv::cli
