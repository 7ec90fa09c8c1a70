#include <cmath>

#include "script_run.h"

namespace rt::lua {
namespace {

class MotionScript : public ScriptTest {
 protected:
  Vec3 place(const std::string& script, double time, const Vec3& p = Vec3(0.0)) {
    const Instance& instance = instance_of_root(script);
    return instance.motion ? instance.motion->at(time).point(p)
                           : instance.world_from_model.point(p);
  }
  static void expect_near(const Vec3& a, const Vec3& b, double tolerance = 1e-12) {
    EXPECT_LT(glm::length(a - b), tolerance) << a.x << ' ' << a.y << ' ' << a.z;
  }
};

TEST_F(MotionScript, FromOnePoseToAnother) {
  const std::string script =
      "root = gr.sphere('s'):translate(1, 0, 0):motion{from={translate={0,1,0}}, "
      "to={translate={0,3,0}, rotate={'y', 180}, scale=2}}";
  expect_near(place(script, 0.0), {1, 1, 0});
  expect_near(place(script, 0.5), {0, 2, -1.5});
  expect_near(place(script, 1.0), {-2, 3, 0});
}

TEST_F(MotionScript, TurnsAboutAPointAndAnyAxis) {
  const std::string script =
      "root = gr.sphere('s'):motion{to={rotate={{0, 0, 2}, 90}, about={1, 0, 0}}}";
  expect_near(place(script, 0.0), {0, 0, 0});
  expect_near(place(script, 1.0), {1, -1, 0});
}

TEST_F(MotionScript, NestedNodesMoveTogether) {
  const std::string script =
      "local arm = gr.node('arm'):translate(0, 1, 0):motion{to={rotate={'z', 90}}}\n"
      "arm:add_child(gr.sphere('hand'):motion{to={translate={2, 0, 0}}})\n"
      "root = gr.node('root'):translate(0, 0, 5):add_child(arm)";
  expect_near(place(script, 0.0), {0, 1, 5});
  expect_near(place(script, 1.0), {-1, 2, 5});
}

TEST_F(MotionScript, AFunctionOfTimeIsFollowed) {
  const std::string script =
      "root = gr.sphere('s'):motion(function(t) local a = 2 * math.pi * t\n"
      "return {translate={3 * math.cos(a), 3 * math.sin(a), 0}} end)";
  for (double t = 0.0; t <= 1.0; t += 0.037) {
    const double a = 2.0 * M_PI * t;
    expect_near(place(script, t), {3 * std::cos(a), 3 * std::sin(a), 0}, 3.0 * 3e-4);
  }
}

TEST_F(MotionScript, OnlyMovingSubtreesHaveAPath) {
  const RenderJob& job = job_of_root(
      "root = gr.node('r'):add_child(gr.sphere('still')):add_child("
      "gr.node('m'):motion{to={translate={1,0,0}}}:add_child(gr.sphere('moving')))");
  EXPECT_EQ(job.instances[0].motion, nullptr);
  EXPECT_NE(job.instances[1].motion, nullptr);
}

TEST_F(MotionScript, CameraLightAndShutter) {
  run("l = gr.light{position={1,2,3}, to={2,2,3}}\n"
      "gr.render{scene=gr.sphere('s'), file='a.png', size={4,3}, lights={l}, shutter={0.25, 0.5},"
      "camera={eye={0,0,9}, look_at={0,0,0}, aperture=0.5, focus=8, to={eye={1,0,9}}}}");
  const RenderJob& job = jobs_.back();
  expect_near(job.lights[0].travel, {1, 0, 0});
  EXPECT_EQ(job.options.shutter_open, 0.25);
  EXPECT_EQ(job.options.shutter_close, 0.5);
  EXPECT_EQ(job.camera.aperture, 0.5);
  EXPECT_EQ(job.camera.focus, 8.0);
  expect_near(job.camera.to->eye, {1, 0, 9});
  expect_near(job.camera.to->view, {-1, 0, -9});
  const Camera half = at_time(job.camera, 0.5);
  expect_near(half.eye, {0.5, 0, 9});
}

TEST_F(MotionScript, OfTheCameraWhatIsNotGivenStays) {
  const auto end = [&](const std::string& camera) {
    run("gr.render{scene=gr.sphere('s'), file='a.png', size={4,3}, camera={eye={0,0,9}, " + camera +
        "}}");
    return *jobs_.back().camera.to;
  };
  expect_near(end("look_at={0,0,0}, to={look_at={1,0,0}}").eye, {0, 0, 9});
  expect_near(end("look_at={0,0,0}, to={look_at={1,0,0}}").view, {1, 0, -9});
  expect_near(end("look_at={0,0,0}, to={eye={1,0,9}}").view, {-1, 0, -9});
  expect_near(end("look_at={0,0,0}, to={view={1,0,0}}").view, {1, 0, 0});
  expect_near(end("view={0,0,-1}, to={eye={1,0,9}}").view, {0, 0, -1});
  EXPECT_EQ(end("look_at={0,0,0}, to={fov=20}").fov, 20.0);
}

TEST_F(MotionScript, MistakesOfTheCameraAreNamed) {
  const auto camera = [](const std::string& to) {
    return "gr.render{scene=gr.sphere('s'), file='a.png', size={4,3}, "
           "camera={eye={0,0,9}, look_at={0,0,0}, to=" +
           to + "}}";
  };
  expect_error(camera("{view={0,0,1}, look_at={1,0,0}}"), "scene.lua:1: gr.render",
               {"camera.to has both 'view' and 'look_at'"});
  expect_error(camera("{eye={0,0,0}}"), "scene.lua:1: gr.render",
               {"camera.to looks at its own 'eye'"});
  expect_error(camera("{aye={0,0,0}}"), "scene.lua:1: gr.render",
               {"unknown key 'aye' in camera.to", "did you mean 'eye'"});
}

TEST_F(MotionScript, Mistakes) {
  const auto motion = [](const std::string& text) { return "gr.sphere('s'):motion" + text; };
  expect_error(motion("(3)"), "scene.lua:1: node:motion of 's'", {"{from =, to =} or a function"});
  expect_error(motion("{from={}}"), "scene.lua:1: node:motion of 's'", {"to"});
  expect_error(motion("{to={rotat={'x', 3}}}"), "scene.lua:1: node:motion of 's'",
               {"did you mean 'rotate'"});
  expect_error(motion("{to={rotate={'w', 3}}}"), "scene.lua:1: node:motion of 's'", {"axis"});
  expect_error(motion("{to={scale=0}}"), "scene.lua:1: node:motion of 's'", {"not 0"});
  expect_error(motion("(function(t) return 3 end)"), "scene.lua:1: node:motion of 's'", {"table"});
  expect_error(motion("(function(t) error('mine') end)"), "scene.lua:1: ", {"mine"});
}

}  // namespace
}  // namespace rt::lua
