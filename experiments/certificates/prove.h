#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/verifier/certificate.h"

namespace subdiv {

/// A statement before it is proved. The head names schemes and data ("scheme S jspline:s=s", "data D
/// FILE.csv") without masks and digests; the proof may give witnesses of its own, all but covers.
struct Statement {
  std::string claim;
  std::vector<std::string> head;
  std::vector<std::string> lines;
  std::vector<std::string> proof;
};

/// Finds the witnesses that the statement needs, and checks every line by the verifier on the way. Covers are
/// found by halving, weights by exact linear programs, intervals of a minimum by trial, joint spectral radii
/// from below by eigenvectors of products; vertices of polytopes stand in the statement's proof or are grown
/// from eigenvectors. Throws verifier::Rejected with the line that cannot be proved.
[[nodiscard]] verifier::Certificate prove(const Statement& statement, const std::filesystem::path& data);

}  // namespace subdiv
