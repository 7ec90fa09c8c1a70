#include "script_run.h"

namespace rt::lua {
namespace {

class Render : public ScriptTest {
 protected:
  /// Renders with `tail` after the course's ten arguments, `size` as width and height.
  const RenderJob& course(const std::string& tail, const std::string& size = "4, 3") {
    run(course_text(tail, size));
    return jobs_.back();
  }
  static std::string course_text(const std::string& tail, const std::string& size = "4, 3") {
    return "s = gr.sphere('s'):set_material(gr.material(1, 0, 1))\n"
           "gr.render(s, 'out/a.png', " +
           size + ", {1, 2, 3}, {0, 0, -2}, {0, 3, 0}, 40, {0.1, 0.2, 0.3}, {}" + tail + ")";
  }
  static std::string named_text(const std::string& fields,
                                const std::string& camera = "eye={1,2,3}, look_at={1,2,0}") {
    return "s = gr.sphere('s')\ngr.render{scene=s, file='b.exr', size={64, 48}, camera={" + camera +
           "}" + (fields.empty() ? "" : ", " + fields) + "}";
  }
  const RenderJob& named(const std::string& fields) {
    run(named_text(fields));
    return jobs_.back();
  }
};

TEST_F(Render, TheCoursesTenArguments) {
  run(R"(
local l = gr.light({9, 9, 9}, {1, 1, 1}, {1, 0, 0})
gr.render(gr.sphere('s'), 'out/a.png', 640, 480, {1, 2, 3}, {0, 0, -2}, {0, 3, 0}, 40,
          {0.1, 0.2, 0.3}, {l, l}))");
  ASSERT_EQ(jobs_.size(), 1u);
  const RenderJob& job = jobs_[0];
  EXPECT_EQ(job.output, "out/a.png");
  EXPECT_EQ(job.options.width, 640);
  EXPECT_EQ(job.options.height, 480);
  EXPECT_EQ(job.camera.eye, Vec3(1, 2, 3));
  EXPECT_EQ(job.camera.view, Vec3(0, 0, -2));
  EXPECT_EQ(job.camera.up, Vec3(0, 3, 0));
  EXPECT_EQ(job.camera.fov, 40.0);
  EXPECT_EQ(job.ambient, Rgb(0.1, 0.2, 0.3));
  EXPECT_EQ(job.lights.size(), 2u);
  EXPECT_EQ(job.instances.size(), 1u);
  EXPECT_EQ(job.options.max_depth, RenderOptions{}.max_depth);
  EXPECT_TRUE(without_folder(job.where).starts_with("scene.lua:")) << job.where;
}

TEST_F(Render, WholeFloatsServeAsIntegers) {
  const RenderJob& job = course("", "1920/2, 1080/2");
  EXPECT_EQ(job.options.width, 960);
  EXPECT_EQ(job.options.height, 540);
}

TEST_F(Render, TrailingOptions) {
  const RenderJob& job = course(
      ", {max_depth=3, samples=2^4, seed=7, encoding='raw', reflection=false, "
      "background={top={1,0,0}, bottom={0,0,1}}}");
  EXPECT_EQ(job.options.max_depth, 3);
  EXPECT_EQ(job.options.samples, 16);
  EXPECT_EQ(job.options.seed, 7u);
  EXPECT_EQ(job.options.encoding, Encoding::raw);
  EXPECT_FALSE(job.options.reflection);
  EXPECT_EQ(job.options.background.top, Rgb(1, 0, 0));
  EXPECT_EQ(job.options.background.bottom, Rgb(0, 0, 1));
  EXPECT_TRUE(warnings_.empty());
}

TEST_F(Render, OptionsMayBeAbsentNilOrEmpty) {
  for (const std::string tail : {"", ", nil", ", {}", ", nil, nil, nil"}) {
    EXPECT_EQ(course(tail).options.max_depth, RenderOptions{}.max_depth) << tail;
    EXPECT_TRUE(warnings_.empty()) << tail;
  }
}

TEST_F(Render, TrailingArgumentsOfOtherDialectsAreIgnoredWithOneWarning) {
  for (const std::string tail :
       {", s", ", 3", ", {s, s}", ", 'x', 1, true, {}, print, 3", ", nil, {max_depth=1}"}) {
    warnings_.clear();
    EXPECT_EQ(course(tail).options.max_depth, RenderOptions{}.max_depth);
    ASSERT_EQ(warnings_.size(), 1u) << tail;
    EXPECT_TRUE(
        without_folder(warnings_[0]).starts_with("scene.lua:2: gr.render: ignored argument 1"))
        << warnings_[0];
  }
}

TEST_F(Render, NamedForm) {
  run(R"(
    local l = gr.light({9, 9, 9}, {1, 1, 1}, {1, 0, 0})
    gr.render{scene = gr.sphere('s'), file = 'b.exr', size = {64.0, 48},
              camera = {eye = {1, 2, 3}, view = {0, 0, -1}, up = {1, 0, 0}, fov = 30},
              ambient = 0.25, lights = {l}, max_depth = 2, background = {1, 2, 3}})");
  const RenderJob& job = jobs_.at(0);
  EXPECT_EQ(job.output, "b.exr");
  EXPECT_EQ(job.options.width, 64);
  EXPECT_EQ(job.options.height, 48);
  EXPECT_EQ(job.camera.eye, Vec3(1, 2, 3));
  EXPECT_EQ(job.camera.view, Vec3(0, 0, -1));
  EXPECT_EQ(job.camera.up, Vec3(1, 0, 0));
  EXPECT_EQ(job.camera.fov, 30.0);
  EXPECT_EQ(job.ambient, Rgb(0.25));
  EXPECT_EQ(job.lights.size(), 1u);
  EXPECT_EQ(job.options.max_depth, 2);
  EXPECT_EQ(job.options.background.top, Rgb(1, 2, 3));
  EXPECT_EQ(job.options.background.bottom, Rgb(1, 2, 3));
}

TEST_F(Render, NamedFormHasDefaults) {
  const RenderJob& job = named("");
  EXPECT_EQ(job.camera.view, Vec3(0, 0, -3)) << "look_at minus eye";
  EXPECT_EQ(job.camera.up, Vec3(0, 1, 0));
  EXPECT_EQ(job.ambient, Rgb(0.0));
  EXPECT_TRUE(job.lights.empty());
}

TEST_F(Render, EveryScriptOptionIsAccepted) {
  for (const OptionSpec& spec : option_specs()) {
    // A value of no sensible kind: the option's own check speaks, not the list of known keys.
    const Failure got = failure(named_text(std::string(spec.name) + "='?!'"));
    EXPECT_TRUE(got.text.starts_with("scene.lua:2: gr.render: option '" + std::string(spec.name) +
                                     "': expected "))
        << got.text;
  }
}

TEST_F(Render, UnknownKeysSuggestTheNearest) {
  expect_error(course_text(", {max_dpeth=3}"),
               "scene.lua:2: gr.render: unknown key 'max_dpeth'; did you mean 'max_depth'?",
               {"background", "samples"});
  expect_error(named_text("light={}"),
               "scene.lua:2: gr.render: unknown key 'light'; did you mean 'lights'?");
  expect_error(named_text("exposure={0, 1}"), "scene.lua:2: gr.render: unknown key 'exposure'");
  expect_error(named_text("", "eye={0,0,1}, view={0,0,-1}, iso=1"),
               "scene.lua:2: gr.render: unknown key 'iso' in camera", {"eye, view, up, fov"});
  expect_error(named_text("background={top=1, bottm=1, bottom=1}"),
               "scene.lua:2: gr.render: unknown key 'bottm' in background; did you mean 'bottom'?");
}

TEST_F(Render, BadOptionsAreExplained) {
  expect_error(course_text(", {max_depth=-1}"),
               "scene.lua:2: gr.render: option 'max_depth': expected a whole number", {"got -1"});
  expect_error(course_text(", {samples=2.5}"), "scene.lua:2: gr.render: option 'samples': ");
  expect_error(course_text(", {samples=0/0}"),
               "scene.lua:2: gr.render: expected a finite number as 'samples'");
  expect_error(course_text(", {samples={}}"),
               "scene.lua:2: gr.render: ", {"as 'samples', got an empty table"});
  expect_error(course_text(", {encoding='linear'}"), "scene.lua:2: gr.render: option 'encoding'",
               {"'srgb'", "'raw'"});
  expect_error(course_text(", {background={top=1}}"),
               "scene.lua:2: gr.render: ", {"'background.bottom', got nil"});
  expect_error(course_text(", {background='red'}"), "scene.lua:2: gr.render: ", {"'background'"});
}

TEST_F(Render, BadSizesAreErrors) {
  for (const std::string size : {"0, 3", "-4, 3", "4, 0", "4.5, 3", "65537, 3", "4, 0/0", "1/0, 3",
                                 "'4', 3", "nil, 3", "1e300, 3"}) {
    expect_error(
        course_text("", size),
        "scene.lua:2: gr.render: expected a whole number of pixels from 1 to 65536 as argument ");
  }
  expect_error(
      "gr.render{scene=gr.node('n'), file='a.png', size={0, 1}, camera={eye={0,0,1}, "
      "look_at={0,0,0}}}",
      "scene.lua:1: gr.render: ", {"'size.width', got a number (0)"});
  expect_error(
      "gr.render{scene=gr.node('n'), file='a.png', size=640, camera={eye={0,0,1}, "
      "look_at={0,0,0}}}",
      "scene.lua:1: gr.render: ", {"{width, height}", "'size', got a number (640)"});
}

TEST_F(Render, ImpossibleCamerasAreErrors) {
  const auto with = [](const std::string& camera) {
    return "gr.render(gr.node('n'), 'a.png', 4, 3, " + camera + ", {0, 0, 0}, {})";
  };
  expect_error(with("{0,0,0}, {0,1,0}, {0,2,0}, 50"), "scene.lua:1: ", {"camera", "parallel"});
  expect_error(with("{0,0,0}, {0,0,0}, {0,1,0}, 50"), "scene.lua:1: ", {"camera", "view"});
  expect_error(with("{0,0,0}, {0,0,1}, {0,0,0}, 50"), "scene.lua:1: ", {"camera", "up"});
  expect_error(with("{0,0,0}, {0,0,1}, {0,1,0}, 180"), "scene.lua:1: ", {"180"});
  expect_error(with("{0,0,0/0}, {0,0,1}, {0,1,0}, 50"),
               "scene.lua:1: ", {"argument 5 (eye)", "nan"});
  expect_error(named_text("", "eye={0,0,1}"), "scene.lua:2: ", {"'view'", "'look_at'"});
  expect_error(named_text("", "eye={0,0,1}, view={0,0,1}, look_at={0,0,0}"),
               "scene.lua:2: ", {"both"});
  expect_error(named_text("", "eye={0,0,1}, look_at={0,0,1}"), "scene.lua:2: ", {"its own 'eye'"});
  expect_error(named_text("", "look_at={0,0,1}"), "scene.lua:2: ", {"'camera.eye', got nil"});
  expect_error("gr.render{scen = gr.node('n'), file = 'a.png'}", "scene.lua:1: gr.render",
               {"unknown key 'scen'; did you mean 'scene'"});
}

TEST_F(Render, BadArgumentsAreExplained) {
  expect_error("gr.render()",
               "scene.lua:1: gr.render: expected a node as argument 1 (scene), got nothing");
  expect_error("gr.render(gr.light({0,0,0},1,{1,0,0}))",
               "scene.lua:1: gr.render: ", {"got a light"});
  expect_error("gr.render(gr.node('n'), '', 4, 3)",
               "scene.lua:1: ", {"a file name", "argument 2 (file)"});
  expect_error("gr.render{}", "scene.lua:1: gr.render: expected a node as 'scene', got nil");
  const auto lights = [](const std::string& text) {
    return "l = gr.light({0,0,0},1,{1,0,0})\n"
           "gr.render(gr.node('n'), 'a.png', 4, 3, {0,0,1}, {0,0,-1}, {0,1,0}, 50, {0,0,0}, " +
           text + ")";
  };
  expect_error(lights("l"),
               "scene.lua:2: gr.render: expected a list of lights {l1, l2} as argument 10 "
               "(lights), got a light");
  expect_error(lights("{l, nil, l}"), "scene.lua:2: ", {"item 2 is nil"});
  expect_error(lights("{l, 'l'}"), "scene.lua:2: ", {"item 2 is a string"});
  expect_error(lights("{key=l}"), "scene.lua:2: ", {"the key a string (\"key\")"});
  expect_error(lights("nil"), "scene.lua:2: ", {"argument 10 (lights), got nil"});
  EXPECT_TRUE(jobs_.empty());
}

TEST_F(Render, SeveralCallsMakeSeveralJobsAndEachIsASnapshot) {
  run(R"(
    local m = gr.material({1, 0, 0}, {0, 0, 0}, 1)
    local root = gr.node('root'):set_material(m)
    local ball = gr.sphere('ball')
    root:add_child(ball)
    for i = 1, 3 do
      gr.render(root, i .. '.png', 4, 3, {0,0,9}, {0,0,-1}, {0,1,0}, 50, {0,0,0}, {})
      ball:translate(1, 0, 0)
      root:add_child(gr.cube('c'))
      root:set_material(gr.material({0, i, 0}, {0, 0, 0}, 1))
    end)");
  ASSERT_EQ(jobs_.size(), 3u);
  for (int i = 0; i < 3; ++i) {
    const RenderJob& job = jobs_[static_cast<std::size_t>(i)];
    EXPECT_EQ(job.output, std::to_string(i + 1) + ".png");
    ASSERT_EQ(job.instances.size(), static_cast<std::size_t>(i + 1));
    EXPECT_EQ(job.instances[0].world_from_model.offset, Vec3(i, 0, 0));
    EXPECT_EQ(job.instances[0].material->kd, i == 0 ? Rgb(1, 0, 0) : Rgb(0, i, 0));
  }
}

}  // namespace
}  // namespace rt::lua
