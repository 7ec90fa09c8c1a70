#include "context.h"

#include <fmt/format.h>

#include <cstring>

namespace rt::lua {

namespace {

/// The name of the file that is run, cut short where it is no file's: load() takes a name of any
/// length.
const char* shown_name(const lua_Debug& frame) {
  constexpr std::size_t longest = 1024;
  const bool whole = frame.source[0] == '@' && strnlen(frame.source, longest) < longest;
  return whole ? frame.source + 1 : frame.short_src;
}

/// Calls found(file, line) about the line being run, if there is one.
template <class Found>
void find_line(lua_State* L, Found found) {
  lua_Debug frame;
  for (int level = 0; lua_getstack(L, level, &frame) != 0; ++level) {
    lua_getinfo(L, "Sl", &frame);
    if (frame.currentline > 0) {
      found(shown_name(frame), frame.currentline);
      return;
    }
  }
}

}  // namespace

std::string location(lua_State* L) {
  std::string text;
  find_line(L, [&](const char* file, int line) { text = fmt::format("{}:{}", file, line); });
  return text;
}

std::shared_ptr<const std::string> shared_location(lua_State* L) {
  std::shared_ptr<const std::string> text;
  find_line(L, [&](const char* file, int line) {
    Context::Place& last = context(L).last_place;
    if (line != last.line || file != last.file) {
      std::string where = fmt::format("{}:{}", file, line);
      const std::size_t bytes = where.size();
      last = {file, line, make_charged(L, std::move(where), bytes)};
    }
    text = last.text;
  });
  return text;
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
