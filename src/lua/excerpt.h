#pragma once
/// Shows the line of source that a message is about.
#include <filesystem>
#include <map>
#include <string>

namespace rt::lua {

/// The files of what has been run, by the names that messages give them.
using Sources = std::map<std::string, std::filesystem::path>;

/// The message with names that Lua has cut ("...ng/folder/scene.lua:12:") in full.
std::string with_full_names(std::string message, const Sources& sources);

/// The message with the column after its line, where that can be told, and the source line below it
/// with a caret:
///
///     scene.lua:12:20: gr.material: unknown key 'shinyness'; did you mean 'shininess'? ...
///        12 | local red = gr.material{shinyness = 3}
///           |                         ^
///
/// Empty when the message does not begin with a line of one of the sources. What the message quotes
/// is looked for in the line, and so is the argument that it counts ("argument 2").
std::string with_excerpt(const std::string& message, const Sources& sources);

}  // namespace rt::lua
