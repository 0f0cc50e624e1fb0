#include "experiments/cli/verbs.h"

int main(int argc, char** argv) { return subdiv::cli::run_command_line(argc, argv); }
