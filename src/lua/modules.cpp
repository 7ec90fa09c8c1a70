/// `require` and `dofile`: source text from the script's folder, nothing else.
#include <fmt/format.h>

#include <algorithm>

#include "files.h"
#include "functions.h"

namespace rt::lua {
namespace {

/// Address under which the registry holds the results of modules by their real path.
constexpr char modules_key = 0;

FoundFile find_module(const Call& call, const std::string& name) {
  return find_file(call, name, call.run().module_folders);
}

void load(lua_State* L, const FoundFile& file) {
  constexpr std::size_t most = 1000;
  if (context(L).sources.size() < most) {
    context(L).sources.emplace(file.shown, file.real);
  }
  if (const auto& reads = context(L).host.reads) {
    reads(file.real);
  }
  if (load_text(L, read_file(file.real, file.shown), file.shown) != LUA_OK) {
    lua_error(L);  // its message has file and line
  }
}

/// Pushes a library such as "string" if that is the module's name. Else pushes nothing.
bool push_library(lua_State* L, const std::string& name) {
  lua_getfield(L, LUA_REGISTRYINDEX, LUA_LOADED_TABLE);
  lua_pushlstring(L, name.data(), name.size());
  const bool found = lua_rawget(L, -2) != LUA_TNIL;
  lua_remove(L, -2);
  if (!found) {
    lua_pop(L, 1);
  }
  return found;
}

/// Pushes the table of modules that are loaded.
void push_modules(lua_State* L) {
  if (lua_rawgetp(L, LUA_REGISTRYINDEX, &modules_key) == LUA_TNIL) {
    lua_pop(L, 1);
    lua_newtable(L);
    lua_pushvalue(L, -1);
    lua_rawsetp(L, LUA_REGISTRYINDEX, &modules_key);
  }
}

/// Notes that a module is being loaded, for as long as this lives.
class Loading {
 public:
  Loading(const Call& call, const std::string& path) : names_(call.run().loading) {
    if (std::ranges::find(names_, path) != names_.end()) {
      call.fail(fmt::format("'{}' requires itself, directly or through other modules", path));
    }
    names_.push_back(path);
  }
  ~Loading() { names_.pop_back(); }
  Loading(const Loading&) = delete;
  Loading& operator=(const Loading&) = delete;

 private:
  std::vector<std::string>& names_;
};

}  // namespace

int require_module(Call& call) {
  lua_State* L = call.L;
  const std::string name = call.argument(1).text("a module's name (string)");
  if (push_library(L, name)) {
    return 1;
  }
  std::string path = name;
  std::ranges::replace(path, '.', '/');
  const FoundFile file = find_module(call, path + ".lua");
  const std::string key = file.real.string();

  push_modules(L);
  lua_pushlstring(L, key.data(), key.size());
  if (lua_rawget(L, -2) != LUA_TNIL) {
    return 1;
  }
  lua_pop(L, 1);

  const Loading loading(call, file.shown);
  load(L, file);
  lua_pushlstring(L, name.data(), name.size());
  lua_call(L, 1, 1);
  if (lua_isnil(L, -1)) {
    lua_pop(L, 1);
    if (!push_library(L, name)) {  // unless the file called module()
      lua_pushboolean(L, 1);
    }
  }
  lua_pushlstring(L, key.data(), key.size());
  lua_pushvalue(L, -2);
  lua_rawset(L, -4);
  return 1;
}

int run_file(Call& call) {
  lua_State* L = call.L;
  const std::string name = call.argument(1).text("a file name (string)");
  const FoundFile file = find_module(call, name);
  const int before = lua_gettop(L);
  load(L, file);
  lua_call(L, 0, LUA_MULTRET);
  return lua_gettop(L) - before;
}

}  // namespace rt::lua
