#include "rt/render/thin.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>

#include "parallel.h"
#include "rt/math/warp.h"
#include "rt/render/accel/box_list.h"
#include "rt/render/accel/box_tree.h"
#include "rt/render/query.h"
#include "rt/render/shading.h"

namespace rt {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

/// A beam's radius in pixels: nearly all of the default filter's mass lies within.
constexpr double beam_pixels = 1.25;
/// What a wire as wide as a pixel covers of the beam's disc.
constexpr double whole = 2.0 / (pi * beam_pixels);
/// Pilots that shall hit what is thin: as many as hit what covers a pixel, and up to 16 the less it
/// is. With 4 the stopping rule, which trusts what it sees, still makes a wire of a
/// tenth of a pixel 7% too bright on black; with 16 most pixels on it need no more than these.
constexpr double fewest_hits = 4.0;
constexpr double most_hits = 16.0;
constexpr int most_pilots = 1024;
/// Things wider than so many pixels are seen by the usual pilots of their neighbourhood.
constexpr double wide = 1.5;
/// Shadows are looked for where pixels are at most so many times as large as at what casts them.
constexpr double farther = 4.0;
/// How much further off than its faces the corners of a square are.
constexpr double corner = std::numbers::sqrt2;
/// An edge of no length is taken for so much of the longest: enough to have an inverse.
constexpr double flat = 1e-9;

/// The least width of a box (half-edges e) as seen in a unit direction. Its outline is spanned by
/// the projected edges; the least width is that across one of them.
double apparent_width(const ThinBox::Edges& e, const Vec3& direction) {
  double least = inf;
  for (const Vec3& along : e) {
    const Vec3 across = glm::cross(along, direction);
    const double length = glm::length(across);
    if (length > 0.0) {
      double sum = 0.0;
      for (const Vec3& edge : e) {
        sum += std::abs(glm::dot(edge, across));
      }
      least = std::min(least, 2.0 * sum / length);
    }
  }
  return least;
}

/// The area of a box as seen in a unit direction.
double apparent_area(const ThinBox::Edges& e, const Vec3& direction) {
  return 4.0 * (std::abs(glm::dot(glm::cross(e[0], e[1]), direction)) +
                std::abs(glm::dot(glm::cross(e[1], e[2]), direction)) +
                std::abs(glm::dot(glm::cross(e[2], e[0]), direction)));
}

/// The share of a disc that a box covers which is narrower than the disc, and perhaps longer.
double covered(const ThinBox::Edges& e, const Vec3& direction, double radius) {
  const double width = apparent_width(e, direction);
  const double length = apparent_area(e, direction) / width;
  return width * std::min(length, 2.0 * radius) / (pi * radius * radius);
}

ThinBox::Edges thickened(ThinBox::Edges e) {
  const double longest = std::max({glm::length(e[0]), glm::length(e[1]), glm::length(e[2])});
  for (std::size_t k = 0; k < 3; ++k) {
    if (glm::length(e[k]) <= flat * longest) {
      const Vec3 n = glm::cross(e[(k + 1) % 3], e[(k + 2) % 3]);
      const double size = glm::length(n);
      e[k] = size > 0.0 ? n * (flat * longest / size) : e[k];
    }
  }
  return e;
}

ThinBox image(const Affine& map, const Bounds& b) {
  const Vec3 half = 0.5 * b.extent();
  return {map.point(b.centre()),
          thickened({half.x * map.linear[0], half.y * map.linear[1], half.z * map.linear[2]})};
}

/// What holds a ring's arc of half-angle `half`, below pi / 2, about the x-axis.
Bounds arc_box(const Torus& ring, double half) {
  const double inner = ring.major_radius * std::cos(half) - ring.minor_radius;
  const double outer = ring.major_radius + ring.minor_radius;
  return {{inner, -ring.minor_radius, -outer * std::sin(half)},
          {outer, ring.minor_radius, outer * std::sin(half)}};
}

/// The arcs of a ring from `first` on, `count` of `all`, in halves: as each_part().
template <class Enter, class Visit>
bool each_arc(const Affine& map, const Torus& ring, int all, int first, int count, Enter& enter,
              Visit& visit) {
  const double half = count * pi / all;
  if (4 * count <= all) {
    const Affine turn = Affine::rotation(1, (2.0 * first + count) * 180.0 / all);
    const ThinBox box = image(map * turn, arc_box(ring, half));
    if (!enter(box)) {
      return true;
    }
    if (count == 1) {
      return visit(box);
    }
  }
  const int left = count / 2;
  return each_arc(map, ring, all, first, left, enter, visit) &&
         each_arc(map, ring, all, first + left, count - left, enter, visit);
}

/// Calls visit(box) -> bool for the boxes that stand for an instance: one, or for a ring one an arc,
/// until that is false. Those outside of a box for which enter(box) is false are left out.
template <class Enter, class Visit>
void each_part(const RenderPlan& plan, const PlannedInstance& instance, Enter&& enter,
               Visit&& visit) {
  const Affine map = plan.placement(instance).render_from_model;
  const Torus* torus = instance.is<Torus>() ? &plan.shapes.of<Torus>()[instance.shape] : nullptr;
  if (torus == nullptr || torus->minor_radius > 0.25 * torus->major_radius) {
    const ThinBox box = image(map, model_box_of(plan, instance));
    if (enter(box)) {
      visit(box);
    }
    return;
  }
  // Arcs so short that they bend by no more than the tube is thick: five or more.
  const double bend = std::acos(1.0 - torus->minor_radius / torus->major_radius);
  const int arcs = std::min(256, static_cast<int>(std::ceil(pi / bend)));
  each_arc(map, *torus, arcs, 0, arcs, enter, visit);
}

/// The size of a pixel at distance 1.
double pixel_size(const RenderPlan& plan) {
  return 2.0 * glm::length(plan.camera.down) / plan.options.height;
}

/// Of a pixel at the box's far end.
double pixel_beyond(const RenderPlan& plan, const ThinBox& box) {
  return pixel_size(plan) * (glm::length(box.centre) + box.reach());
}

bool thin_in_sight(const RenderPlan& plan, const ThinBox& box) {
  const double distance = glm::length(box.centre);
  return distance > 0.0 && apparent_width(box.edges, box.centre / distance) <
                               wide * pixel_beyond(plan, box);
}

bool thin_as_shadow(const RenderPlan& plan, const ThinBox& box) {
  const double width = wide * farther * pixel_beyond(plan, box);
  return std::any_of(plan.lights.begin(), plan.lights.end(), [&](const PlannedLight& light) {
    const Vec3 way = box.centre - light.position;
    const double d = glm::length(way);
    return !light.extended() && d > 0.0 && apparent_width(box.edges, way / d) < width;
  });
}

bool thin_as(ThinKind kind, const RenderPlan& plan, const ThinBox& box) {
  return kind == ThinKind::in_sight ? thin_in_sight(plan, box) : thin_as_shadow(plan, box);
}

std::uint8_t kinds_of(const RenderPlan& plan, const PlannedInstance& instance) {
  constexpr auto both =
      static_cast<unsigned>(ThinKind::in_sight) | static_cast<unsigned>(ThinKind::as_shadow);
  unsigned kinds = 0;
  if (!instance.moves()) {  // what moves is a blur anyway
    const auto look = [&](ThinKind kind, const ThinBox& box) {
      const auto bit = static_cast<unsigned>(kind);
      kinds |= (kinds & bit) == 0 && thin_as(kind, plan, box) ? bit : 0;
    };
    const bool casts = instance.shadow == Shadow::blocks;
    const auto any = [](const ThinBox&) { return true; };
    each_part(plan, instance, any, [&](const ThinBox& box) {
      look(ThinKind::in_sight, box);
      if (casts) {
        look(ThinKind::as_shadow, box);
      }
      return kinds != (casts ? both : static_cast<unsigned>(ThinKind::in_sight));
    });
  }
  return static_cast<std::uint8_t>(kinds);
}

/// Calls visit(instance) -> bool for all whose boxes the beam may meet before t_max, and perhaps
/// others, until that is false.
template <class Boxes, class Visit>
void each_along(const RenderPlan& plan, const Boxes& boxes, const Beam& beam, double t_max,
                Visit&& visit) {
  const BoxSpace& space = boxes.space();
  const double edge = 1.0 / space.per_unit();  // half of the cube's about all boxes
  const Vec3 to_centre = space.centre() - beam.axis.origin;
  const double middle = glm::dot(to_centre, beam.axis.direction);
  if (std::abs(beam.slope) <= 0.125) {
    // A section that meets the cube, |p(t) - centre| <= edge + r(t) along each axis, has
    // |t - middle| <= 3^(1/2) (edge + radius + |t - middle| / 8), below this; so has its distance.
    const double radius = beam.radius_at(std::max(middle, 0.0));
    const double near = 2.5 * (edge + radius);
    const double begin = std::max(0.0, middle - near);
    const double end = std::min(t_max, middle + near);
    if (begin > end ||
        glm::length(to_centre - middle * beam.axis.direction) > near) {
      return;
    }
    // Where it is wider than all together it is no shaft that could be followed.
    if (radius <= edge && boxes.each_in({beam.cube_at(begin), beam.cube_at(end)}, visit)) {
      return;
    }
  }
  for (std::uint32_t id = 0; id < plan.bounded && visit(id); ++id) {
  }
}

/// Shares of a disc are added up in whole numbers of such units: then their order does not matter.
constexpr double unit_share = 0x1p-60;

/// How much of a disc of the beam's radius the thin things that it meets before t_max cover, each as
/// seen along the beam, all together, or `whole` where it is more; 0 when it meets none.
double coverage(const RenderPlan& plan, ThinKind kind, const Beam& beam, double t_max) {
  constexpr auto all = static_cast<std::uint64_t>(whole / unit_share);
  // A box grown by the beam's radius has corners further off.
  const Beam around{beam.axis, corner * beam.radius, corner * beam.slope};
  std::uint64_t sum = 0;
  const auto near = [&](const ThinBox& box) { return around.meets(box.bounds(), t_max); };
  const auto add_part = [&](const ThinBox& box) {
    if (thin_as(kind, plan, box)) {
      sum += static_cast<std::uint64_t>(std::min(whole, box.coverage(beam, t_max)) / unit_share);
    }
    return sum < all;
  };
  const auto add = [&](std::uint32_t id) {
    const PlannedInstance& instance = plan.instances[id];
    // What walks find beyond the boxes that are met differs.
    if (plan.thin->is(kind, id) && around.meets(box_of(plan, instance), t_max)) {
      each_part(plan, instance, near, add_part);
    }
    return sum < all;
  };
  const auto look = [&](const auto& boxes) { each_along(plan, boxes, around, t_max, add); };
  if (plan.tree) {
    look(*plan.tree);
  } else {
    look(plan.list ? *plan.list : *plan.shaft_list);
  }
  return static_cast<double>(std::min(sum, all)) * unit_share;
}

/// What so much of a beam's disc asks for.
int pilots_for(double coverage) {
  const double share = coverage / whole;
  if (!(share > 0.0 && share < 1.0)) {
    return 0;
  }
  const double hits = std::clamp(fewest_hits / share, fewest_hits, most_hits);
  const double wanted = std::min(hits / share, double{most_pilots});
  return 1 << static_cast<int>(std::ceil(std::log2(wanted)));
}

}  // namespace

