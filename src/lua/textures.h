#pragma once
#include <memory>
#include <string>

#include "call.h"

namespace rt::lua {

/// The picture in a file, as gr.texture gives it without further arguments.
std::shared_ptr<const Texture> picture_texture(const Call& call, const std::string& file);

}  // namespace rt::lua
