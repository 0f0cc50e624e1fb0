#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/certificates/prove.h"
#include "experiments/report/record.h"

namespace subdiv {

/// A statement as a file gives it, with the line at which it begins.
struct WrittenStatement {
  Statement statement;
  std::size_t line = 0;
};

/// Reads a file of statements: blocks "claim ID", each with lines of the head ("scheme ..", "data .."), of
/// the statement, and after a line "proof" witnesses of its own. "common NAME" begins a block whose lines
/// "use NAME" pastes. "# .." at the beginning of a line, inside a block, is a remark and stays; outside
/// blocks it is skipped. Throws InputError with file and line for lines outside blocks, unknown names, and
/// claims that stand there twice.
[[nodiscard]] std::vector<WrittenStatement> read_statements(const std::filesystem::path& path);

/// The statement with $exact, $lower and $upper replaced by the claim's value. Throws InputError when the
/// claim lacks what is asked for.
[[nodiscard]] Statement filled(Statement statement, const ClaimRecord& claim);

}  // namespace subdiv
