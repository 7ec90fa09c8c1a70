#include "context.h"

#include <fmt/format.h>

namespace rt::lua {

std::string location(lua_State* L) {
  lua_Debug frame;
  for (int level = 0; lua_getstack(L, level, &frame) != 0; ++level) {
    lua_getinfo(L, "Sl", &frame);
    if (frame.currentline > 0) {
      const char* file = frame.source[0] == '@' ? frame.source + 1 : frame.short_src;
      return file + (':' + std::to_string(frame.currentline));  // for every node that is made
    }
  }
  return {};
}

std::string at_location(lua_State* L, const std::string& otherwise, const std::string& text) {
  const std::string where = location(L);
  return fmt::format("{}: {}", where.empty() ? otherwise : where, text);
}

void warn_once(lua_State* L, const std::string& topic, const std::string& text) {
  Context& run = context(L);
  if (!run.said.insert(topic).second || !run.host.warn) {
    return;
  }
  const std::string where = location(L);
  run.host.warn(where.empty() || text.starts_with(where) ? text : where + ": " + text);
}

std::string memory_limit_text(const MemoryMeter& meter) {
  return fmt::format(
      "the script needs more memory than its limit of {} MB; --script-memory MB raises it, --trust "
      "lifts every limit",
      meter.limit() >> 20);
}

void charge(lua_State* L, Charge& charge, std::size_t bytes) {
  if (charge.grow(bytes)) {
    return;
  }
  const MemoryMeter& meter = *context(L).memory;
  if (bytes <= meter.limit()) {
    lua_gc(L, LUA_GCCOLLECT, 0);
    if (charge.grow(bytes)) {
      return;
    }
  }
  throw UserError(ExitCode::limit, memory_limit_text(meter));
}

}  // namespace rt::lua
