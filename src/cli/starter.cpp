#include "rt/cli/starter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <string>
#include <string_view>
#include <system_error>

#include "rt/scene/error.h"

namespace rt::cli {
namespace {

/// Two marks stand for names that follow from the file's: @SCENE@ and @PICTURE@.
constexpr std::string_view starter = R"lua(-- Render this with:  raytracer @SCENE@
-- All there is to call: docs/scripting.md

-- Materials: diffuse colour, strength of the highlight, its sharpness.
local red  = gr.material({0.8, 0.2, 0.15}, {0.5, 0.5, 0.5}, 40)
local blue = gr.material({0.2, 0.35, 0.8}, {0.4, 0.4, 0.4}, 20)
-- The other way to write one, with names; a polished floor.
local floor_material = gr.material{kd = {0.55, 0.55, 0.5}, reflectivity = 0.15}

-- Shapes are nodes, and nodes hang below other nodes. y is up.
local scene = gr.node("scene")

local floor = gr.plane("floor")
floor:set_material(floor_material)
scene:add_child(floor)

-- Methods return their node, so calls can be chained. A sphere has radius 1: raise it onto the floor.
scene:add_child(gr.sphere("ball"):set_material(red):translate(0, 1, 0))

-- A loop makes many. The turn comes after the move: it carries each cube around the middle.
for i = 1, 6 do
  local cube = gr.cube("cube " .. i)
  cube:set_material(blue)
  cube:scale(0.6, 0.6, 0.6):translate(2, 0, -0.3):rotate("y", 60 * i)
  scene:add_child(cube)
end

-- Lights: position, colour, and how they dim with distance ({1, 0, 0}: not at all).
local sun = gr.light({6, 9, 7}, {0.8, 0.8, 0.75}, {1, 0, 0})

gr.render{
  scene = scene,
  file = "@PICTURE@",
  size = {640, 480},
  camera = {eye = {0, 3.5, 8}, look_at = {0, 0.6, 0}, up = {0, 1, 0}, fov = 40},
  ambient = 0.25,
  lights = {sun},
  background = {top = {0.35, 0.55, 0.85}, bottom = {0.85, 0.9, 0.95}},
}
)lua";

void replace(std::string& text, std::string_view mark, std::string_view by) {
  text.replace(text.find(mark), mark.size(), by);
}

/// The name as it may stand in a comment and between double quotes.
std::string plain(std::string name) {
  std::ranges::replace_if(
      name, [](unsigned char c) { return c < ' ' || c == '"' || c == '\\' || c == 0x7f; }, '_');
  return name;
}

}  // namespace

void write_starter_scene(const std::filesystem::path& file) {
  std::string text(starter);
  replace(text, "@SCENE@", plain(file.string()));
  replace(text, "@PICTURE@", plain(file.stem().string()) + ".png");
  std::FILE* out = std::fopen(file.c_str(), "wx");  // x: never over a file that is there
  const bool opened = out != nullptr;
  const bool written = opened && std::fwrite(text.data(), 1, text.size(), out) == text.size();
  if ((opened && std::fclose(out) != 0) || !written) {
    const int reason = errno;
    if (opened) {
      std::remove(file.c_str());
    }
    throw FileError(fmt::format("--new: cannot write '{}': {}", file.string(),
                                std::generic_category().message(reason)));
  }
}

}  // namespace rt::cli
