#include "script_run.h"

namespace rt::lua {
namespace {

using Nodes = ScriptTest;

TEST_F(Nodes, EveryPrimitiveHasItsShape) {
  EXPECT_EQ(shape_of<Sphere>("gr.sphere('s')").radius, 1.0);
  EXPECT_EQ(shape_of<Box>("gr.cube('c')").hi, Vec3(1, 1, 1));
  shape_of<Plane>("gr.plane('p')");
  EXPECT_EQ(shape_of<Square>("gr.plane('p', 3)").edge, 3.0);
  shape_of<Plane>("gr.plane('p', nil)");
  shape_of<Cylinder>("gr.cylinder('c')");
  shape_of<Blob>("gr.blob('b')");
  const auto sphere = shape_of<Sphere>("gr.nh_sphere('s', {1, 2, 3}, 4)");
  EXPECT_EQ(sphere.centre, Vec3(1, 2, 3));
  EXPECT_EQ(sphere.radius, 4.0);
  const auto cube = shape_of<Box>("gr.nh_box('b', {1, 2, 3}, 2)");
  EXPECT_EQ(cube.lo, Vec3(1, 2, 3));
  EXPECT_EQ(cube.hi, Vec3(3, 4, 5));
  EXPECT_EQ(shape_of<Box>("gr.nh_box('b', {1, 2, 3}, {1, 2, 4})").hi, Vec3(2, 4, 7));
}

TEST_F(Nodes, TorusTakesNoneOneOrBothRadii) {
  const auto plain = shape_of<Torus>("gr.torus('t')");
  EXPECT_EQ(plain.major_radius, 1.0);
  EXPECT_EQ(plain.minor_radius, 0.25);
  const auto thin = shape_of<Torus>("gr.torus('t', 0.1)");
  EXPECT_EQ(thin.major_radius, 1.0);
  EXPECT_EQ(thin.minor_radius, 0.1);
  const auto both = shape_of<Torus>("gr.torus('t', 2, 3)");
  EXPECT_EQ(both.major_radius, 2.0);
  EXPECT_EQ(both.minor_radius, 3.0);
}

TEST_F(Nodes, NamesReachTheInstances) {
  EXPECT_EQ(instance_of_root("root = gr.sphere('s' .. 12)").name, "s12");
}

TEST_F(Nodes, AJointStartsAtItsInitialAngles) {
  const auto& plain = instance_of_root("root = gr.joint('j'); root:add_child(gr.sphere('s'))");
  EXPECT_EQ(plain.world_from_model.linear, Mat3(1.0));
  const auto& turned = instance_of_root(
      "root = gr.joint('j', {0, 90, 90}, {-90, 90, 90}); root:add_child(gr.sphere('s'))");
  // About x first: y -> z; then about y: z -> x.
  EXPECT_EQ(turned.world_from_model.vector({0, 1, 0}), Vec3(1, 0, 0));
}

TEST_F(Nodes, AJointOutsideItsRangeIsWarnedOf) {
  run("gr.joint('elbow', {0, 20, 10})");
  ASSERT_EQ(warnings_.size(), 1u);
  EXPECT_EQ(without_folder(warnings_[0]),
            "scene.lua:1: gr.joint 'elbow': the initial angle 20 lies outside 0 to 10");
}

TEST_F(Nodes, BadArgumentsAreExplained) {
  expect_error("\n\ngr.sphere(3)",
               "scene.lua:3: gr.sphere: expected a name (string) as argument 1, got a number (3); "
               "try gr.sphere(\"ball\")");
  expect_error("gr.node()",
               "scene.lua:1: gr.node: expected a name (string) as argument 1, got nothing");
  expect_error(
      "gr.torus('t', -1)",
      "scene.lua:1: gr.torus: expected a positive number as argument 2 (r), got a number (-1)");
  expect_error(
      "gr.torus('t', 1, 0)",
      "scene.lua:1: gr.torus: expected a positive number as argument 3 (r), got a number (0)");
  expect_error("gr.torus('t', 'fat')", "scene.lua:1: gr.torus: ", {"got a string (\"fat\")"});
  expect_error("gr.plane('p', {})", "scene.lua:1: gr.plane: ", {"positive", "an empty table"});
  expect_error("gr.nh_sphere('s', {1, 2}, 1)", "scene.lua:1: gr.nh_sphere: ",
               {"{x, y, z}", "argument 2 (centre)", "item 3 is nil"});
  expect_error("gr.nh_sphere('s', {1, 2, 3, 4}, 1)",
               "scene.lua:1: gr.nh_sphere: ", {"a table with 4 items"});
  expect_error("gr.nh_sphere('s', {1, '2', 3}, 1)",
               "scene.lua:1: ", {"item 2 is a string (\"2\")"});
  expect_error("gr.nh_sphere('s', {0, 0, 0})",
               "scene.lua:1: ", {"positive number as argument 3 (radius), got nothing"});
  expect_error("gr.nh_sphere('s', {0, 0, 0}, 0/0)", "scene.lua:1: ", {"a finite number", "nan"});
  expect_error("gr.nh_box('b', {0, 0, 0}, -1)", "scene.lua:1: gr.nh_box: ", {"positive", "(-1)"});
  expect_error("gr.nh_box('b', {0, 0, 0}, {1, 0, 1})", "scene.lua:1: ", {"item 2 is a number (0)"});
  expect_error("gr.nh_box('b', {0, 1/0, 0}, 1)", "scene.lua:1: ", {"item 2 is a number (inf)"});
  expect_error("gr.joint('j', 5)", "scene.lua:1: gr.joint: ", {"{min, init, max}", "(5)"});
}

TEST_F(Nodes, ExtraArgumentsGiveOneWarning) {
  run("for i = 1, 3 do gr.sphere('s', 2, nil, {}) end\ngr.cube('c', nil, nil)");
  ASSERT_EQ(warnings_.size(), 1u);
  EXPECT_EQ(without_folder(warnings_[0]),
            "scene.lua:1: gr.sphere: ignored argument 2, a number (2); argument 4, an empty table. "
            "It takes (name: string): node");
}

TEST_F(Nodes, ANodePrintsAsItsName) {
  run("assert(tostring(gr.sphere('ball')) == \"node 'ball'\")");
}

TEST_F(Nodes, ALongChainIsLetGoWithoutOverflow) {
  run(R"(
    local root = gr.node('0')
    local last = root
    for i = 1, 300000 do
      local next = gr.node('n')
      last:add_child(next)
      last = next
    end)");
}

}  // namespace
}  // namespace rt::lua
