/// The files that are written out from the binding's table are those in docs/.
#include "rt/lua/reference.h"

#include <cstdlib>
#include <iterator>

#include "script_run.h"

namespace rt::lua {
namespace {

void expect_current(const std::string& name, const std::string& text) {
  const std::filesystem::path file = std::filesystem::path(RT_SOURCE_DIR) / "docs" / name;
  if (std::getenv("RT_UPDATE_DOCS") != nullptr) {
    std::ofstream(file, std::ios::binary) << text;
  }
  std::ifstream in(file, std::ios::binary);
  const std::string there{std::istreambuf_iterator<char>(in), {}};
  EXPECT_TRUE(there == text) << "docs/" << name << " is out of date; to write it again:\n"
                             << "  RT_UPDATE_DOCS=1 ctest --preset release -R Reference";
}

TEST(Reference, AnnotationsAreCurrent) { expect_current("gr.d.lua", editor_annotations()); }

TEST(Reference, ThePageIsCurrent) { expect_current("reference.md", reference_page()); }

using ReferenceScript = ScriptTest;

TEST_F(ReferenceScript, AnnotationsAreLua) {
  write("gr.d.lua", editor_annotations());
  run("dofile 'gr.d.lua'\nassert(gr.sphere('replaced') == nil)");
}

TEST(Reference, TypesAreThoseOfLuaCats) {
  const std::string text = editor_annotations();
  for (const char* line :
       {"---@param name string\n---@return gr.Node\nfunction gr.sphere(name) end\n",
        "---@param x? number[]\n",
        "---@overload fun(name: string, R: number, r: number): gr.Node\n",
        "---@param axis 'x'|'y'|'z'\n", "---@param size number|number[]\n",
        "---@param lights gr.Light[]\n", "shininess?: number", "camera: { eye: number[], ",
        "max_depth?: number", "reflection?: boolean", "---@param options? table\n",
        "---@param fields { from?: gr.Pose, to: gr.Pose }\n",
        "---@overload fun(self: gr.Node, pose_at: function): gr.Node\n", "to?: { eye?: number[], ",
        "shutter?: number[]", "ramp?: { [1]: number, [2]: gr.Colour }[]",
        "function Node:rotate(axis, degrees) end\n"}) {
    EXPECT_NE(text.find(line), std::string::npos) << line;
  }
}

TEST(Reference, SignaturesAreParsedWhole) {
  for (const char* piece : {"{  }", ", )", "fun()"}) {
    EXPECT_EQ(editor_annotations().find(piece), std::string::npos) << piece;
  }
}

TEST(Reference, ThePageListsEveryOption) {
  for (const char* row : {"| `background` | ", "| `shutter` | ", "| `samples` | "}) {
    EXPECT_NE(reference_page().find(row), std::string::npos) << row;
  }
}

}  // namespace
}  // namespace rt::lua
