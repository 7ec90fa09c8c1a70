#include "nodes.h"

#include <algorithm>

namespace rt::lua {
namespace {

/// What a node takes: itself, the block that counts its shares, the allocator's own.
constexpr std::size_t bytes_of_node = sizeof(ChargedNode) + 48;

std::shared_ptr<Node> new_node(lua_State* L, std::string name) {
  auto node = std::make_shared<ChargedNode>(context(L).memory);
  node->name = std::move(name);
  node->where = shared_location(L);
  charge(L, node->charge, bytes_of_node + node->name.size());
  return node;
}

}  // namespace

std::shared_ptr<Node> new_node(const Call& call) {
  return new_node(call.L, call.argument(1).text("a name (string)"));
}

int push_new_node(const Call& call, std::shared_ptr<const Shape> shape) {
  auto node = new_node(call);
  node->shape = std::move(shape);
  push(call.L, std::move(node));
  return 1;
}

int push_stand_in(lua_State* L) {
  const bool named = lua_type(L, 1) == LUA_TSTRING;
  push(L, new_node(L, named ? lua_tostring(L, 1) : "stand-in"));
  return 1;
}

void charge_child(const Call& call, Node& parent) {
  if (parent.children.size() == parent.children.capacity()) {
    const std::size_t more = std::max<std::size_t>(1, parent.children.capacity());
    charge(call.L, static_cast<ChargedNode&>(parent).charge, more * sizeof(std::shared_ptr<Node>));
  }
}

}  // namespace rt::lua
