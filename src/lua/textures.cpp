/// gr.checker and gr.texture.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "call.h"
#include "fields.h"
#include "files.h"
#include "functions.h"
#include "handle.h"
#include "textures.h"

namespace rt::lua {

int make_checker(Call& call) {
  Checker checker;
  checker.even = call.argument(1, "even").colour();
  checker.odd = call.argument(2, "odd").colour();
  if (call.argument(3).given()) {
    checker.size = call.argument(3, "size").number(positive);
  }
  push<const Texture>(call.L, make_charged(call.L, Texture(checker)));
  return 1;
}

namespace {

/// A texture as the script describes it, before its file is looked for.
struct Draft {
  std::string file;
  ImageTexture texture;
};

/// {u, v}, or one number for both. Negative ones mirror the picture.
void read_scale(const Value& value, Draft& draft) {
  constexpr std::string_view expected = "two numbers {u, v} that are not 0, or one for both";
  Vec2& scale = draft.texture.scale;
  if (value.type() == LUA_TTABLE) {
    lua_State* L = value.call().L;
    if (lua_rawlen(L, value.index()) != 2) {
      value.fail(expected);
    }
    for (int i = 0; i < 2; ++i) {
      lua_rawgeti(L, value.index(), i + 1);
      const std::string name = fmt::format("{} {}", value.name(), i == 0 ? "u" : "v");
      scale[i] = Value(value.call(), lua_gettop(L), "", name).number();
      lua_pop(L, 1);
    }
  } else {
    scale = Vec2(value.number({expected}));
  }
  if (scale.x == 0.0 || scale.y == 0.0) {
    value.fail(expected);
  }
}

void read_wrap(const Value& value, Draft& draft) {
  constexpr std::string_view expected = "'repeat', 'clamp', 'mirror' or 'black'";
  constexpr std::array<std::string_view, 4> names{"repeat", "clamp", "mirror", "black"};
  constexpr std::array wraps{Wrap::repeat, Wrap::clamp, Wrap::mirror, Wrap::black};
  const auto* name = std::ranges::find(names, value.text(expected));
  if (name == names.end()) {
    value.fail(expected);
  }
  draft.texture.wrap = wraps[static_cast<std::size_t>(name - names.begin())];
}

void read_name(const Value& value, Draft& draft) {
  draft.file = value.text("the name of a picture file (string)");
}

/// In the order of the positional form, which takes the first two.
constexpr std::array texture_fields{
    Field<Draft>{"file", read_name, "", true},
    Field<Draft>{"scale", read_scale},
    Field<Draft>{"wrap", read_wrap},
};

std::shared_ptr<const TextureImage> picture(const Call& call, const std::string& name) {
  Context& run = call.run();
  const FoundFile file = find_file(call, name, run.texture_folders);
  auto& image = run.pictures[file.real];
  if (!image) {
    image = run.host.open_texture(file.shown);  // shown: so do its messages
  }
  return image;
}

}  // namespace

std::shared_ptr<const Texture> picture_texture(const Call& call, const std::string& file) {
  ImageTexture texture;
  texture.image = picture(call, file);
  return make_charged(call.L, Texture(std::move(texture)));
}

int make_texture(Call& call) {
  const std::span<const Field<Draft>> fields = texture_fields;
  Draft draft;
  const Value first = call.argument(1, "file");
  if (call.count() == 1 && first.type() == LUA_TTABLE) {
    read_only_fields(call, first.index(), "", fields, draft);
  } else {
    fields[0].read(first, draft);
    if (const Value scale = call.argument(2, "scale"); scale.given()) {
      fields[1].read(scale, draft);
    }
  }
  draft.texture.image = picture(call, draft.file);
  push<const Texture>(call.L, make_charged(call.L, Texture(std::move(draft.texture))));
  return 1;
}

}  // namespace rt::lua
