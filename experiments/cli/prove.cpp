#include <filesystem>
#include <iostream>

#include <fmt/format.h>

#include "experiments/certificates/statement_file.h"
#include "experiments/cli/verbs.h"
#include "experiments/data.h"
#include "experiments/report/files.h"
#include "experiments/report/folder.h"
#include "schemes/input_error.h"

namespace subdiv::cli {

int prove(const ProveOptions& options) {
  const auto results = load_results_if_any(options.claims);
  const std::filesystem::path folder = options.out;
  const std::filesystem::path data = data_folder();
  std::vector<NewFile> files;
  int failed = 0;
  for (const std::string& file : options.files) {
    for (const WrittenStatement& written : read_statements(file)) {
      const std::string& id = written.statement.claim;
      if (!is_file_name(id))
        throw InputError(fmt::format("{}:{}: {} is no file name", file, written.line, id));
      try {
        Statement statement = written.statement;
        if (results) {
          for (const ClaimRecord& record : results->claims) {
            if (record.id == id) statement = filled(std::move(statement), record);
          }
        }
        files.push_back({folder / (id + ".txt"), verifier::to_text(subdiv::prove(statement, data))});
        std::cout << id << ": proved\n";
      } catch (const std::exception& error) {
        ++failed;
        std::cerr << "subdivlab: " << file << ":" << written.line << ": " << id << ": " << error.what()
                  << "\n";
      }
    }
  }
  prepare_folder(folder);
  write_files(files);
  return failed > 0 ? ExitCode::differs : ExitCode::done;
}

}  // namespace subdiv::cli
