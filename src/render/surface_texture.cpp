#include "rt/render/surface_texture.h"

#include <algorithm>
#include <cmath>

#include "rt/render/query.h"
#include "rt/scene/texture_image.h"

namespace rt {
namespace {

/// A point of a surface, in model space, as textures see it. Surface coordinates are found when a
/// picture asks for them: solid textures need none.
class TexturePoint {
 public:
  TexturePoint(const RenderPlan& plan, const SceneHit& hit, const SurfacePoint& point,
               const Vec3& dp_dx, const Vec3& dp_dy)
      : plan_(plan), hit_(hit), point_(point), dp_dx_(dp_dx), dp_dy_(dp_dy) {}

  const SurfacePoint& point() const { return point_; }

  const SurfaceCoordinates& coordinates() {
    if (!coordinates_) {
      coordinates_ = plan_.visit(plan_.instances[hit_.instance], [&](const auto& shape) {
        return surface_coordinates(shape, point_, hit_.feature);
      });
    }
    return *coordinates_;
  }

  Rgb value(const Texture& texture, bool raw = false) {
    return std::visit([&](const auto& t) { return value_of(t, raw); }, texture);
  }

  /// How a height rises along the surface, per unit of model space.
  Vec3 slope(const Texture& texture, const Vec3& normal) {
    return std::visit([&](const auto& t) { return slope_of(t, normal); }, texture);
  }

 private:
  Rgb value_of(const Checker& checker, bool) const {
    return colour(checker, point_.position, glm::abs(dp_dx_) + glm::abs(dp_dy_));
  }
  Rgb value_of(const NoiseTexture& noise, bool) const {
    return colour(noise, point_.position, dp_dx_, dp_dy_);
  }
  Rgb value_of(const ImageTexture& t, bool raw) {
    return glm::max(t.image->value(footprint(t), t.wrap, raw), Rgb(0.0));
  }

  Vec3 slope_of(const Checker&, const Vec3&) const { return Vec3(0.0); }
  Vec3 slope_of(const NoiseTexture& noise, const Vec3& normal) const {
    const Vec3 g = height(noise, point_.position, dp_dx_, dp_dy_).gradient;
    return g - glm::dot(g, normal) * normal;
  }
  // The gradient along the surface of h(u, v): the vector g across n with g.dp_du = dh/du and
  // g.dp_dv = dh/dv. The determinant carries the sign of dp_du x dp_dv against the normal, so that
  // a height is outward on mirrored coordinates too.
  Vec3 slope_of(const ImageTexture& t, const Vec3& normal) {
    const TextureSample s = t.image->sample(footprint(t), t.wrap, true);
    const SurfaceCoordinates& c = coordinates();
    const double determinant = glm::dot(normal, glm::cross(c.dp_du, c.dp_dv));
    const Vec3 g = (grey(s.d_du) * t.scale.x * glm::cross(c.dp_dv, normal) +
                    grey(s.d_dv) * t.scale.y * glm::cross(normal, c.dp_du)) /
                   determinant;
    return all_finite(g) ? g : Vec3(0.0);  // at a pole
  }

  TextureFootprint footprint(const ImageTexture& t) {
    // What spans a whole period sees its mean; beyond pictures that do not repeat there is more.
    const double widest = t.wrap == Wrap::repeat ? 1.0 : 1024.0;
    const auto scaled = [&](const Vec2& duv) {
      return glm::clamp(duv * t.scale, Vec2(-widest), Vec2(widest));
    };
    return {coordinates().uv * t.scale, scaled(duv(dp_dx_)), scaled(duv(dp_dy_))};
  }

  /// The change of u and v over a step along the surface, by least squares. No coordinate jumps
  /// here where u wraps: derivatives are those of the surface. At a pole u changes without bound.
  Vec2 duv(const Vec3& step) {
    constexpr double everything = 1e6;  // footprint() cuts it down
    const SurfaceCoordinates& c = coordinates();
    const double uu = glm::dot(c.dp_du, c.dp_du);
    const double uv = glm::dot(c.dp_du, c.dp_dv);
    const double vv = glm::dot(c.dp_dv, c.dp_dv);
    const double determinant = uu * vv - uv * uv;
    const double u = glm::dot(c.dp_du, step);
    const double v = glm::dot(c.dp_dv, step);
    if (determinant > 0.0) {
      const Vec2 result((vv * u - uv * v) / determinant, (uu * v - uv * u) / determinant);
      if (std::isfinite(result.x) && std::isfinite(result.y)) {
        return result;
      }
    }
    if (step == Vec3(0.0)) {
      return Vec2(0.0);
    }
    return {everything, vv > 0.0 && std::isfinite(v / vv) ? v / vv : everything};
  }