double Beam::radius_at(double t) const { return std::max(radius + slope * t, 0.0); }

Bounds Beam::cube_at(double t) const {
  const Vec3 centre = axis.origin + t * axis.direction;
  return {centre - radius_at(t), centre + radius_at(t)};
}

bool Beam::meets(const Bounds& box, double t_max) const {
  double t0 = 0.0;
  double t1 = t_max;
  const auto narrow = [&](double p, double q) {  // to where p + q t <= 0
    if (q > 0.0) {
      t1 = std::min(t1, -p / q);
    } else if (q < 0.0) {
      t0 = std::max(t0, -p / q);
    } else if (p > 0.0) {
      t1 = -1.0;
    }
  };
  for (int k = 0; k < 3; ++k) {
    narrow(box.lo[k] - radius - axis.origin[k], -axis.direction[k] - slope);
    narrow(axis.origin[k] - radius - box.hi[k], axis.direction[k] - slope);
  }
  return t0 <= t1;
}

double ThinBox::reach() const {
  return glm::length(edges[0]) + glm::length(edges[1]) + glm::length(edges[2]);
}

Bounds ThinBox::bounds() const {
  const Vec3 half = glm::abs(edges[0]) + glm::abs(edges[1]) + glm::abs(edges[2]);
  return {centre - half, centre + half};
}

