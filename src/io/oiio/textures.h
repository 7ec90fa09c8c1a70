#pragma once
/// The texture system's side of the module's table (table.h).
#include "table.h"

namespace rt::io {

std::string make_texture(const TextureRequest& request, ReadyTexture*& texture, bool& is_encoded);
void drop_texture(ReadyTexture* texture);
bool look_up(const ReadyTexture& texture, const TextureLookup& lookup, bool derivatives,
             TextureResult& result);
void set_texture_memory(int megabytes);
TextureCounts texture_counts();

}  // namespace rt::io
