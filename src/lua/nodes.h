#pragma once
#include <optional>

#include "call.h"

namespace rt::lua {

/// Pushes a new node whose name is argument 1. Returns 1.
int push_new_node(const Call& call, std::optional<Shape> shape);

}  // namespace rt::lua
