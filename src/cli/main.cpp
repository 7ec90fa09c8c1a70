#include "rt/cli/app.h"

int main(int argc, char** argv) { return rt::cli::main_program(argc, argv); }
