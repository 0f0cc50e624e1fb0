#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "experiments/report/json.h"

namespace subdiv {

/// Where the figures of a manifest stand on the page: each beside the first claim, in the order of `claims`,
/// that it names; other claims that it names link to it; figures that name no claim of the page go to their
/// experiment.
struct FigurePlaces {
  std::map<std::string, std::vector<const FileEntry*>> beside;         // by claim
  std::map<std::string, std::vector<const FileEntry*>> mentioned;      // by claim
  std::map<std::string, std::vector<const FileEntry*>> of_experiment;  // by experiment
};
[[nodiscard]] FigurePlaces place_figures(std::span<const FileEntry> figures,
                                         std::span<const ClaimRecord> claims);

/// The id of a figure on the page.
[[nodiscard]] std::string figure_anchor(const FileEntry& figure);

/// A figure with its caption; without a picture, a sentence that says so.
[[nodiscard]] std::string html_figure(const FileEntry& figure, const std::string& svg);

}  // namespace subdiv
