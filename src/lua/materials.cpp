/// gr.material.
#include "fields.h"
#include "functions.h"

namespace rt::lua {
namespace {

/// In the order of the positional form, which takes the first six.
constexpr std::array material_fields{
    Field<Material>{"kd", [](const Value& v, Material& m) { m.kd = v.colour(); }},
    Field<Material>{"ks", [](const Value& v, Material& m) { m.ks = v.colour(); }},
    Field<Material>{"shininess",
                    [](const Value& v, Material& m) { m.shininess = v.number(not_negative); }},
    Field<Material>{"ior", [](const Value& v, Material& m) { m.ior = v.number(positive); }},
    Field<Material>{"opacity", [](const Value& v, Material& m) { m.opacity = v.number(fraction); }},
    Field<Material>{"glossiness",
                    [](const Value& v, Material& m) { m.glossiness = v.number(fraction); }},
    Field<Material>{"reflectivity",
                    [](const Value& v, Material& m) { m.reflectivity = v.colour(); }},
    Field<Material>{"absorption", [](const Value& v, Material& m) { m.absorption = v.colour(); }},
    Field<Material>{"emission", [](const Value& v, Material& m) { m.emission = v.colour(); }},
};

/// Remembers a material of the script itself, not of a palette that it requires, until a node gets
/// it.
void note_unused(const Call& call, const Material* material) {
  constexpr std::size_t most = 1000;
  Context& run = call.run();
  const std::string where = location(call.L);
  if (where.starts_with(run.script + ":") && run.unused_materials.size() < most) {
    run.unused_materials[material] = where;
  }
}

}  // namespace

int make_material(Call& call) {
  const std::span<const Field<Material>> fields = material_fields;
  Material material;
  const Value first = call.argument(1, "kd");
  if (call.count() == 1 && first.type() == LUA_TTABLE && !first.is_list()) {
    read_only_fields(call, first.index(), "", fields, material);
  } else {
    read_positional(call, fields.first(6), 3, material);
  }
  std::shared_ptr<const Material> shared = make_charged(call.L, std::move(material));
  note_unused(call, shared.get());
  push(call.L, std::move(shared));
  return 1;
}

}  // namespace rt::lua
