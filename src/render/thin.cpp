#include "rt/render/thin.h"
#include <memory>

#include <algorithm>
#include <cmath>

#include "rt/math/warp.h"
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
/// An edge of no length is taken for so much of the longest: enough to have an inverse.
constexpr double flat = 1e-9;

using Edges = std::array<Vec3, 3>;

/// The least width of a box (half-edges e) as seen in a unit direction. Its outline is spanned by
/// the projected edges; the least width is that across one of them.
double apparent_width(const Edges& e, const Vec3& direction) {
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
double apparent_area(const Edges& e, const Vec3& direction) {
  return 4.0 * (std::abs(glm::dot(glm::cross(e[0], e[1]), direction)) +
                std::abs(glm::dot(glm::cross(e[1], e[2]), direction)) +
                std::abs(glm::dot(glm::cross(e[2], e[0]), direction)));
}

/// The share of a disc that a box covers which is narrower than the disc, and perhaps longer.
double covered(const Edges& e, const Vec3& direction, double radius) {
  const double width = apparent_width(e, direction);
  const double length = apparent_area(e, direction) / width;
  return width * std::min(length, 2.0 * radius) / (pi * radius * radius);
}

Edges thickened(Edges e) {
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

/// The boxes that stand for an instance: one, or for a ring one an arc.
struct Parts {
  std::vector<std::pair<Vec3, Edges>> boxes;

  void add(const Affine& map, const Bounds& b) {
    const Vec3 half = 0.5 * b.extent();
    boxes.emplace_back(
        map.point(b.centre()),
        thickened({half.x * map.linear[0], half.y * map.linear[1], half.z * map.linear[2]}));
  }
};

Parts parts_of(const RenderPlan& plan, const PlannedInstance& instance) {
  Parts parts;
  const Affine map = plan.placement(instance).render_from_model;
  const Torus* torus = instance.is<Torus>() ? &plan.shapes.of<Torus>()[instance.shape] : nullptr;
  if (torus == nullptr || torus->minor_radius > 0.25 * torus->major_radius) {
    parts.add(map, model_box_of(plan, instance));
    return parts;
  }
  // Arcs so short that they bend by no more than the tube is thick.
  const double R = torus->major_radius;
  const double r = torus->minor_radius;
  const int arcs = std::min(256, static_cast<int>(std::ceil(pi / std::acos(1.0 - r / R))));
  const double half = pi / arcs;
  for (int i = 0; i < arcs; ++i) {
    const Affine turn = Affine::rotation(1, (2.0 * i + 1.0) * half * 180.0 / pi);
    parts.add(map * turn, {{R * std::cos(half) - r, -r, -(R + r) * std::sin(half)},
                           {R + r, r, (R + r) * std::sin(half)}});
  }
  return parts;
}

/// The size of a pixel at distance 1.
double pixel_size(const RenderPlan& plan) {
  return 2.0 * glm::length(plan.camera.down) / plan.options.height;
}

void add_parts(const RenderPlan& plan, const Parts& parts, bool casts, ThinThings& thin) {
  const double pixel = pixel_size(plan);
  for (const auto& [centre, edges] : parts.boxes) {
    const double reach = glm::length(edges[0]) + glm::length(edges[1]) + glm::length(edges[2]);
    const double distance = glm::length(centre);
    const double there = pixel * (distance + reach);  // a pixel at its far end
    if (distance > 0.0 && apparent_width(edges, centre / distance) < wide * there) {
      thin.in_sight.add(centre, edges, beam_pixels * there);
    }
    const auto thin_for = [&, &centre = centre, &edges = edges](const PlannedLight& light) {
      const Vec3 way = centre - light.position;
      const double d = glm::length(way);
      return !light.extended() && d > 0.0 &&
             apparent_width(edges, way / d) < wide * farther * there;
    };
    if (casts && std::any_of(plan.lights.begin(), plan.lights.end(), thin_for)) {
      thin.as_shadows.add(centre, edges, beam_pixels * farther * there);
    }
  }
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

ThinBoxes::ThinBoxes() = default;
ThinBoxes::~ThinBoxes() = default;

void ThinBoxes::add(const Vec3& centre, const Edges& edges, double largest_beam) {
  const double volume = glm::dot(edges[0], glm::cross(edges[1], edges[2]));
  if (volume == 0.0) {
    return;  // flat twice over: nothing to see
  }
  Box box{centre, edges, {}};
  Vec3 half(largest_beam);
  for (std::size_t k = 0; k < 3; ++k) {
    box.normals[k] = glm::cross(edges[(k + 1) % 3], edges[(k + 2) % 3]) / volume;
    half += glm::abs(edges[k]);
  }
  boxes_.push_back(box);
  bounds_.push_back({centre - half, centre + half});
}

void ThinBoxes::build() {
  if (!boxes_.empty()) {
    tree_ = std::make_unique<BoxTree>(bounds_);
  }
}

double ThinBoxes::coverage(const Beam& beam, double t_max) const {
  double sum = 0.0;
  tree_->walk(beam.axis, t_max, [&](std::uint32_t i) {
    const Box& box = boxes_[i];
    const Vec3 to_centre = box.centre - beam.axis.origin;
    const double nearest = glm::dot(to_centre, beam.axis.direction);
    const double reach =
        glm::length(box.edges[0]) + glm::length(box.edges[1]) + glm::length(box.edges[2]);
    // The box grows by the beam's radius at its far end; then the axis meets it or not.
    const double radius =
        std::max(beam.radius + beam.slope * (nearest + std::copysign(reach, beam.slope)), 0.0);
    double t0 = 0.0;
    double t1 = t_max;
    for (std::size_t k = 0; k < 3; ++k) {
      const double o = -glm::dot(to_centre, box.normals[k]);
      const double d = glm::dot(beam.axis.direction, box.normals[k]);
      const double half = 1.0 + radius * glm::length(box.normals[k]);
      const double a = (-half - o) / d;
      const double b = (half - o) / d;
      t0 = std::max(t0, std::min(a, b));
      t1 = std::min(t1, std::max(a, b));
    }
    if (t0 <= t1) {
      const double here = beam.radius + beam.slope * 0.5 * (t0 + t1);
      if (here > 0.0) {
        sum += covered(box.edges, beam.axis.direction, here);
      }
    }
    return t_max;
  });
  return sum;
}

std::unique_ptr<const ThinThings> find_thin(const RenderPlan& plan) {
  auto thin = std::make_unique<ThinThings>();
  for (const PlannedInstance& instance : std::span(plan.instances).first(plan.bounded)) {
    if (!instance.moves()) {  // what moves is a blur anyway
      add_parts(plan, parts_of(plan, instance), instance.shadow == Shadow::blocks, *thin);
    }
  }
  thin->in_sight.build();
  thin->as_shadows.build();
  return thin->in_sight.empty() && thin->as_shadows.empty() ? nullptr : std::move(thin);
}

int thin_pilots(const RenderPlan& plan, int x, int y) {
  const Vec3 direction = glm::normalize(
      plan.camera.direction((x + 0.5) / plan.options.width, (y + 0.5) / plan.options.height));
  const TraceRay ray{Vec3(0.0), direction};
  const double pixel = pixel_size(plan);
  const auto hit = closest_hit(plan, ray);
  int pilots = 0;
  if (!plan.thin->in_sight.empty()) {
    const Beam beam{{ray.origin, direction}, 0.0, beam_pixels * pixel};
    pilots = pilots_for(plan.thin->in_sight.coverage(beam, hit ? hit->t : inf));
  }
  if (!hit || plan.thin->as_shadows.empty()) {
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
      pilots = std::max(pilots, pilots_for(plan.thin->as_shadows.coverage(beam, distance)));
    }
  }
  return pilots;
}

}  // namespace rt
