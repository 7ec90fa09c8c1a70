/// gr.checker.
#include "call.h"
#include "functions.h"
#include "handle.h"

namespace rt::lua {

int make_checker(Call& call) {
  Checker checker;
  checker.even = call.argument(1, "even").colour();
  checker.odd = call.argument(2, "odd").colour();
  if (call.argument(3).given()) {
    checker.size = call.argument(3, "size").number(positive);
  }
  push<const Texture>(call.L, make_charged(call.L, Texture(checker)));
  return 1;
}

}  // namespace rt::lua