  const RenderPlan& plan_;
  const SceneHit& hit_;
  SurfacePoint point_;
  Vec3 dp_dx_, dp_dy_;
  std::optional<SurfaceCoordinates> coordinates_;
};

/// The shading normal of model space, tilted by a normal map: its components are taken along
/// dp_du made orthogonal to the normal, along the third axis on dp_dv's side, and outward.
Vec3 mapped(TexturePoint& at, const TextureSet::Entry& map, const Vec3& normal) {
  const Rgb c = 2.0 * at.value(*map.texture, true) - 1.0;
  const Vec3& du = at.coordinates().dp_du;
  const Vec3 along = glm::normalize(du - glm::dot(du, normal) * normal);
  const Vec3 third = glm::cross(normal, along);
  const double side = glm::dot(third, at.coordinates().dp_dv) < 0.0 ? -1.0 : 1.0;
  const double outward = std::max(c.z, 1.0 / 255.0);  // the least that 8 bits can say
  const Vec3 n = map.strength * (c.x * along + side * c.y * third) + outward * normal;
  return all_finite(n) ? glm::normalize(n) : normal;  // at a pole
}

/// Blinn, "Simulation of wrinkled surfaces", SIGGRAPH 1978: to first order the normal of a surface
/// raised by h is n minus the gradient of h along the surface.
Vec3 bumped(TexturePoint& at, const TextureSet::Entry& bump, const Vec3& normal) {
  Vec3 slope(0.0);
  for (const TextureSet::Entry* layer = &bump; layer != nullptr; layer = layer->under.get()) {
    slope += layer->strength * at.slope(*layer->texture, normal);
  }
  return glm::normalize(normal - slope);
}

/// `n` made perpendicular to the view where it faces away from it; then reflections graze.
Vec3 facing(const Vec3& n, const Vec3& view, const Vec3& geometric) {
  const double n_dot_v = glm::dot(n, view);
  if (n_dot_v > 0.0) {
    return n;
  }
  const Vec3 side = n - n_dot_v * view;
  const double length = glm::length(side);
  return length > 0.0 ? side / length : geometric;
}

void tilt(TexturePoint& at, const RenderPlan& plan, const TextureSet& textures,
          const Vec3& direction, ShadingPoint& point) {
  const TextureSet::Entry& map = textures[TextureSlot::normal];
  const TextureSet::Entry& bump = textures[TextureSlot::bump];
  if (!map.texture && !bump.texture) {
    return;
  }
  Vec3 n = at.point().shading_normal;
  if (map.texture) {
    n = mapped(at, map, n);
  }
  if (bump.texture) {
    n = bumped(at, bump, n);
  }
  n = plan.map(plan.instances[point.instance], point.time,
               [&](const auto& placed) { return placed.render_normal(n); });
  if (point.side == Leaving::inward) {
    n = -n;
  }
  point.shading_normal = facing(n, -direction, point.normal);
}

double opacity_of(TexturePoint& at, const TextureSet& textures, const PlannedMaterial& material) {
  const auto& texture = textures[TextureSlot::opacity].texture;
  return texture ? std::clamp(grey(at.value(*texture)), 0.0, 1.0) : material.opacity;
}

/// The layers of an entry that the options leave in force; one without a texture if none.
TextureSet::Entry in_force(const TextureSet::Entry& entry, const RenderOptions& options) {
  if (!entry.texture) {
    return {};
  }
  const TextureSet::Entry under =
      entry.under ? in_force(*entry.under, options) : TextureSet::Entry{};
  if (!(std::holds_alternative<NoiseTexture>(*entry.texture) ? options.noise : options.textures)) {
    return under;
  }
  return {entry.texture, entry.strength,
          under.texture ? std::make_shared<const TextureSet::Entry>(under) : nullptr};
}

}  // namespace

Reflectances textured(const RenderPlan& plan, const TraceRay& ray, const SceneHit& hit,
                      const PlannedMaterial& material, const RayDifferential* here,
                      ShadingPoint& point) {
  const PlannedInstance& instance = plan.instances[hit.instance];
  const TextureSet& textures = *material.textures;
  Vec3 dp_dx(0.0);
  Vec3 dp_dy(0.0);
  if (here != nullptr) {
    plan.map(instance, ray.time, [&](const auto& map) {
      dp_dx = map.model_vector(here->dp_dx);
      dp_dy = map.model_vector(here->dp_dy);
    });
  }
  TexturePoint at(plan, hit, model_point(plan, ray, hit), dp_dx, dp_dy);
  tilt(at, plan, textures, ray.direction, point);
  const auto& kd = textures[TextureSlot::kd].texture;
  const auto& ks = textures[TextureSlot::ks].texture;
  const Reflectances plain = plan.plain(instance);
  return {kd ? at.value(*kd) : plain.kd, ks ? at.value(*ks) : plain.ks,
          opacity_of(at, textures, material)};
}

double opacity_at(const RenderPlan& plan, const TraceRay& ray, const SceneHit& hit,
                  const PlannedMaterial& material, double width) {
  if (!material.textures || !(*material.textures)[TextureSlot::opacity].texture) {
    return material.opacity;
  }
  const PlannedInstance& instance = plan.instances[hit.instance];
  const Placement placement = plan.placements.at(instance.map, instance.placement, ray.time);
  const SurfacePoint p = model_point(plan, ray, hit);
  // A disc of that width, whatever way the surface is turned.
  const Vec3 any = std::abs(p.normal.x) < 0.5 ? Vec3(1, 0, 0) : Vec3(0, 0, 1);
  const Vec3 side = glm::normalize(glm::cross(p.normal, any));
  const double in_model =
      width * std::cbrt(std::abs(glm::determinant(placement.model_from_render.linear)));
  TexturePoint at(plan, hit, p, in_model * side, in_model * glm::cross(p.normal, side));
  return opacity_of(at, *material.textures, material);
}

std::shared_ptr<const TextureSet> in_force(const std::shared_ptr<const TextureSet>& textures,
                                           const RenderOptions& options) {
  if (!textures || (options.textures && options.noise && options.refraction)) {
    return textures;
  }
  auto left = std::make_shared<TextureSet>(*textures);
  for (TextureSet::Entry& entry : left->entries) {
    entry = in_force(entry, options);
  }
  if (!options.refraction) {
    (*left)[TextureSlot::opacity] = {};
  }
  return left->empty() ? nullptr : left;
}

}  // namespace rt
