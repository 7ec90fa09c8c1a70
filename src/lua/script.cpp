#include "rt/lua/script.h"

#include <fmt/format.h>

#include <lua.hpp>

#include "binding.h"
#include "context.h"
#include "files.h"
#include "libraries.h"
#include "memory.h"

namespace rt::lua {
namespace {

/// What the protected call below needs.
struct Program {
  std::string source;
  std::string name;
  const std::vector<std::string>& args;
};

/// A Lua state that is closed when it goes out of scope, while its context still stands.
class State {
 public:
  State(Context& run, MemoryMeter& meter) : L(lua_newstate(MemoryMeter::allocate, &meter)) {
    if (L == nullptr) {
      throw UserError(ExitCode::limit, "there is not enough memory to start Lua");
    }
    context_slot(L) = &run;
  }
  ~State() { lua_close(L); }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  lua_State* const L;
};

void set_arg(lua_State* L, const Program& program) {
  lua_newtable(L);
  lua_pushstring(L, program.name.c_str());
  lua_rawseti(L, -2, 0);
  lua_Integer n = 0;
  for (const std::string& argument : program.args) {
    lua_pushlstring(L, argument.data(), argument.size());
    lua_rawseti(L, -2, ++n);
  }
  lua_setglobal(L, "arg");
}

/// Sets everything up and runs the script; called protected, for even this can lack memory.
int run_program(lua_State* L) {
  const auto& program = *static_cast<const Program*>(lua_touserdata(L, 1));
  open_libraries(L);
  open_bindings(L);
  set_arg(L, program);
  if (load_text(L, program.source, program.name) != LUA_OK) {
    return lua_error(L);
  }
  luaL_checkstack(L, static_cast<int>(program.args.size()), "too many arguments");
  for (const std::string& argument : program.args) {
    lua_pushlstring(L, argument.data(), argument.size());
  }
  lua_call(L, static_cast<int>(program.args.size()), 0);
  return 0;
}

/// Message handler: a text of whatever was raised.
int error_text(lua_State* L) {
  if (lua_type(L, 1) == LUA_TSTRING) {
    return 1;
  }
  if (luaL_callmeta(L, 1, "__tostring") != 0 && lua_type(L, -1) == LUA_TSTRING) {
    return 1;
  }
  const std::string where = location(L);
  lua_pushfstring(L, "%s%sthe script raised an error that is a %s, not a text", where.c_str(),
                  where.empty() ? "" : ": ", luaL_typename(L, 1));
  return 1;
}

[[noreturn]] void throw_memory_error(const Context& run, const MemoryMeter& meter) {
  throw UserError(ExitCode::limit,
                  fmt::format("{}: the script needs more memory than its limit of {} MB",
                              run.script, meter.limit >> 20));
}

/// Throws what the script ended with.
[[noreturn]] void throw_error(lua_State* L, int status, const Context& run,
                              const MemoryMeter& meter) {
  std::size_t size = 0;
  const char* data = lua_tolstring(L, -1, &size);
  const std::string message = data == nullptr ? "unknown error" : std::string(data, size);
  if (status == LUA_ERRMEM ||
      (meter.refused && message.find("not enough memory") != std::string::npos)) {
    throw_memory_error(run, meter);
  }
  if (!run.coded_message.empty() && message.find(run.coded_message) != std::string::npos) {
    throw UserError(run.coded_code, message);
  }
  throw SceneError(message);
}

}  // namespace

void run_script(const std::filesystem::path& path, const std::vector<std::string>& args,
                const Host& host, const Limits& limits) {
  Program program{read_file(path, path.string()), path.string(), args};
  Context run{.host = host,
              .script = program.name,
              .script_folder = folder(path.parent_path()),
              .working_folder = folder({}),
              .loading = {},
              .meshes = {},
              .said = {},
              .coded_message = {}};
  MemoryMeter meter{.limit = limits.memory};
  const State state(run, meter);
  lua_pushcfunction(state.L, error_text);
  lua_pushcfunction(state.L, run_program);
  lua_pushlightuserdata(state.L, &program);
  const int status = lua_pcall(state.L, 1, 0, 1);
  if (status != LUA_OK) {
    throw_error(state.L, status, run, meter);
  }
}

}  // namespace rt::lua
