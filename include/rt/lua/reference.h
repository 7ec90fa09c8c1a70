#pragma once
/// What scripts can call, written out from the one table that defines it.
#include <string>

namespace rt::lua {

/// docs/gr.d.lua: annotations for editors, in LuaCATS.
std::string editor_annotations();

/// docs/reference.md: every call on one page.
std::string reference_page();

}  // namespace rt::lua
