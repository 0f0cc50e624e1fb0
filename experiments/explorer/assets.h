#pragma once

#include <string_view>

namespace subdiv::explorer {

/// The files of the page that stand beside this one, as they were when the program was built.
[[nodiscard]] std::string_view core_script();   // explorer_core.js
[[nodiscard]] std::string_view page_script();   // page.js
[[nodiscard]] std::string_view page_style();    // page.css
[[nodiscard]] std::string_view page_content();  // page.html

}  // namespace subdiv::explorer
