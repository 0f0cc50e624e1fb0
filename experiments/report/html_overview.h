#pragma once

#include <span>
#include <string>

#include "experiments/report/html_claim.h"
#include "experiments/report/html_documents.h"

namespace subdiv {

/// The id of a document's section on the report's pages: its key, with '-' for what ids and addresses may not
/// hold.
[[nodiscard]] std::string document_anchor(const Document& document);

/// Links to the sections of the documents.
[[nodiscard]] std::string html_contents(std::span<const Document> documents);

/// The form that chooses claims, hidden until the script shows it: words, verdicts, sharpened, with
/// certificate, rigour, document, and the count of the claims shown. The names of its fields are those in the
/// address and in the data attributes of html_claim().
[[nodiscard]] std::string html_filters(const ReportSource& source, std::span<const Document> documents);

/// A table of verdicts by documents, each number a link to its claims, and what the words mean.
[[nodiscard]] std::string html_overview(const ReportSource& source, std::span<const Document> documents);

}  // namespace subdiv
