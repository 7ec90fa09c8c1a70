/// The methods of nodes.
#include "call.h"
#include "functions.h"
#include "nodes.h"

namespace rt::lua {
namespace {

/// Three numbers, or one table of three.
Vec3 vector_argument(Call& call) {
  if (call.argument(1).type() == LUA_TTABLE) {
    call.takes_at_most(1);
    return call.argument(1).triple();
  }
  return {call.argument(1, "x").number(), call.argument(2, "y").number(),
          call.argument(3, "z").number()};
}

}  // namespace

int node_add_child(Call& call) {
  auto child = call.argument(1, "child").object<Node>();
  charge_child(call, *call.self());
  rt::add_child(*call.self(), std::move(child));
  return call.return_self();
}

int node_set_material(Call& call) {
  call.self()->material = call.argument(1).object<const Material>();
  call.run().unused_materials.erase(call.self()->material.get());
  return call.return_self();
}

int node_translate(Call& call) {
  rt::translate(*call.self(), vector_argument(call), call.run().settings.order);
  return call.return_self();
}

int node_rotate(Call& call) {
  const int axis = call.argument(1, "axis").axis("an axis 'x', 'y' or 'z'");
  rt::rotate(*call.self(), axis, call.argument(2, "degrees").number(), call.run().settings.order);
  return call.return_self();
}

int node_scale(Call& call) {
  const bool uniform = call.argument(1).type() == LUA_TNUMBER && !call.argument(2).given() &&
                       !call.argument(3).given();
  rt::scale(*call.self(), uniform ? Vec3(call.argument(1).number()) : vector_argument(call),
            call.run().settings.order);
  return call.return_self();
}

}  // namespace rt::lua
