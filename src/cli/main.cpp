#include "rt/cli/app.h"
#include "rt/io/image.h"

int main(int argc, char** argv) {
  const int code = rt::cli::main_program(argc, argv);
  rt::io::end_preload();
  return code;
}
