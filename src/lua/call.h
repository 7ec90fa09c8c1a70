#pragma once
/// A call from the script, and the values it gives.
#include <lua.hpp>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "binding.h"
#include "context.h"
#include "rt/scene/node.h"
#include "value.h"

namespace rt::lua {

/// One call of a binding. Arguments count from 1; the node before a method's colon is not one.
class Call {
 public:
  /// Throws SceneError when a method is called without its node (`node.translate(1, 2, 3)`) or a
  /// function with a colon (`gr:sphere("ball")`).
  explicit Call(lua_State* state);

  lua_State* L;
  const Binding& binding;

  /// The node before the colon. Methods only.
  const std::shared_ptr<Node>& self() const { return *self_; }
  Context& run() const { return context(L); }

  /// Argument n, with a name for messages; it may be absent.
  Value argument(int n, std::string_view name = {}) const;
  /// How many were given.
  int count() const { return count_; }

  /// "gr.sphere", or "node:translate of 'ball'": how messages begin.
  std::string title() const;
  /// Throws SceneError: the title and the text.
  [[noreturn]] void fail(std::string_view text) const;

  /// This form of the call takes fewer arguments than the binding at most does.
  void takes_at_most(int n) { most_ = n; }
  /// Argument n is given but not understood.
  void ignore(int n) { ignored_.push_back(n); }
  /// One warning for each function that was given arguments it does not understand.
  void warn_of_ignored() const;

  /// What methods return: their node, so that calls can be chained.
  int return_self();

 private:
  int first_ = 1;  ///< stack index of argument 1
  int count_ = 0;
  int most_ = 0;
  std::vector<int> ignored_;
  const std::shared_ptr<Node>* self_ = nullptr;  ///< of the value at stack index 1, which stays
};

}  // namespace rt::lua
