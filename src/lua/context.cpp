#include "context.h"

#include <fmt/format.h>

namespace rt::lua {

std::string location(lua_State* L) {
  lua_Debug frame;
  for (int level = 1; lua_getstack(L, level, &frame) != 0; ++level) {
    lua_getinfo(L, "Sl", &frame);
    if (frame.currentline > 0) {
      const char* file = frame.source[0] == '@' ? frame.source + 1 : frame.short_src;
      return fmt::format("{}:{}", file, frame.currentline);
    }
  }
  return {};
}

void warn_once(lua_State* L, const std::string& topic, const std::string& text) {
  Context& run = context(L);
  if (!run.said.insert(topic).second || !run.host.warn) {
    return;
  }
  const std::string where = location(L);
  run.host.warn(where.empty() || text.starts_with(where) ? text : where + ": " + text);
}

}  // namespace rt::lua
