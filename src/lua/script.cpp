#include "rt/lua/script.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <lua.hpp>

#include "binding.h"
#include "compat.h"
#include "context.h"
#include "excerpt.h"
#include "files.h"
#include "libraries.h"
#include "lua_memory.h"
#include "memory.h"

namespace rt::lua {
namespace {

/// What the protected call below needs.
struct Program {
  std::string source;
  std::string name;
  const std::vector<std::string>& args;
};

void note_refusal(Context& run) {
  run.refused = true;
  if (lua_State* L = run.guard.running()) {
    run.refused_at = location(L);
  }
}

/// A Lua state that is closed when it goes out of scope, while its context still stands.
class State {
 public:
  explicit State(Context& run)
      : memory_(*run.memory, [&run] { note_refusal(run); }),
        L(lua_newstate(LuaMemory::allocate, &memory_)) {
    if (L == nullptr) {
      throw UserError(ExitCode::limit, "there is not enough memory to start Lua");
    }
    context_slot(L) = &run;
  }
  ~State() { lua_close(L); }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

 private:
  LuaMemory memory_;

 public:
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
  const Context& run = context(L);
  if (run.settings.trust) {
    open_all_libraries(L);
  } else {
    open_libraries(L);
  }
  open_compat(L);
  open_bindings(L);
  set_arg(L, program);
  if (run.settings.frame) {
    lua_pushinteger(L, *run.settings.frame);
    lua_setglobal(L, "frame");
  }
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
  if (context(L).settings.verbose) {
    luaL_traceback(L, L, nullptr, 1);
    context(L).traceback = lua_tostring(L, -1);
    lua_pop(L, 1);
  }
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

/// How the script ended: an exit code and a message.
struct End {
  ExitCode code;
  std::string message;
};

End end_of(lua_State* L, int status, const Context& run) {
  if (run.guard.stopped()) {
    return {run.guard.stopped()->code(), run.guard.stopped()->what()};
  }
  std::size_t size = 0;
  const char* data = lua_tolstring(L, -1, &size);
  std::string message = data == nullptr ? "unknown error" : std::string(data, size);
  const bool about_memory = message.find("not enough memory") != message.npos;
  if (status == LUA_ERRMEM || (run.refused && about_memory)) {
    const std::string& where = run.refused_at.empty() ? run.script : run.refused_at;
    return {ExitCode::limit, fmt::format("{}: {}", where, memory_limit_text(*run.memory))};
  }
  for (const auto& coded : run.coded_errors) {
    if (message.find(coded.message) != message.npos) {
      return {coded.code, std::move(message)};
    }
  }
  return {ExitCode::scene, std::move(message)};
}

[[noreturn]] void throw_end(const End& end, const Context& run) {
  const std::string message = with_full_names(end.message, run.sources);
  std::string report = with_excerpt(message, run.sources);
  if (!run.traceback.empty()) {
    report = fmt::format("{}\n{}", report.empty() ? message : report,
                         with_full_names(run.traceback, run.sources));
  }
  switch (end.code) {
    case ExitCode::scene:
      throw SceneError(message, report);
    case ExitCode::file:
      throw FileError(message, report);
    default:
      throw UserError(end.code, message, report);
  }
}

void warn_of_unused_materials(const Context& run) {
  if (!run.rendered || run.unused_materials.empty() || !run.host.warn) {
    return;
  }
  std::vector<std::string> places;
  for (const auto& [material, where] : run.unused_materials) {
    places.push_back(where);
  }
  std::ranges::sort(places);
  run.host.warn(
      fmt::format("{}: the material made here is set on no node{}", places.front(),
                  places.size() > 1 ? fmt::format(" (nor are {} more)", places.size() - 1) : ""));
}

}  // namespace

void run_script(const std::filesystem::path& path, const std::vector<std::string>& args,
                const Host& host, const Settings& settings) {
  if (host.reads) {
    host.reads(path);
  }
  Program program{read_file(path, path.string()), path.string(), args};
  Guard guard(settings.limits, settings.trust, program.name);
  const std::size_t memory =
      settings.trust ? std::numeric_limits<std::size_t>::max() : settings.limits.memory;
  Context run{.host = host,
              .settings = settings,
              .guard = guard,
              .memory = std::make_shared<MemoryMeter>(memory),
              .script = program.name,
              .module_folders = module_folders(path, settings),
              .mesh_folders = mesh_folders(path, settings),
              .texture_folders = texture_folders(path, settings)};
  run.sources.emplace(program.name, path);
  const State state(run);
  lua_pushcfunction(state.L, error_text);
  lua_pushcfunction(state.L, run_program);
  lua_pushlightuserdata(state.L, &program);
  guard.begin(state.L);
  const int status = lua_pcall(state.L, 1, 0, 1);
  guard.end();
  if (status != LUA_OK || guard.stopped()) {
    throw_end(end_of(state.L, status, run), run);
  }
  warn_of_unused_materials(run);
}

}  // namespace rt::lua
