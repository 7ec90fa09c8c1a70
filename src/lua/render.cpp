/// gr.render: its arguments become a RenderJob.
#include <fmt/format.h>

#include <stdexcept>

#include "describe.h"
#include "fields.h"
#include "functions.h"
#include "rt/scene/render_job.h"

namespace rt::lua {
namespace {

constexpr int largest_size = 65'536;
constexpr std::string_view size_words = "a whole number of pixels from 1 to 65536";

struct Draft {
  std::shared_ptr<Node> scene;
  RenderJob job;
  bool has_view = false;
  std::optional<Vec3> look_at;
};

void read_file_name(const Value& value, Draft& draft) {
  const std::string name = value.text("a file name (string)");
  if (name.empty() || name.find('\0') != std::string::npos) {
    value.fail("a file name (string)");
  }
  draft.job.output = name;
}

void read_lights(const Value& value, Draft& draft) {
  constexpr std::string_view expected = "a list of lights {l1, l2}";
  if (value.type() != LUA_TTABLE) {
    value.fail(expected);
  }
  const Call& call = value.call();
  lua_State* L = call.L;
  Charge cost(call.run().memory);  // light by light: one may stand in the list a million times
  const auto size = static_cast<lua_Integer>(lua_rawlen(L, value.index()));
  for (lua_Integer i = 1; i <= size; ++i) {
    lua_rawgeti(L, value.index(), i);
    const auto light = held<const Light>(L, -1);
    if (!light) {
      value.fail(expected, fmt::format("a table whose item {} is {}", i, describe(L, -1)));
    }
    charge(L, cost, 2 * sizeof(Light) + light->where.size());  // twice: while the list grows
    draft.job.lights.push_back(*light);
    lua_pop(L, 1);
  }
  lua_pushnil(L);
  while (lua_next(L, value.index()) != 0) {
    lua_pop(L, 1);
    if (lua_isinteger(L, -1) == 0 || lua_tointeger(L, -1) < 1 || lua_tointeger(L, -1) > size) {
      value.fail(expected, fmt::format("a table with the key {}", describe(L, -1)));
    }
  }
}

constexpr Field<Draft> scene{"scene", [](const Value& v, Draft& d) { d.scene = v.object<Node>(); },
                             "", true};
constexpr Field<Draft> file{"file", read_file_name, "", true};
constexpr Field<Draft> width{"width", [](const Value& v, Draft& d) {
                               d.job.options.width = v.whole(1, largest_size, size_words);
                             }};
constexpr Field<Draft> height{"height", [](const Value& v, Draft& d) {
                                d.job.options.height = v.whole(1, largest_size, size_words);
                              }};
constexpr Field<Draft> eye{"eye", [](const Value& v, Draft& d) { d.job.camera.eye = v.triple(); },
                           "", true};
constexpr Field<Draft> view{"view", [](const Value& v, Draft& d) {
                              d.job.camera.view = v.triple();
                              d.has_view = true;
                            }};
constexpr Field<Draft> look_at{"look_at", [](const Value& v, Draft& d) { d.look_at = v.triple(); }};
constexpr Field<Draft> up{"up", [](const Value& v, Draft& d) { d.job.camera.up = v.triple(); }};
constexpr Field<Draft> fov{"fov", [](const Value& v, Draft& d) { d.job.camera.fov = v.number(); }};
constexpr Field<Draft> ambient{"ambient",
                               [](const Value& v, Draft& d) { d.job.ambient = v.colour(); }};
constexpr Field<Draft> lights{"lights", read_lights};

constexpr Field<Draft> optional(Field<Draft> field) {
  field.required = false;
  return field;
}

void read_size(const Value& value, Draft& draft) {
  constexpr std::string_view expected = "two whole numbers {width, height} from 1 to 65536";
  lua_State* L = value.call().L;
  if (value.type() != LUA_TTABLE || lua_rawlen(L, value.index()) != 2) {
    value.fail(expected);
  }
  const auto item = [&](int i) {
    lua_rawgeti(L, value.index(), i);
    const int result = Value(value.call(), lua_gettop(L), "size", i == 1 ? "width" : "height")
                           .whole(1, largest_size, size_words);
    lua_pop(L, 1);
    return result;
  };
  draft.job.options.width = item(1);
  draft.job.options.height = item(2);
}

/// Turns the camera, which messages call `table`, to the point that it looks at, if it does.
void aim(const Call& call, std::string_view table, Draft& draft) {
  if (draft.has_view && draft.look_at) {
    call.fail(fmt::format("{} has both 'view' and 'look_at'; give one", table));
  }
  if (draft.look_at) {
    draft.job.camera.view = *draft.look_at - draft.job.camera.eye;
    if (draft.job.camera.view == Vec3(0.0)) {
      call.fail(fmt::format("{} looks at its own 'eye'; 'look_at' must be another point", table));
    }
  }
}

/// Where the camera is at time 1; what is not given stays, the point that it looks at too.
void read_camera_end(const Value& value, Draft& draft) {
  static constexpr std::array fields{optional(eye), view, up, fov, look_at};
  if (value.type() != LUA_TTABLE) {
    value.fail("a table {eye = ..., look_at = ...}");
  }
  Draft end;
  end.job.camera = draft.job.camera;
  read_only_fields<Draft>(value.call(), value.index(), "camera.to", fields, end);
  if (!end.has_view && !end.look_at) {
    end.look_at = draft.look_at;
  }
  aim(value.call(), "camera.to", end);
  draft.job.camera.to = std::make_shared<const Camera>(end.job.camera);
}

void read_shutter(const Value& value, Draft& draft) {
  constexpr std::string_view expected = "two times {open, close} with 0 <= open <= close <= 1";
  lua_State* L = value.call().L;
  if (value.type() != LUA_TTABLE || lua_rawlen(L, value.index()) != 2) {
    value.fail(expected);
  }
  RenderOptions& o = draft.job.options;
  for (int i = 1; i <= 2; ++i) {
    lua_rawgeti(L, value.index(), i);
    const Value time(value.call(), lua_gettop(L), "shutter", i == 1 ? "open" : "close");
    (i == 1 ? o.shutter_open : o.shutter_close) = time.number(fraction);
    lua_pop(L, 1);
  }
  if (o.shutter_open > o.shutter_close) {
    value.fail(expected);
  }
}

void read_camera(const Value& value, Draft& draft) {
  static constexpr std::array fields{
      eye,
      view,
      up,
      fov,
      look_at,
      Field<Draft>{"aperture", [](const Value& v,
                                  Draft& d) { d.job.camera.aperture = v.number(not_negative); }},
      Field<Draft>{"focus",
                   [](const Value& v, Draft& d) { d.job.camera.focus = v.number(positive); }},
      Field<Draft>{"to", read_camera_end}};
  if (value.type() != LUA_TTABLE) {
    value.fail("a table {eye = ..., look_at = ...}");
  }
  const Call& call = value.call();
  read_only_fields<Draft>(call, value.index(), "camera", fields, draft);
  if (!draft.has_view && !draft.look_at) {
    call.fail("camera needs 'view' (a direction) or 'look_at' (a point)");
  }
  aim(call, "camera", draft);
}

void read_background(const Value& value, Draft& draft) {
  static constexpr std::array fields{
      Field<Background>{"top", [](const Value& v, Background& b) { b.top = v.colour(); }, "", true},
      Field<Background>{"bottom", [](const Value& v, Background& b) { b.bottom = v.colour(); }, "",
                        true}};
  Background& background = draft.job.options.background;
  if (value.type() == LUA_TTABLE && !value.is_list()) {
    read_only_fields<Background>(value.call(), value.index(), "background", fields, background);
  } else {
    background.top = value.colour();
    background.bottom = background.top;
  }
}

constexpr Field<Draft> background{"background", read_background};
constexpr Field<Draft> shutter{"shutter", read_shutter};
constexpr std::array course_order{scene, file, width, height, eye, view, up, fov, ambient, lights};
constexpr std::array option_fields{background, shutter};
constexpr std::array named_fields{scene,
                                  file,
                                  Field<Draft>{"size", read_size, "", true},
                                  Field<Draft>{"camera", read_camera, "", true},
                                  ambient,
                                  lights,
                                  background,
                                  shutter};

/// The value on top of the stack for an option.
OptionValue option_value(const Value& value) {
  switch (value.type()) {
    case LUA_TBOOLEAN:
      return value.boolean();
    case LUA_TNUMBER:
      return value.number();
    case LUA_TSTRING:
      return value.text("");
    default:
      value.fail("a number, a string, true or false");
  }
}

std::vector<std::string_view> names_with_options(std::span<const Field<Draft>> fields) {
  std::vector<std::string_view> names = names_of(fields);
  for (const OptionSpec& spec : option_specs()) {
    names.push_back(spec.name);
  }
  return names;
}

/// Reads a table of fields and options.
void read_options(const Call& call, int index, std::span<const Field<Draft>> fields, Draft& draft) {
  std::vector<std::string> options;
  std::vector<std::string> unknown;
  for (std::string& key : unknown_keys(call, index, fields)) {
    (find_option(key) != nullptr ? options : unknown).push_back(std::move(key));
  }
  refuse_keys(call, "", unknown, names_with_options(fields));

  read_fields(call, index, "", fields, draft);
  for (const std::string& key : options) {
    push_field(call, index, key, {});
    const Value value(call, lua_gettop(call.L), "", key);
    try {
      find_option(key)->set(draft.job.options, option_value(value));
    } catch (const std::invalid_argument& error) {
      call.fail(fmt::format("option '{}': {}", key, error.what()));
    }
    lua_pop(call.L, 1);
  }
}

/// Argument 11, when it is a table that can hold options. Scripts of the course framework pass
/// other things there.
void read_trailing_options(Call& call, Draft& draft) {
  const Value options = call.argument(11, "options");
  if (options.type() == LUA_TTABLE && !options.is_list()) {
    read_options(call, options.index(), option_fields, draft);
  } else if (options.given()) {
    call.ignore(11);
  }
}

}  // namespace

int render(Call& call) {
  Draft draft;
  const Value first = call.argument(1, "scene");
  if (first.type() == LUA_TTABLE) {
    call.takes_at_most(1);
    read_options(call, first.index(), named_fields, draft);
  } else {
    read_positional<Draft>(call, course_order, course_order.size(), draft);
    read_trailing_options(call, draft);
  }
  check(draft.job.camera);

  Flattened flat = flatten(*draft.scene, call.run().memory->left() / instance_bytes);
  for (const std::string& warning : flat.warnings) {
    warn_once(call.L, warning, warning);
  }
  draft.job.instances = std::move(flat.instances);
  draft.job.where = location(call.L);
  if (call.run().host.render) {
    call.run().rendered = true;
    const Guard::Pause pause(call.run().guard);
    call.run().host.render(std::move(draft.job));
  }
  return 0;
}

}  // namespace rt::lua
