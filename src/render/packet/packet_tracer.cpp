#include "rt/render/packet/packet_tracer.h"

#include "rt/math/wide_functions.h"
#include "rt/render/packet/packet_query.h"
#include "rt/render/packet/packet_texture.h"
#include "rt/render/tracer.h"

namespace rt {
namespace {

Wide largest(const Wide3& c) { return max(max(c.x, c.y), c.z); }

Wide3 mirrored(const WideShadingPoint& point, const Wide3& direction) {
  const Wide3 r = reflect(direction, point.shading_normal);
  return select(dot(r, point.normal) > 0.0, r, reflect(direction, point.normal));
}

/// What the surfaces in the lanes are made of; textures resolved.
struct WideLook {
  Wide3 kd, ks;
  Wide opacity;
  Wide shininess, least_r_dot_v;
  Wide3 emission, reflectivity;

  WideLook(const RenderPlan& plan, const PlannedInstance& instance)
      : WideLook(plan.coats[instance.coat].kd(), plan.material_of(instance)) {}
  WideLook(const Rgb& diffuse, const PlannedMaterial& m)
      : kd(diffuse),
        ks(m.ks),
        opacity(m.opacity),
        shininess(m.shininess),
        least_r_dot_v(m.least_r_dot_v),
        emission(m.emission),
        reflectivity(m.reflectivity) {}

  void take(const WideLook& other, unsigned bits) {
    const WideMask mask = mask_of(bits);
    kd = select(mask, other.kd, kd);
    ks = select(mask, other.ks, ks);
    opacity = select(mask, other.opacity, opacity);
    shininess = select(mask, other.shininess, shininess);
    least_r_dot_v = select(mask, other.least_r_dot_v, least_r_dot_v);
    emission = select(mask, other.emission, emission);
    reflectivity = select(mask, other.reflectivity, reflectivity);
  }
};

}  // namespace

/// The points that paths have come to.
struct PacketTracer::Surfaces {
  const Path& path;
  WideShadingPoint point;
  WideLook look;
  WideMedia media;

