#include "rt/cli/app.h"

#include <exception>
#include <new>

#include "rt/cli/interrupt.h"
#include "rt/cli/say.h"
#include "rt/cli/session.h"
#include "rt/cli/starter.h"

namespace rt::cli {

void run(const CommandLine& line) { Session(line).run(); }

int main_program(int argc, const char* const* argv) {
  try {
    if (const auto line = parse_command_line(argc, argv)) {
      if (line->new_scene.empty()) {
        watch_signals();
        run(*line);
      } else {
        write_starter_scene(line->new_scene);
      }
    }
    return static_cast<int>(ExitCode::done);
  } catch (const UserError& error) {
    say((error.code() == ExitCode::interrupted ? "interrupted: " : "error: ") + error.report());
    return static_cast<int>(error.code());
  } catch (const std::bad_alloc&) {
    say("error: out of memory; make the scene or the picture smaller");
    return static_cast<int>(ExitCode::limit);
  } catch (const std::exception& error) {  // a defect of this program
    say(std::string("error: internal error: ") + error.what());
    return static_cast<int>(ExitCode::scene);
  }
}

}  // namespace rt::cli
