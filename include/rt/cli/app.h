#pragma once
#include "rt/cli/command_line.h"

namespace rt::cli {

/// Runs the script and renders the pictures it asks for. Throws UserError.
void run(const CommandLine& line);

/// The whole program: reports errors on standard error and returns the exit code.
int main_program(int argc, const char* const* argv);

}  // namespace rt::cli
