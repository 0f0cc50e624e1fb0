#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/verifier/statement.h"

namespace subdiv::verifier {

/// A certificate (experiments/certificates/README.md): the claim's id, the head (schemes and data), what is
/// stated, and the witnesses.
struct Certificate {
  std::string claim;
  std::vector<std::string> head;
  std::vector<std::string> statement;
  std::vector<std::string> proof;
};

/// The file's text, with the SHA-256 of claim, head and statement.
[[nodiscard]] std::string to_text(const Certificate& certificate);
/// Rejected when the text is no whole certificate or its digest is that of another statement.
[[nodiscard]] Certificate parse_certificate(const std::string& text);

/// "scheme S jspline:s=s = (s-1)/16*z^-3+..": the line of the head for a stationary scheme without roots,
/// InputError for others.
[[nodiscard]] std::string scheme_line(const std::string& name, const std::string& scheme);
/// "data D FILE.csv SHA-256" for a file of the data folder.
[[nodiscard]] std::string data_line(const std::string& name, const std::string& file,
                                    const std::filesystem::path& data);

/// What the head defines. Masks are compared with those that the program makes of the schemes' names, data
/// with their digests; Rejected when they differ.
[[nodiscard]] Context read_head(const std::vector<std::string>& head, const std::filesystem::path& data);
/// Checks the statement line by line against the proof and gives what it defines, the values of the claim
/// among it; Rejected with the line where it fails.
[[nodiscard]] Context check(const Certificate& certificate, const std::filesystem::path& data);

/// What is proved, as sentences, a line each.
[[nodiscard]] std::string in_words(const Certificate& certificate);

}  // namespace subdiv::verifier
