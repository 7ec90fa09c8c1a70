#pragma once
/// The maps of placement_table.h for several points at a time.
#include "rt/geometry/wide_shapes.h"
#include "rt/render/placement_table.h"

namespace rt {

inline WideRay model_rays(const MovedMap& map, const WideRay& r) {
  return {r.origin - Wide3(map.offset), r.direction};
}
inline WideRay model_rays(const ScaledMap& map, const WideRay& r) {
  const Wide factor(map.model_factor);
  return {factor * (r.origin - Wide3(map.offset)), factor * r.direction};
}
inline WideRay model_rays(const TurnedMap& map, const WideRay& r) {
  const Wide factor(map.model_factor * map.model_factor);
  return {factor * ((r.origin - Wide3(map.offset)) * map.to_render),
          factor * (r.direction * map.to_render)};
}
inline WideRay model_rays(const LinearMap& map, const WideRay& r) {
  return {map.parts.to_model * r.origin + Wide3(map.to_model), map.parts.to_model * r.direction};
}

inline Wide3 render_points(const MovedMap& map, const Wide3& p) { return p + Wide3(map.offset); }
inline Wide3 render_points(const ScaledMap& map, const Wide3& p) {
  return Wide(map.render_factor) * p + Wide3(map.offset);
}
inline Wide3 render_points(const TurnedMap& map, const Wide3& p) {
  return map.to_render * p + Wide3(map.offset);
}
inline Wide3 render_points(const LinearMap& map, const Wide3& p) {
  return map.parts.to_render * p + Wide3(map.offset);
}

inline Wide3 scaled_to_unit(const Wide3& v) { return normalize(v / max_abs(v)); }
inline Wide3 render_normals(const MovedMap&, const Wide3& n) { return n; }
inline Wide3 render_normals(const ScaledMap& map, const Wide3& n) {
  return scaled_to_unit(n * Wide(map.model_factor));
}
inline Wide3 render_normals(const TurnedMap& map, const Wide3& n) {
  return scaled_to_unit(map.to_render * n);
}
inline Wide3 render_normals(const LinearMap& map, const Wide3& n) {
  return scaled_to_unit(n * map.parts.to_model);
}

}  // namespace rt