double ThinBox::coverage(const Beam& beam, double t_max) const {
  const double volume = glm::dot(edges[0], glm::cross(edges[1], edges[2]));
  if (volume == 0.0) {
    return 0.0;  // flat twice over: nothing to see
  }
  const Vec3 to_centre = centre - beam.axis.origin;
  const double nearest = glm::dot(to_centre, beam.axis.direction);
  // The box grows by the beam's radius at its far end; then the axis meets it or not.
  const double grown = beam.radius_at(nearest + std::copysign(reach(), beam.slope));
  double t0 = 0.0;
  double t1 = t_max;
  for (std::size_t k = 0; k < 3; ++k) {
    // Products with it are coordinates in units of the edge.
    const Vec3 normal = glm::cross(edges[(k + 1) % 3], edges[(k + 2) % 3]) / volume;
    const double o = -glm::dot(to_centre, normal);
    const double d = glm::dot(beam.axis.direction, normal);
    const double half = 1.0 + grown * glm::length(normal);
    const double a = (-half - o) / d;
    const double b = (half - o) / d;
    t0 = std::max(t0, std::min(a, b));
    t1 = std::min(t1, std::max(a, b));
  }
  const double here = t0 <= t1 ? beam.radius_at(0.5 * (t0 + t1)) : 0.0;
  return here > 0.0 ? covered(edges, beam.axis.direction, here) : 0.0;
}

