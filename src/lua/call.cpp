#include "call.h"

#include <fmt/format.h>

#include "describe.h"
#include "handle.h"

namespace rt::lua {

namespace {

const Binding& called_binding(lua_State* L) {
  return *static_cast<const Binding*>(lua_touserdata(L, lua_upvalueindex(binding_upvalue)));
}

bool is_gr_table(lua_State* L, int index) {
  if (!lua_istable(L, index)) {
    return false;
  }
  lua_rawgetp(L, LUA_REGISTRYINDEX, &gr_table_key);
  const bool same = lua_rawequal(L, index, -1) != 0;
  lua_pop(L, 1);
  return same;
}

}  // namespace

Call::Call(lua_State* state)
    : L(state), binding(called_binding(state)), count_(lua_gettop(state)), most_(binding.most) {
  if (binding.is_method()) {
    self_ = handle<Node>(L, 1);
    if (self_ == nullptr) {
      fail(fmt::format("expected a node before the colon, got {}; write a colon, not a dot: {}",
                       describe(L, 1), binding.example));
    }
    first_ = 2;
    --count_;
  } else if (is_gr_table(L, 1)) {
    fail(fmt::format("called with a colon; write a dot: {}", binding.example));
  }
}

Value Call::argument(int n, std::string_view name) const {
  return {*this, n <= count_ ? first_ + n - 1 : 0, n, name};
}

std::string Call::title() const {
  return self_ != nullptr ? fmt::format("{} of '{}'", binding.title, shortened((*self_)->name))
                          : std::string(binding.title);
}

void Call::fail(std::string_view text) const {
  throw SceneError(fmt::format("{}: {}", title(), text));
}

void Call::warn_of_ignored() const {
  if (count_ <= most_ && ignored_.empty()) {
    return;
  }
  std::vector<int> ignored = ignored_;
  for (int n = most_ + 1; n <= count_; ++n) {
    if (argument(n).given()) {
      ignored.push_back(n);
    }
  }
  if (ignored.empty()) {
    return;
  }
  std::string text;
  for (const int n : ignored) {
    text +=
        fmt::format("{}argument {}, {}", text.empty() ? "" : "; ", n, describe(L, first_ + n - 1));
  }
  warn_once(L, fmt::format("ignored arguments of {}", binding.title),
            fmt::format("{}: ignored {}. It takes {}", title(), text, binding.signature));
}

int Call::return_self() {
  lua_settop(L, first_ + count_ - 1);
  lua_pushvalue(L, 1);
  return 1;
}

}  // namespace rt::lua
