#include "experiments/explorer/assets.h"

// The assembler puts the files into the program as they are: no compiler reads half a megabyte of literals.
// SUBDIVLAB_EXPLORER_FOLDER is this folder.
__asm__(
    ".pushsection .rodata\n"
    ".global subdivlab_explorer_core\n.global subdivlab_explorer_core_end\n"
    "subdivlab_explorer_core:\n.incbin \"" SUBDIVLAB_EXPLORER_FOLDER
    "/explorer_core.js\"\nsubdivlab_explorer_core_end:\n"
    ".global subdivlab_explorer_script\n.global subdivlab_explorer_script_end\n"
    "subdivlab_explorer_script:\n.incbin \"" SUBDIVLAB_EXPLORER_FOLDER
    "/page.js\"\nsubdivlab_explorer_script_end:\n"
    ".global subdivlab_explorer_style\n.global subdivlab_explorer_style_end\n"
    "subdivlab_explorer_style:\n.incbin \"" SUBDIVLAB_EXPLORER_FOLDER
    "/page.css\"\nsubdivlab_explorer_style_end:\n"
    ".global subdivlab_explorer_content\n.global subdivlab_explorer_content_end\n"
    "subdivlab_explorer_content:\n.incbin \"" SUBDIVLAB_EXPLORER_FOLDER
    "/page.html\"\nsubdivlab_explorer_content_end:\n"
    ".byte 0\n.popsection\n");

extern "C" {
extern const char subdivlab_explorer_core[];
extern const char subdivlab_explorer_core_end[];
extern const char subdivlab_explorer_script[];
extern const char subdivlab_explorer_script_end[];
extern const char subdivlab_explorer_style[];
extern const char subdivlab_explorer_style_end[];
extern const char subdivlab_explorer_content[];
extern const char subdivlab_explorer_content_end[];
}

namespace subdiv::explorer {
namespace {

std::string_view between(const char* begin, const char* end) {
  return {begin, static_cast<std::size_t>(end - begin)};
}

}  // namespace

std::string_view core_script() { return between(subdivlab_explorer_core, subdivlab_explorer_core_end); }
std::string_view page_script() { return between(subdivlab_explorer_script, subdivlab_explorer_script_end); }
std::string_view page_style() { return between(subdivlab_explorer_style, subdivlab_explorer_style_end); }
std::string_view page_content() {
  return between(subdivlab_explorer_content, subdivlab_explorer_content_end);
}

}  // namespace subdiv::explorer