std::unique_ptr<const ThinThings> find_thin(const RenderPlan& plan) {
  auto thin = std::make_unique<ThinThings>();
  thin->kinds.resize(plan.bounded);
  std::atomic<unsigned> any = 0;
  constexpr std::size_t block = 4096;
  for_each_index((plan.bounded + block - 1) / block, [&](std::size_t part) {
    const std::size_t end = std::min<std::size_t>(plan.bounded, (part + 1) * block);
    unsigned found = 0;
    for (std::size_t id = part * block; id < end; ++id) {
      thin->kinds[id] = kinds_of(plan, plan.instances[id]);
      found |= thin->kinds[id];
    }
    any |= found;
  });
  thin->any = any;
  return thin->any != 0 ? std::move(thin) : nullptr;
}

int thin_pilots(const RenderPlan& plan, int x, int y) {
  const Vec3 direction = glm::normalize(
      plan.camera.direction((x + 0.5) / plan.options.width, (y + 0.5) / plan.options.height));
  const TraceRay ray{Vec3(0.0), direction};
  const double pixel = pixel_size(plan);
  const auto hit = closest_hit(plan, ray);
  int pilots = 0;
  if (plan.thin->has(ThinKind::in_sight)) {
    const Beam beam{{ray.origin, direction}, 0.0, beam_pixels * pixel};
    pilots = pilots_for(coverage(plan, ThinKind::in_sight, beam, hit ? hit->t : inf));
  }
  if (!hit || !plan.thin->has(ThinKind::as_shadow)) {
    return pilots;
  }
  const ShadingPoint point = shading_point(plan, ray, *hit);
  // What a pixel covers of a slanted surface is longer; seen from the light it may be again.
  const double cosine = std::abs(glm::dot(point.normal, direction));
  const double radius = beam_pixels * pixel * hit->t / std::max(cosine, 1.0 / farther);
  for (const PlannedLight& light : plan.lights) {
    const Vec3 way = light.position - point.position;
    const double distance = glm::length(way);
    if (!light.extended() && glm::dot(way, point.normal) > 0.0) {
      const Beam beam{{point.position, way / distance}, radius, -radius / distance};
      pilots = std::max(pilots,
                        pilots_for(coverage(plan, ThinKind::as_shadow, beam, distance)));
    }
  }
  return pilots;
}

}  // namespace rt
