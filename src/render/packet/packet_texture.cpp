#include "rt/render/packet/packet_texture.h"

#include <algorithm>

#include "rt/render/surface_texture.h"
#include "rt/scene/wide_texture.h"
#include "wide_maps.h"

namespace rt {
namespace {

/// Whether all textures are checkers that drive colours: what is looked up for all lanes at once.
bool only_checkers(const TextureSet& textures) {
  return std::ranges::all_of(textures.entries, [&](const TextureSet::Entry& entry) {
    return !entry.texture || (std::holds_alternative<Checker>(*entry.texture) &&
                              &entry != &textures[TextureSlot::bump] &&
                              &entry != &textures[TextureSlot::normal]);
  });
}

Wide grey(const Wide3& c) { return 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z; }

template <class S, class Map>
WideReflectances checkered(const S& shape, const Map& map, const Packet& packet,
                           const PacketHits& hits, const TextureSet& textures,
                           const Reflectances& plain, const WideRayDifferential* here) {
  const Wide3 p = surface_point(shape, model_rays(map, packet.ray), hits.t, hits.feature).position;
  Wide3 width{Wide(0.0)};
  if (here != nullptr) {
    const Wide3 dx = model_vectors(map, here->dp_dx);
    const Wide3 dy = model_vectors(map, here->dp_dy);
    width = {abs(dx.x) + abs(dy.x), abs(dx.y) + abs(dy.y), abs(dx.z) + abs(dy.z)};
  }
  const auto value = [&](TextureSlot slot, const Wide3& otherwise) {
    const auto& texture = textures[slot].texture;
    return texture ? colour(std::get<Checker>(*texture), p, width) : otherwise;
  };
  WideReflectances out{value(TextureSlot::kd, plain.kd), value(TextureSlot::ks, plain.ks),
                       plain.opacity};
  if (const auto& texture = textures[TextureSlot::opacity].texture) {
    out.opacity = min(max(grey(colour(std::get<Checker>(*texture), p, width)), Wide(0.0)), Wide(1.0));
  }
  return out;
}

WideReflectances one_by_one(const RenderPlan& plan, const Packet& packet, const PacketHits& hits,
                            const PlannedMaterial& material, unsigned bits,
                            const WideRayDifferential* here, WideShadingPoint& point) {
  WideReflectances out;
  each_lane(bits, [&](int i) {
    ShadingPoint one = point.lane(i);
    const RayDifferential spread = here != nullptr ? lane_of(*here, i) : RayDifferential{};
    const Reflectances r = textured(plan, packet.lane(i), hits.lane(i), material,
                                    here != nullptr ? &spread : nullptr, one);
    point.shading_normal.set(i, one.shading_normal);
    out.kd.set(i, r.kd);
    out.ks.set(i, r.ks);
    out.opacity[static_cast<std::size_t>(i)] = r.opacity;
  });
  return out;
}

}  // namespace

WideReflectances textured(const RenderPlan& plan, const Packet& packet, const PacketHits& hits,
                          std::uint32_t id, unsigned bits, const WideRayDifferential* here,
                          WideShadingPoint& point) {
  const PlannedInstance& instance = plan.instances[id];
  const PlannedMaterial& material = plan.material_of(instance);
  return plan.visit(instance, [&](const auto& shape) -> WideReflectances {
    if constexpr (WideShape<std::decay_t<decltype(shape)>>) {
      if (!instance.moves() && only_checkers(*material.textures)) {
        return plan.map(instance, 0.0, [&](const auto& map) {
          return checkered(shape, map, packet, hits, *material.textures, plan.plain(instance),
                           here);
        });
      }
    }
    return one_by_one(plan, packet, hits, material, bits, here, point);
  });
}

}  // namespace rt
