/// What nodes are painted with: node:set_texture and node:perlin_noise.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "describe.h"
#include "fields.h"
#include "functions.h"
#include "textures.h"

namespace rt::lua {
namespace {

constexpr std::array<std::string_view, texture_slots> slot_names{"kd", "ks", "opacity", "bump",
                                                                 "normal"};

/// The name's index among `names`, or the error that lists them.
std::size_t chosen(const Value& value, std::span<const std::string_view> names) {
  std::string expected;
  for (const std::string_view name : names) {
    expected += fmt::format("{}'{}'", expected.empty() ? "one of " : ", ", name);
  }
  const std::string text = value.text(expected);
  const auto found = std::find(names.begin(), names.end(), text);
  if (found == names.end()) {
    value.fail(expected, fmt::format("'{}'{}", text, suggestion(text, names)));
  }
  return static_cast<std::size_t>(found - names.begin());
}

TextureSlot slot_of(const Value& value) {
  return value.given() ? static_cast<TextureSlot>(chosen(value, slot_names)) : TextureSlot::kd;
}

/// Strength has a meaning for relief only.
double strength_of(const Value& value, TextureSlot slot) {
  if (!value.given()) {
    return 1.0;
  }
  if (slot != TextureSlot::bump && slot != TextureSlot::normal) {
    value.call().fail(fmt::format("a strength is for 'bump' and 'normal', not for '{}'",
                                  slot_names[static_cast<std::size_t>(slot)]));
  }
  return value.number();
}

void require_fitting(const Call& call, const Texture& texture, TextureSlot slot) {
  if (slot == TextureSlot::normal && !std::holds_alternative<ImageTexture>(texture)) {
    call.fail("only a picture can be a normal map; use 'bump' for noise");
  }
  if (slot == TextureSlot::bump && std::holds_alternative<Checker>(texture)) {
    call.fail("a checker has no slopes to make a bump of; use a picture or noise");
  }
}

/// Nodes share sets that nobody changes: each change makes a new one.
void set_slot(const Call& call, TextureSlot slot, TextureSet::Entry entry) {
  Node& node = *call.self();
  TextureSet set = node.textures ? *node.textures : TextureSet{};
  set[slot] = std::move(entry);
  node.textures = make_charged(call.L, std::move(set));
}

struct NoiseDraft {
  NoiseTexture texture;
  std::optional<Rgb> low, high;
  bool has_ramp = false;
  TextureSlot slot = TextureSlot::kd;
  double strength = 1.0;
  bool add = false;
};

/// Calls read(item) for each item of a list.
template <class Read>
void each_item(const Value& list, std::string_view expected, Read read) {
  lua_State* L = list.call().L;
  if (!list.is_list()) {
    list.fail(expected);
  }
  const auto count = static_cast<lua_Integer>(lua_rawlen(L, list.index()));
  for (lua_Integer i = 1; i <= count; ++i) {
    lua_rawgeti(L, list.index(), i);
    const std::string name = fmt::format("{}[{}]", list.name(), i);
    const Value item(list.call(), lua_gettop(L), "", name);
    if (item.type() != LUA_TTABLE) {
      item.fail(expected);
    }
    read(item);
    lua_pop(L, 1);
  }
}

/// Reads a table whose fields stand in it by name, or in their order.
template <class Target>
void read_members(const Value& table, std::span<const Field<Target>> fields, Target& target) {
  const Call& call = table.call();
  lua_State* L = call.L;
  std::vector<std::string> unknown = unknown_keys(call, table.index(), fields);
  for (std::size_t i = 1; i <= fields.size(); ++i) {
    std::erase(unknown, fmt::format("[{}]", i));
  }
  refuse_keys(call, table.name(), unknown, names_of(fields));
  lua_Integer i = 0;
  for (const auto& field : fields) {
    push_field(call, table.index(), field.name, field.alias);
    if (lua_rawgeti(L, table.index(), ++i) != LUA_TNIL) {
      if (!lua_isnil(L, -2)) {
        call.fail(fmt::format("{} has '{}' twice, by name and as item {}; give one", table.name(),
                              field.name, i));
      }
      lua_replace(L, -2);
    } else {
      lua_pop(L, 1);
    }
    const Value value(call, lua_gettop(L), table.name(), field.name);
    if (value.given() || field.required) {
      field.read(value, target);
    }
    lua_pop(L, 1);
  }
}

constexpr std::array octave_fields{
    Field<Octave>{"scale", [](const Value& v, Octave& o) { o.frequency = v.number(positive); }, "",
                  true},
    Field<Octave>{"weight", [](const Value& v, Octave& o) { o.weight = v.number(not_negative); }},
};

void read_octaves(const Value& value, NoiseDraft& draft) {
  draft.texture.octaves.clear();
  each_item(value, "a list of octaves {{scale = 1, weight = 1}, ...}", [&](const Value& item) {
    Octave octave{1.0, 1.0};
    read_members<Octave>(item, octave_fields, octave);
    draft.texture.octaves.push_back(octave);
  });
}

constexpr std::array stop_fields{
    Field<RampStop>{"at", [](const Value& v, RampStop& s) { s.at = v.number(); }, "", true},
    Field<RampStop>{"colour", [](const Value& v, RampStop& s) { s.colour = v.colour(); }, "color",
                    true},
};

void read_ramp(const Value& value, NoiseDraft& draft) {
  constexpr std::string_view expected = "a ramp {{0, colour}, {1, colour}, ...}";
  draft.texture.ramp.clear();
  draft.has_ramp = true;
  each_item(value, expected, [&](const Value& item) {
    RampStop stop{0.0, Rgb(0.0)};
    read_members<RampStop>(item, stop_fields, stop);
    if (!draft.texture.ramp.empty() && stop.at < draft.texture.ramp.back().at) {
      item.fail("stops in rising order",
                fmt::format("{} after {}", stop.at, draft.texture.ramp.back().at));
    }
    draft.texture.ramp.push_back(stop);
  });
}

void read_seed(const Value& value, NoiseDraft& draft) {
  constexpr Range range{"a whole number from 0 to 2^53", 0.0, 0x1p53};
  const double seed = value.number(range);
  if (seed != std::floor(seed)) {
    value.fail(range.words);
  }
  if (seed != 0.0) {
    draft.texture.noise = std::make_shared<const Noise>(static_cast<std::uint64_t>(seed));
  }
}

/// In the order of NoiseKind.
constexpr std::array<std::string_view, 4> kinds{"fbm", "turbulence", "marble", "wood"};

constexpr std::array noise_fields{
    Field<NoiseDraft>{"octaves", read_octaves},
    Field<NoiseDraft>{"low", [](const Value& v, NoiseDraft& d) { d.low = v.colour(); }},
    Field<NoiseDraft>{"high", [](const Value& v, NoiseDraft& d) { d.high = v.colour(); }},
    Field<NoiseDraft>{"ramp", read_ramp},
    Field<NoiseDraft>{"seed", read_seed},
    Field<NoiseDraft>{"kind",
                      [](const Value& v, NoiseDraft& d) {
                        d.texture.kind = static_cast<NoiseKind>(chosen(v, kinds));
                      }},
    Field<NoiseDraft>{"on", [](const Value& v, NoiseDraft& d) { d.slot = slot_of(v); }},
    Field<NoiseDraft>{"add", [](const Value& v, NoiseDraft& d) { d.add = v.boolean(); }},
    // After `on`, which says whether there is one.
    Field<NoiseDraft>{"strength",
                      [](const Value& v, NoiseDraft& d) { d.strength = strength_of(v, d.slot); }},
};

/// Perlin's own permutation, shared by all that give no seed.
const std::shared_ptr<const Noise>& plain_noise() {
  static const auto noise = std::make_shared<const Noise>();
  return noise;
}

/// What `add` adds to: the node's present bump, or null.
std::shared_ptr<const TextureSet::Entry> layers_below(const Call& call, const NoiseDraft& draft) {
  if (!draft.add) {
    return nullptr;
  }
  if (draft.slot != TextureSlot::bump) {
    call.fail("only bumps add up; 'add' needs on = \"bump\"");
  }
  const Node& node = *call.self();
  if (!node.textures || !(*node.textures)[TextureSlot::bump].texture) {
    return nullptr;
  }
  // A chain is walked at every hit, and freed link by link.
  constexpr int most = 64;
  int count = 0;
  const TextureSet::Entry& top = (*node.textures)[TextureSlot::bump];
  for (const TextureSet::Entry* e = &top; e != nullptr; e = e->under.get()) {
    if (++count >= most) {
      call.fail(fmt::format("a node has at most {} bumps", most));
    }
  }
  return make_charged(call.L, TextureSet::Entry(top));
}

}  // namespace

int node_set_texture(Call& call) {
  const Value first = call.argument(1, "texture");
  std::shared_ptr<const Texture> texture = first.type() == LUA_TSTRING
                                               ? picture_texture(call, first.text(""))
                                               : first.object<const Texture>();
  const TextureSlot slot = slot_of(call.argument(2, "slot"));
  const double strength = strength_of(call.argument(3, "strength"), slot);
  require_fitting(call, *texture, slot);
  set_slot(call, slot, {std::move(texture), strength, nullptr});
  return call.return_self();
}

int node_perlin_noise(Call& call) {
  NoiseDraft draft;
  draft.texture.octaves = {{1.0, 1.0}, {2.0, 0.5}, {4.0, 0.25}, {8.0, 0.125}};
  draft.texture.noise = plain_noise();
  const Value fields = call.argument(1);
  if (fields.given()) {
    if (fields.type() != LUA_TTABLE) {
      fields.fail("a table {octaves = ..., low = colour, high = colour}");
    }
    read_only_fields<NoiseDraft>(call, fields.index(), "", noise_fields, draft);
  }
  if (draft.has_ramp && (draft.low || draft.high)) {
    call.fail("give 'low' and 'high', or 'ramp', not both");
  }
  if (!draft.has_ramp) {
    draft.texture.ramp = {{0.0, draft.low.value_or(Rgb(0.0))},
                          {1.0, draft.high.value_or(Rgb(1.0))}};
  }
  const std::size_t beside = draft.texture.octaves.size() * sizeof(Octave) +
                             draft.texture.ramp.size() * sizeof(RampStop) + sizeof(Noise);
  std::shared_ptr<const Texture> texture =
      make_charged(call.L, Texture(std::move(draft.texture)), beside);
  require_fitting(call, *texture, draft.slot);
  set_slot(call, draft.slot, {std::move(texture), draft.strength, layers_below(call, draft)});
  return call.return_self();
}

}  // namespace rt::lua
