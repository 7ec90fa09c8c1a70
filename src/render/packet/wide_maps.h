#pragma once
/// The maps of placement_table.h for several points at a time.
#include "rt/geometry/wide_shapes.h"
#include "rt/render/placement_table.h"

namespace rt {

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

inline Wide3 model_vectors(const MovedMap&, const Wide3& v) { return v; }
inline Wide3 model_vectors(const ScaledMap& map, const Wide3& v) {
  return Wide(map.model_factor) * v;
}
inline Wide3 model_vectors(const TurnedMap& map, const Wide3& v) {
  return Wide(map.model_factor * map.model_factor) * (v * map.to_render);
}
inline Wide3 model_vectors(const LinearMap& map, const Wide3& v) { return map.parts.to_model * v; }

inline Wide3 model_points(const MovedMap& map, const Wide3& p) { return p - Wide3(map.offset); }
inline Wide3 model_points(const ScaledMap& map, const Wide3& p) {
  return Wide(map.model_factor) * (p - Wide3(map.offset));
}
inline Wide3 model_points(const TurnedMap& map, const Wide3& p) {
  return model_vectors(map, p - Wide3(map.offset));
}
inline Wide3 model_points(const LinearMap& map, const Wide3& p) {
  return map.parts.to_model * p + Wide3(map.to_model);
}

template <class Map>
inline WideRay model_rays(const Map& map, const WideRay& r) {
  return {model_points(map, r.origin), model_vectors(map, r.direction)};
}

inline Wide3 render_covectors(const MovedMap&, const Wide3& n) { return n; }
inline Wide3 render_covectors(const ScaledMap& map, const Wide3& n) {
  return n * Wide(map.model_factor);
}
inline Wide3 render_covectors(const TurnedMap& map, const Wide3& n) { return map.to_render * n; }
inline Wide3 render_covectors(const LinearMap& map, const Wide3& n) {
  return n * map.parts.to_model;
}

inline Wide3 scaled_to_unit(const Wide3& v) { return normalize(v / max_abs(v)); }
inline Wide3 render_normals(const MovedMap&, const Wide3& n) { return n; }
template <class Map>
inline Wide3 render_normals(const Map& map, const Wide3& n) {
  return scaled_to_unit(render_covectors(map, n));
}

inline Wide3 model_normals(const MovedMap&, const Wide3& n) { return n; }
inline Wide3 model_normals(const ScaledMap& map, const Wide3& n) {
  return scaled_to_unit(n * Wide(map.render_factor));
}
inline Wide3 model_normals(const TurnedMap& map, const Wide3& n) {
  return scaled_to_unit(n * map.to_render);
}
inline Wide3 model_normals(const LinearMap& map, const Wide3& n) {
  return scaled_to_unit(n * map.parts.to_render);
}

}  // namespace rt
