#pragma once
#include <memory>

#include "call.h"

namespace rt::lua {

/// A script's nodes know what they are charged for. There are no others in a script.
struct ChargedNode : Node {
  explicit ChargedNode(std::shared_ptr<MemoryMeter> meter) : charge(std::move(meter)) {}
  Charge charge;
};

/// A node without a shape, whose name is argument 1.
std::shared_ptr<Node> new_node(const Call& call);

/// Pushes such a node with a shape. Returns 1.
int push_new_node(const Call& call, std::shared_ptr<const Shape> shape);

/// A Lua function: a node without a shape that stands for what an unknown function would make.
int push_stand_in(lua_State* L);

/// Charges a node for one more child.
void charge_child(const Call& call, Node& parent);

}  // namespace rt::lua