  const Wide3& direction() const { return path.packet.ray.direction; }
};

/// Where paths go on, and how: from surfaces of one material, or any that only mirror perfectly.
struct PacketTracer::Scatter {
  const Surfaces& from;
  const PowerCosineLobe* lobe;  ///< null: none
  unsigned bits;
  bool divided = false;
  bool chosen = false;
};

PacketTracer::PacketTracer(const RenderPlan& plan)
    : plan_(plan), negligible_(negligible_branch(plan.options)), shadow_cache_(plan) {
  if (plan.footprints) {
    footprints_.emplace(plan);
  }
}

Wide3 PacketTracer::radiance(const WideRay& camera, unsigned active, const Wide* time,
                             const Wide& y, const WideSampler& sampler, RayCounts& counts,
                             const Candidates& sight) {
  sum_ = Wide3(Wide(0.0));
  y_ = y;
  sight_ = sight;
  sampler_ = &sampler;
  counts_ = &counts;
  counts.camera += static_cast<unsigned>(std::popcount(active));
  if (footprints_) {
    footprints_->begin(camera, active, time);
  }
  Path first;  // filled piece by piece: as an aggregate GCC clears all of it before
  first.packet.ray.origin = camera.origin;
  first.packet.ray.direction = camera.direction * (1.0 / length(camera.direction));
  first.packet.active = active;
  first.packet.time = time;
  first.throughput = Wide3(Wide(1.0));
  first.vertex = {};
  first.depth = 0;
  follow(first);
  while (!open_.empty()) {
    Path path = open_.back();
    open_.pop_back();
    follow(path);
  }
  return sum_;
}

void PacketTracer::follow(Path& path) {
  const PacketHits hits = path.depth == 0 && sight_.known
                              ? closest_hits_among(plan_, sight_.instances, path.packet)
                              : closest_hits(plan_, path.packet);
  const unsigned missed = lanes_where(hits.instance, no_instance) & path.packet.active;
  if (missed != path.packet.active) {
    shade(path, hits, path.packet.active & ~missed);
  }
  if (missed != 0) {
    miss(path, missed);
  }
}

void PacketTracer::miss(Path& path, unsigned bits) {
  if (plan_.absorbs) {
    absorb_beyond(plan_, path.packet, bits, path.throughput);
  }
  const Background& b = plan_.options.background;
  const Wide3 sky = Wide3(b.top) * (1.0 - y_) + Wide3(b.bottom) * y_;
  sum_ = select(mask_of(bits), sum_ + path.throughput * sky, sum_);
}

void PacketTracer::shade(Path& path, const PacketHits& hits, unsigned bits) {
  const std::uint32_t first = hits.instance[static_cast<std::size_t>(std::countr_zero(bits))];
  Surfaces at{path, shading_points(plan_, path.packet, hits, bits),
              WideLook(plan_, plan_.instances[first])};
  if (footprints_) {
    footprints_->arrive(open_.size(), at.direction(), hits.t, at.point);
  }
  unsigned displaced = 0;
  unsigned mirrors = 0;
  each_instance(hits.instance, bits, [&](std::uint32_t id, unsigned same) {
    const PlannedInstance& instance = plan_.instances[id];
    const PlannedMaterial& material = plan_.material_of(instance);
    if (id != first) {
      at.look.take(WideLook(plan_, instance), same);
    }
    if (material.textures) {
      resolve_textures(at, hits, id, same);
    }
    if (material.transmissive) {
      displaced |= find_media(plan_, id, at.point, at.direction(), same, at.media);
    } else {
      mirrors |= material.lobe ? 0 : same;
      if (plan_.absorbs) {
        find_medium_before(plan_, id, at.point, at.direction(), same, at.media);
      }
    }
  });
  if (plan_.absorbs) {
    absorb(plan_, at.media, hits.t, bits, path.throughput);
  }
  const bool deepest = path.depth >= plan_.options.max_depth;
  if (displaced != 0 && !deepest) {
    const Scatter through{at, nullptr, displaced};
    add(through, displaced, at.direction(), path.throughput, false);
  }
  bits &= ~displaced;
  if (bits == 0) {
    return;
  }
  sum_ = select(mask_of(bits), sum_ + path.throughput * surface(at, bits), sum_);
  if (deepest) {
    return;
  }
  if (mirrors != 0 && plan_.options.reflection) {
    reflect({at, nullptr, mirrors}, mirrors, path.throughput * at.look.reflectivity);
  }
  each_instance(hits.instance, bits & ~mirrors, [&](std::uint32_t id, unsigned same) {
    const PlannedMaterial& material = plan_.material_of(plan_.instances[id]);
    Scatter one{at, material.lobe ? &*material.lobe : nullptr, same};
    if (material.transmissive) {
      scatter_glass(one);
    } else if (plan_.options.reflection) {
      reflect(one, same, path.throughput * at.look.reflectivity);
    }
  });
}

void PacketTracer::resolve_textures(Surfaces& at, const PacketHits& hits, std::uint32_t id,
                                    unsigned bits) {
  const WideReflectances r = textured(plan_, at.path.packet, hits, id, bits,
                                      footprints_ ? &footprints_->here() : nullptr, at.point);
  const WideMask mask = mask_of(bits);
  at.look.kd = select(mask, r.kd, at.look.kd);
  at.look.ks = select(mask, r.ks, at.look.ks);
  at.look.opacity = select(mask, r.opacity, at.look.opacity);
}

Wide3 PacketTracer::surface(const Surfaces& at, unsigned bits) {
  const WidePhong phong{at.look.kd * at.look.opacity, at.look.ks, at.look.shininess,
                        at.look.least_r_dot_v};
  const Wide negligible =
      negligible_light(plan_.options, plan_.lights.size()) / largest(at.path.throughput);
  Wide3 sum = at.look.emission + phong.kd * Wide3(plan_.ambient);
  const Wide cells = shadow_cache_.cells_of(at.point.position);
  const auto lights = static_cast<std::uint32_t>(plan_.lights.size());
  for (std::uint32_t i = 0; i < lights; ++i) {
    const Vertex vertex{at.path.vertex.order, at.path.vertex.copy * lights + i};
    sum += direct_light(plan_, i, phong, at.point, bits, cells, -at.direction(), *sampler_, vertex,
                        negligible, shadow_cache_, *counts_);
  }
  return sum;
}

void PacketTracer::scatter_glass(Scatter& at) {
  const Surfaces& from = at.from;
  const Wide cos_i = min(Wide(1.0), abs(dot(from.direction(), from.point.shading_normal)));
  const Wide f = fresnel(cos_i, from.media.n1, from.media.n2);
  divide(at, plan_.options.reflection ? f : Wide(0.0), (1.0 - from.look.opacity) * (1.0 - f));
}

void PacketTracer::divide(Scatter& at, const Wide& reflected, const Wide& transmitted) {
  const Wide3& throughput = at.from.path.throughput;
  const Wide total = reflected + transmitted;
  const Wide p = select(total > 0.0, reflected / total, Wide(0.0));
  unsigned both = at.bits;
  if (plan_.random) {
    const Wide deviation = largest(throughput) * total * sqrt(p * (1.0 - p));
    both &= bits_of(deviation > accepted_deviation || p == 0.0 || p == 1.0);
  }
  const unsigned two = both & bits_of(reflected > 0.0 && transmitted > 0.0);
  for (const unsigned bits : {two, both & ~two}) {
    if (bits != 0) {
      at.divided = bits == two;
      transmit(at, bits, throughput * transmitted);
      reflect(at, bits, throughput * reflected);
    }
  }
  at.divided = false;
  if (const unsigned one = at.bits & ~both) {
    at.chosen = true;
    unsigned mirror = 0;
    each_lane(one, [&](int i) {
      const double u = sampler_->lane(i).lobe_choice(at.from.path.vertex);
      mirror |= static_cast<unsigned>(u < p[static_cast<std::size_t>(i)]) << i;
    });
    reflect(at, mirror, throughput * total);
    transmit(at, one & ~mirror, throughput * total);
  }
}

void PacketTracer::reflect(const Scatter& at, unsigned bits, const Wide3& throughput) {
  bits &= bits_of(largest(throughput) > 0.0);
  if (bits == 0) {
    return;
  }
  Wide3 direction = mirrored(at.from.point, at.from.direction());
  if (at.lobe == nullptr) {
    add(at, bits, direction, throughput, false);
    return;
  }
  Wide3 weighted = throughput;
  each_lane(bits, [&](int i) {
    const auto s = at.lobe->sample(sampler_->lane(i).lobe(at.from.path.vertex),
                                            direction.lane(i), at.from.point.normal.lane(i));
    direction.set(i, s.direction);
    weighted.set(i, throughput.lane(i) * s.weight);
  });
  add(at, bits, direction, weighted, true);
}

void PacketTracer::transmit(const Scatter& at, unsigned bits, const Wide3& throughput) {
  bits &= bits_of(largest(throughput) > 0.0);
  if (bits == 0) {
    return;
  }
  WideMask through;
  const WideMedia& media = at.from.media;
  Wide3 ahead = refract(at.from.direction(), at.from.point.shading_normal, media.n1, media.n2,
                        through);
  bits &= bits_of(through);
  // On meshes a shading normal may send a ray back out; then the geometric one decides.
  if (const unsigned back = bits & ~bits_of(dot(ahead, at.from.point.normal) < 0.0)) {
    WideMask geometric;
    const Wide3 straight =
        refract(at.from.direction(), at.from.point.normal, media.n1, media.n2, geometric);
    ahead = select(mask_of(back), select(geometric, straight, at.from.direction()), ahead);
  }
  if (bits == 0) {
    return;
  }
  if (at.lobe == nullptr) {
    add(at, bits, ahead, throughput, false);
    return;
  }
  Wide3 weighted = throughput;
  each_lane(bits, [&](int i) {
    const auto s = at.lobe->sample(sampler_->lane(i).lobe(at.from.path.vertex), ahead.lane(i),
                                            -at.from.point.normal.lane(i));
    ahead.set(i, s.direction);
    weighted.set(i, throughput.lane(i) * s.weight);
  });
  add(at, bits, ahead, weighted, true);
}

void PacketTracer::add(const Scatter& at, unsigned bits, const Wide3& direction,
                       const Wide3& throughput, bool drawn) {
  const unsigned outward = bits_of(dot(direction, at.from.point.normal) > 0.0);
  const Wide weight = largest(throughput);
  const unsigned faint = bits_of(weight < negligible_);
  for (const bool out : {true, false}) {
    const unsigned here = bits & (out ? outward : ~outward);
    if (here == 0) {
      continue;
    }
    Vertex vertex = at.from.path.vertex;
    if (at.divided) {
      vertex.copy = 2 * vertex.copy + (out ? 2 : 1);
    }
    if (drawn || at.chosen) {
      ++vertex.order;
    }
    push(at, here & ~faint, direction, throughput, vertex, out, drawn);
    if (plan_.random && (here & faint) != 0) {  // roulette
      unsigned survive = 0;
      each_lane(here & faint, [&](int i) {
        const bool dies = sampler_->lane(i).lobe_choice(vertex) * negligible_ >=
                          weight[static_cast<std::size_t>(i)];
        survive |= static_cast<unsigned>(!dies) << i;
      });
      push(at, survive, direction, throughput * (negligible_ / weight),
           {vertex.order + 1, vertex.copy}, out, drawn);
    }
  }
}

void PacketTracer::push(const Scatter& at, unsigned bits, const Wide3& direction,
                        const Wide3& throughput, const Vertex& vertex, bool outward, bool drawn) {
  if (bits == 0) {
    return;
  }
  (outward ? counts_->reflection : counts_->refraction) +=
      static_cast<unsigned>(std::popcount(bits));
  if (footprints_) {
    footprints_->branch(at.from.point, bits, at.from.direction(), direction, outward,
                        at.from.media.n1 / at.from.media.n2, drawn ? at.lobe : nullptr);
  }
  open_.push_back({leave(at.from.point, direction, bits), throughput, vertex, at.from.path.depth + 1});
}

}  // namespace rt
