#include "script_run.h"

namespace rt::lua {
namespace {

using Methods = ScriptTest;

TEST_F(Methods, ChainAndPreMultiply) {
  const auto& turned =
      instance_of_root("root = gr.sphere('s'):scale(2, 3, 4):translate(0, 0, 2):rotate('y', 90)");
  EXPECT_EQ(turned.world_from_model.point({0, 0, 0}), Vec3(2, 0, 0));
  EXPECT_EQ(turned.world_from_model.vector({0, 1, 0}), Vec3(0, 3, 0));
}

TEST_F(Methods, EachReturnsTheSameNode) {
  run(R"(
    local n, m = gr.node('n'), gr.material({1,1,1}, {0,0,0}, 1)
    assert(n:add_child(gr.node('c')) == n or rawequal(n:translate(1,2,3), n))
    assert(rawequal(n:set_material(m), n) and rawequal(n:rotate('x', 1), n))
    assert(rawequal(n:scale(1, 2, 3), n) and rawequal(n:add_child(gr.node('d')), n)))");
}

TEST_F(Methods, AxisLettersInBothCases) {
  for (const std::string axis : {"x", "y", "z"}) {
    const std::string upper(1, static_cast<char>(axis[0] - 'a' + 'A'));
    const auto small = instance_of_root("root = gr.cube('c'):rotate('" + axis + "', 30)");
    const auto large = instance_of_root("root = gr.cube('c'):rotate('" + upper + "', 30)");
    EXPECT_EQ(small.world_from_model.linear, large.world_from_model.linear);
    EXPECT_EQ(small.world_from_model.linear, Affine::rotation(axis[0] - 'x', 30).linear) << axis;
  }
}

TEST_F(Methods, ScaleByOneNumberIsUniform) {
  const auto& twice = instance_of_root("root = gr.cube('c'):scale(2)");
  EXPECT_EQ(twice.world_from_model.linear, Mat3(2.0));
}

TEST_F(Methods, VectorsMayBeTables) {
  const auto& moved = instance_of_root("root = gr.cube('c'):scale({2, 2, 2}):translate{1, 2, 3}");
  EXPECT_EQ(moved.world_from_model.point({1, 1, 1}), Vec3(3, 4, 5));
}

TEST_F(Methods, OneChildUnderTwoParentsIsInstancing) {
  const auto& job = job_of_root(R"(
    local arm = gr.sphere('arm')
    root = gr.node('root')
    root:add_child(gr.node('left'):translate(-1, 0, 0):add_child(arm))
    root:add_child(gr.node('right'):translate(1, 0, 0):add_child(arm)))");
  ASSERT_EQ(job.instances.size(), 2u);
  EXPECT_EQ(job.instances[0].shape, job.instances[1].shape);
  EXPECT_EQ(job.instances[0].world_from_model.offset, Vec3(-1, 0, 0));
  EXPECT_EQ(job.instances[1].world_from_model.offset, Vec3(1, 0, 0));
}

TEST_F(Methods, MaterialsAreInheritedFromTheNearestAncestor) {
  const auto& job = job_of_root(R"(
    local red = gr.material({1, 0, 0}, {0, 0, 0}, 1)
    local blue = gr.material({0, 0, 1}, {0, 0, 0}, 1)
    root = gr.node('root'):set_material(red)
    root:add_child(gr.sphere('a'))
    root:add_child(gr.node('b'):set_material(blue):add_child(gr.sphere('c'))))");
  EXPECT_EQ(job.instances.at(0).material->kd, Rgb(1, 0, 0));
  EXPECT_EQ(job.instances.at(1).material->kd, Rgb(0, 0, 1));
  EXPECT_TRUE(warnings_.empty());
}

TEST_F(Methods, AMissingMaterialIsWarnedOfOnce) {
  const std::string render =
      "gr.render(s, 'a.png', 4, 3, {0,0,9}, {0,0,-1}, {0,1,0}, 50, {0,0,0}, {})\n";
  run("s = gr.sphere('bare')\n" + render + render);
  ASSERT_EQ(warnings_.size(), 1u);
  EXPECT_TRUE(without_folder(warnings_[0]).starts_with("scene.lua:2: node 'bare'")) << warnings_[0];
}

TEST_F(Methods, ACycleIsAnError) {
  expect_error("a = gr.node('a')\nb = gr.node('b')\na:add_child(b)\nb:add_child(a)",
               "scene.lua:4: ", {"'a'", "'b'", "contain itself"});
  expect_error("a = gr.node('a'); a:add_child(a)", "scene.lua:1: ", {"'a'"});
}

TEST_F(Methods, SingularAndNonFiniteTransformsNameTheNode) {
  expect_error("gr.sphere('elbow'):scale(1, 0, 1)", "scene.lua:1: ", {"'elbow'", "factor of 0"});
  expect_error(
      "gr.sphere('elbow'):translate(1, 0/0, 1)",
      "scene.lua:1: node:translate of 'elbow': expected a finite number as argument 2 (y), "
      "got a number (");
  expect_error("gr.sphere('elbow'):translate(math.huge, 0, 1)",
               "scene.lua:1: ", {"'elbow'", "argument 1 (x), got a number (inf)"});
  expect_error("gr.sphere('elbow'):rotate('x', 1/0)", "scene.lua:1: ", {"'elbow'", "degrees"});
  expect_error(
      "root = gr.sphere('elbow')\nfor i = 1, 9 do root:scale(1e-200) end\n"
      "gr.render(root, 'a.png', 4, 3, {0,0,9}, {0,0,-1}, {0,1,0}, 50, {0,0,0}, {})",
      "scene.lua:3: ", {"'elbow' (scene.lua:1)"});
}

TEST_F(Methods, BadArgumentsAreExplained) {
  expect_error("gr.node('n'):rotate('w', 30)",
               "scene.lua:1: node:rotate of 'n': expected an axis 'x', 'y' or 'z' as argument 1 "
               "(axis), got a string (\"w\"); try node:rotate('y', 90)");
  expect_error("gr.node('n'):rotate('xy', 30)", "scene.lua:1: ", {"(\"xy\")"});
  expect_error("gr.node('n'):rotate(30, 'x')", "scene.lua:1: ", {"axis", "a number (30)"});
  expect_error("gr.node('n'):rotate('x')", "scene.lua:1: ", {"argument 2 (degrees), got nothing"});
  expect_error("gr.node('n'):translate(1, 2)", "scene.lua:1: ", {"argument 3 (z), got nothing"});
  expect_error("gr.node('n'):translate('1', 2, 3)", "scene.lua:1: ", {"a string (\"1\")"});
  expect_error("gr.node('n'):scale()", "scene.lua:1: ", {"argument 1 (x), got nothing"});
  expect_error("gr.node('n'):scale(1, 2)", "scene.lua:1: ", {"argument 3 (z), got nothing"});
  expect_error("gr.node('n'):add_child(nil)", "scene.lua:1: node:add_child of 'n': ",
               {"expected a node as argument 1 (child), got nil"});
  expect_error("gr.node('n'):add_child({})", "scene.lua:1: ", {"an empty table"});
  expect_error("gr.node('n'):add_child(gr.material(1, 0, 1))", "scene.lua:1: ", {"got a material"});
  expect_error("gr.node('n'):set_material(gr.node('m'))",
               "scene.lua:1: ", {"expected a material", "got a node (\"m\")"});
}

TEST_F(Methods, ADotForAColonIsDetected) {
  expect_error("local n = gr.node('n')\nn.translate(1, 2, 3)",
               "scene.lua:2: node:translate: expected a node before the colon, got a number (1); "
               "write a colon, not a dot: node:translate(1, 0, 0)");
  expect_error("local n = gr.node('n')\nn.rotate('x', 3)", "scene.lua:2: node:rotate: ", {"colon"});
  expect_error("local n = gr.node('n')\nn.add_child(gr.node('m'))", "scene.lua:2: node:add_child",
               {"got nothing", "node:add_child(child) (with a colon)"});
  expect_error("local n = gr.node('n')\nn.translate()", "scene.lua:2: ", {"got nothing", "colon"});
  expect_error("gr:sphere('s')",
               "scene.lua:1: gr.sphere: called with a colon; write a dot: gr.sphere(\"ball\")");
}

TEST_F(Methods, OtherObjectsAreNoNodes) {
  expect_error("local t = gr.node('n').translate; t(gr.material(1, 0, 1), 1, 2, 3)",
               "scene.lua:1: node:translate: ", {"got a material"});
  expect_error("local t = gr.node('n').translate; t(print, 1, 2, 3)",
               "scene.lua:1: ", {"got a function"});
  expect_error("gr.material(1, 0, 1):translate(1, 2, 3)",
               "scene.lua:1: a material has no 'translate'; only nodes have methods");
  expect_error("print(gr.light({0, 0, 0}, 1, {1, 0, 0}).colour)",
               "scene.lua:1: a light has no 'colour'");
}

TEST_F(Methods, UnknownNamesSuggestTheNearestAndListWhatExists) {
  expect_error("gr.shpere('s')", "scene.lua:1: there is no gr.shpere; did you mean 'sphere'?",
               {"There are: node, joint, sphere", "render"});
  expect_error("gr.tesseract('s')", "scene.lua:1: there is no gr.tesseract. There are: node");
  expect_error("\ngr.node('n'):tranlate(1, 2, 3)",
               "scene.lua:2: nodes have no method 'tranlate'; did you mean 'translate'?",
               {"add_child", "set_material", "rotate", "scale"});
  expect_error("local x = gr.node('n')[1]", "scene.lua:1: nodes have no method 'a number (1)'");
  expect_error("gr.node('n').colour = 3", "scene.lua:1: cannot set 'colour'");
}

TEST_F(Methods, MetatablesAreOutOfReach) {
  run(R"(
    local n = gr.node('n')
    assert(getmetatable(n) == false)
    assert(getmetatable(gr) == false)
    assert(not pcall(setmetatable, n, {}) and not pcall(setmetatable, gr, {}))
    assert(getmetatable(gr.material(1, 0, 1)) == false)
    assert(getmetatable(gr.light({0,0,0}, 1, {1,0,0})) == false))");
}

}  // namespace
}  // namespace rt::lua
