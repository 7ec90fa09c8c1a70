#include "guarded.h"

#include <new>
#include <string>

#include "context.h"

namespace rt::lua {

void push_error(lua_State* L, const std::exception& error) {
  Context& run = context(L);
  ExitCode code = ExitCode::scene;
  std::string text = error.what();
  if (const auto* user = dynamic_cast<const UserError*>(&error)) {
    code = user->code();
  } else if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) {
    code = ExitCode::limit;
    text = "not enough memory";
  } else {
    text = "internal error: " + text;
  }
  const std::string where = location(L);
  if (!where.empty() && !text.starts_with(where + ":")) {
    text = where + ": " + text;
  }
  if (code != ExitCode::scene) {
    constexpr std::size_t remembered = 32;
    run.coded_errors.push_back({text, code});
    if (run.coded_errors.size() > remembered) {
      run.coded_errors.pop_front();
    }
  }
  if (code == ExitCode::interrupted) {
    run.guard.stop(L, code, text);
  }
  lua_pushlstring(L, text.data(), text.size());
}

}  // namespace rt::lua
