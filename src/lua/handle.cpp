#include "handle.h"

#include <vector>

namespace rt::lua {

void release(std::shared_ptr<Node> node) {
  std::vector<std::shared_ptr<Node>> going;
  going.push_back(std::move(node));
  while (!going.empty()) {
    const std::shared_ptr<Node> last = std::move(going.back());
    going.pop_back();
    if (last.use_count() == 1) {
      for (auto& child : last->children) {
        going.push_back(std::move(child));
      }
      last->children.clear();
    }
  }
}

}  // namespace rt::lua
