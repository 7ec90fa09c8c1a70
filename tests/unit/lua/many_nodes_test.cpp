/// What the nodes that a script makes in a loop take of memory.
#include <unistd.h>

#include <fstream>

#include "script_run.h"

namespace rt::lua {
namespace {

std::size_t resident_bytes() {
  std::size_t all = 0;
  std::size_t resident = 0;
  std::ifstream("/proc/self/statm") >> all >> resident;
  return resident * static_cast<std::size_t>(getpagesize());
}

using ManyNodes = ScriptTest;

TEST_F(ManyNodes, TakeFewBytesEachUntilTheyAreRendered) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers take memory of their own";
#endif
  constexpr std::size_t nodes = 100'000;
  const std::size_t before = resident_bytes();
  std::size_t after = 0;
  std::size_t shapes = 0;
  host_.render = [&](const RenderJob& job) {
    after = resident_bytes();
    shapes = job.instances.size();
  };
  run("local root, m = gr.node('root'), gr.material({0.7, 0.3, 0.2}, {0.2, 0.2, 0.2}, 20)\n"
      "for i = 1, " +
      std::to_string(nodes) +
      " do\n"
      "  root:add_child(gr.sphere('s'):set_material(m):scale(0.4, 0.4, 0.4):translate(i, 0, 0))\n"
      "end\n"
      "gr.render(root, 'a.png', 4, 3, {0,0,9}, {0,0,-1}, {0,1,0}, 50, {0,0,0}, {})");
  EXPECT_EQ(shapes, nodes);
  // The node itself, the script's handle of it, and the snapshot.
  const std::size_t snapshot = 80;
  const std::size_t expected = sizeof(Node) + snapshot + 200;
  EXPECT_LT(after - before, nodes * expected) << (after - before) / nodes << " bytes a node";
}

}  // namespace
}  // namespace rt::lua
