// A scene of a million nodes, from the script to the picture.
#include <nlohmann/json.hpp>

#include "program.h"

namespace rt::test {
namespace {

using ManyNodes = ProgramTest;

TEST_F(ManyNodes, AMillionFitInOneAndAHalfGigabytes) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers take memory of their own";
#endif
  const Outcome o = run_script(
      "local root, m = gr.node('root'), gr.material({0.7, 0.3, 0.2}, {0.2, 0.2, 0.2}, 20)\n"
      "for i = 0, 999999 do\n"
      "  root:add_child(gr.sphere('s'):set_material(m):scale(0.4, 0.4, 0.4)\n"
      "    :translate(i % 100, i // 100 % 100, i // 10000))\n"
      "end\n"
      "gr.render(root, 'x.png', 16, 16, {50, 50, -200}, {0, 0, 1}, {0, 1, 0}, 40, 0.3,\n"
      "  {gr.light({0, 200, -300}, {1, 1, 1}, {1, 0, 0})})\n",
      "-q --samples 1 --stats stats.json");
  ASSERT_EQ(o.exit_code, 0) << o.err;
  const auto stats = nlohmann::json::parse(contents(folder_ / "stats.json"));
  EXPECT_EQ(stats.at("pictures").at(0).at("instances"), 1'000'000);
  EXPECT_LT(stats.at("peak_memory_bytes"), 1'500'000'000);
}

}  // namespace
}  // namespace rt::test
