#include "rt/render/packet/packet_tracer.h"

#include "rt/math/wide_functions.h"
#include "rt/render/medium.h"
#include "rt/render/packet/packet_query.h"
#include "rt/render/surface_texture.h"
#include "rt/render/tracer.h"

namespace rt {
namespace {

Wide largest(const Wide3& c) { return max(max(c.x, c.y), c.z); }

Wide3 mirrored(const WideShadingPoint& point, const Wide3& direction) {
  const Wide3 r = reflect(direction, point.shading_normal);
  return select(dot(r, point.normal) > 0.0, r, reflect(direction, point.normal));
}

struct WideLook {
  Wide3 kd, ks;
  Wide opacity;
};

}  // namespace

/// Points of one instance where paths go on, and how.
struct PacketTracer::Scatter {
  const Path& path;
  const WideShadingPoint& point;
  const PlannedMaterial& material;
  const WideLook& look;
  unsigned bits;
  Wide n1{1.0}, n2{1.0};
  bool divided = false;
  bool chosen = false;

  const Wide3& direction() const { return path.packet.ray.direction; }
};

bool PacketTracer::serves(const RenderPlan& plan) {
  return lanes > 1 && !plan.moves && !plan.absorbs && !plan.footprints;
}

PacketTracer::PacketTracer(const RenderPlan& plan)
    : plan_(plan), negligible_(negligible_branch(plan.options)), shadow_cache_(plan) {}

Wide3 PacketTracer::radiance(const WideRay& camera, unsigned active, const Wide& y,
                             const WideSampler& sampler, RayCounts& counts,
                             const Candidates& sight) {
  sum_ = Wide3(Wide(0.0));
  y_ = y;
  sight_ = sight;
  sampler_ = &sampler;
  counts_ = &counts;
  counts.camera += static_cast<unsigned>(std::popcount(active));
  follow({{{camera.origin, camera.direction * (1.0 / length(camera.direction))}, active},
          Wide3(Wide(1.0)),
          {},
          0});
  while (!open_.empty()) {
    const Path path = open_.back();
    open_.pop_back();
    follow(path);
  }
  return sum_;
}

void PacketTracer::follow(const Path& path) {
  const PacketHits hits = path.depth == 0 && sight_.known
                              ? closest_hits_among(plan_, sight_.instances, path.packet)
                              : closest_hits(plan_, path.packet);
  unsigned missed = 0;
  for (unsigned rest = path.packet.active; rest != 0;) {
    const std::uint32_t instance = hits.instance[static_cast<std::size_t>(std::countr_zero(rest))];
    unsigned same = 0;
    each_lane(rest, [&](int i) {
      const bool one = hits.instance[static_cast<std::size_t>(i)] == instance;
      same |= static_cast<unsigned>(one) << i;
    });
    rest &= ~same;
    if (instance == no_instance) {
      missed = same;
    } else {
      shade(path, hits, instance, same);
    }
  }
  if (missed != 0) {
    const Background& b = plan_.options.background;
    const Wide3 sky = Wide3(b.top) * (1.0 - y_) + Wide3(b.bottom) * y_;
    sum_ = select(mask_of(missed), sum_ + path.throughput * sky, sum_);
  }
}

void PacketTracer::shade(const Path& path, const PacketHits& hits, std::uint32_t id,
                         unsigned bits) {
  WideShadingPoint point = shading_points(plan_, path.packet, hits, id, bits);
  const PlannedInstance& instance = plan_.instances[id];
  const PlannedMaterial& material = plan_.materials[instance.material];
  WideLook look{material.plain.kd, material.plain.ks, material.plain.opacity};
  if (material.textures) {
    each_lane(bits, [&](int i) {
      ShadingPoint one = point.lane(i);
      const Reflectances r =
          textured(plan_, path.packet.lane(i), hits.lane(i), material, nullptr, one);
      point.set(i, one);
      look.kd.set(i, r.kd);
      look.ks.set(i, r.ks);
      look.opacity[static_cast<std::size_t>(i)] = r.opacity;
    });
  }
  Scatter at{path, point, material, look, bits};
  const bool deepest = path.depth >= plan_.options.max_depth;
  if (material.transmissive) {
    const unsigned displaced = find_media(at);
    if (displaced != 0 && !deepest) {
      add(at, displaced, at.direction(), path.throughput, false);
    }
    at.bits &= ~displaced;
  }
  if (at.bits == 0) {
    return;
  }
  sum_ = select(mask_of(at.bits), sum_ + path.throughput * surface(at), sum_);
  if (!deepest) {
    scatter(at);
  }
}

/// The indices before and behind the surface; the lanes where another medium displaces the
/// instance's own.
unsigned PacketTracer::find_media(Scatter& at) {
  const std::uint32_t id = at.point.instance;
  const std::span<const std::uint32_t> candidates = plan_.media_about(id);
  if (candidates.size() == 1 && candidates[0] == id) {
    // The usual case: nothing transmissive is near but the solid itself.
    const WideMask from_outside = mask_of(at.point.from_outside);
    at.n1 = select(from_outside, Wide(1.0), Wide(at.material.ior));
    at.n2 = select(from_outside, Wide(at.material.ior), Wide(1.0));
    return 0;
  }
  unsigned displaced = 0;
  each_lane(at.bits, [&](int i) {
    const auto l = static_cast<std::size_t>(i);
    const Media media = media_about(plan_, at.point.lane(i), at.direction().lane(i));
    displaced |= static_cast<unsigned>(hides(plan_, media, id)) << i;
    at.n1[l] = index_of(plan_, media.before);
    at.n2[l] = index_of(plan_, media.behind);
  });
  return displaced;
}

Wide3 PacketTracer::surface(const Scatter& at) {
  const WidePhong phong{at.look.kd * at.look.opacity, at.look.ks, at.material.shininess,
                        at.material.least_r_dot_v};
  const Wide negligible =
      negligible_light(plan_.options, plan_.lights.size()) / largest(at.path.throughput);
  Wide3 sum = Wide3(at.material.emission) + phong.kd * Wide3(plan_.ambient);
  const Wide cells = shadow_cache_.cells_of(at.point.position);
  const auto lights = static_cast<std::uint32_t>(plan_.lights.size());
  for (std::uint32_t i = 0; i < lights; ++i) {
    const Vertex vertex{at.path.vertex.order, at.path.vertex.copy * lights + i};
    sum += direct_light(plan_, i, phong, at.point, at.bits, cells, -at.direction(), *sampler_,
                        vertex, negligible, shadow_cache_, *counts_);
  }
  return sum;
}

void PacketTracer::scatter(Scatter& at) {
  if (!at.material.transmissive) {
    if (plan_.options.reflection) {
      reflect(at, at.bits, at.path.throughput * Wide3(at.material.reflectivity));
    }
    return;
  }
  const Wide cos_i = min(Wide(1.0), abs(dot(at.direction(), at.point.shading_normal)));
  const Wide f = fresnel(cos_i, at.n1, at.n2);
  divide(at, plan_.options.reflection ? f : Wide(0.0), (1.0 - at.look.opacity) * (1.0 - f));
}

void PacketTracer::divide(Scatter& at, const Wide& reflected, const Wide& transmitted) {
  const Wide3& throughput = at.path.throughput;
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
      const double u = sampler_->lane(i).lobe_choice(at.path.vertex);
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
  Wide3 direction = mirrored(at.point, at.direction());
  if (!at.material.lobe) {
    add(at, bits, direction, throughput, false);
    return;
  }
  Wide3 weighted = throughput;
  each_lane(bits, [&](int i) {
    const auto s = at.material.lobe->sample(sampler_->lane(i).lobe(at.path.vertex),
                                            direction.lane(i), at.point.normal.lane(i));
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
  Wide3 ahead = refract(at.direction(), at.point.shading_normal, at.n1, at.n2, through);
  bits &= bits_of(through);
  // On meshes a shading normal may send a ray back out; then the geometric one decides.
  if (const unsigned back = bits & ~bits_of(dot(ahead, at.point.normal) < 0.0)) {
    WideMask geometric;
    const Wide3 straight = refract(at.direction(), at.point.normal, at.n1, at.n2, geometric);
    ahead = select(mask_of(back), select(geometric, straight, at.direction()), ahead);
  }
  if (bits == 0) {
    return;
  }
  if (!at.material.lobe) {
    add(at, bits, ahead, throughput, false);
    return;
  }
  Wide3 weighted = throughput;
  each_lane(bits, [&](int i) {
    const auto s = at.material.lobe->sample(sampler_->lane(i).lobe(at.path.vertex), ahead.lane(i),
                                            -at.point.normal.lane(i));
    ahead.set(i, s.direction);
    weighted.set(i, throughput.lane(i) * s.weight);
  });
  add(at, bits, ahead, weighted, true);
}

void PacketTracer::add(const Scatter& at, unsigned bits, const Wide3& direction,
                       const Wide3& throughput, bool drawn) {
  const unsigned outward = bits_of(dot(direction, at.point.normal) > 0.0);
  const Wide weight = largest(throughput);
  const unsigned faint = bits_of(weight < negligible_);
  for (const bool out : {true, false}) {
    const unsigned here = bits & (out ? outward : ~outward);
    if (here == 0) {
      continue;
    }
    Vertex vertex = at.path.vertex;
    if (at.divided) {
      vertex.copy = 2 * vertex.copy + (out ? 2 : 1);
    }
    if (drawn || at.chosen) {
      ++vertex.order;
    }
    push(at, here & ~faint, direction, throughput, vertex, out);
    if (plan_.random && (here & faint) != 0) {  // roulette
      unsigned survive = 0;
      each_lane(here & faint, [&](int i) {
        const bool dies = sampler_->lane(i).lobe_choice(vertex) * negligible_ >=
                          weight[static_cast<std::size_t>(i)];
        survive |= static_cast<unsigned>(!dies) << i;
      });
      push(at, survive, direction, throughput * (negligible_ / weight),
           {vertex.order + 1, vertex.copy}, out);
    }
  }
}

void PacketTracer::push(const Scatter& at, unsigned bits, const Wide3& direction,
                        const Wide3& throughput, const Vertex& vertex, bool outward) {
  if (bits == 0) {
    return;
  }
  (outward ? counts_->reflection : counts_->refraction) +=
      static_cast<unsigned>(std::popcount(bits));
  open_.push_back({leave(at.point, direction, bits), throughput, vertex, at.path.depth + 1});
}

}  // namespace rt
