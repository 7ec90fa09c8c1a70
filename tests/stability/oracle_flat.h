#pragma once
#include "stability/oracle.h"

namespace rt::stability {

template <class T>
Crossings<T> crossings(const Plane&, const Line<T>& line, double) {
  Crossings<T> c;
  if (line.direction.y < T(0.0) || line.direction.y > T(0.0)) {
    c.add(-line.origin.y / line.direction.y, static_cast<double>(line.direction.y));
  }
  return c;
}

template <class T>
Crossings<T> crossings(const Square& square, const Line<T>& line, double offset) {
  const Crossings<T> plane = crossings(Plane{}, line, offset);
  const T half = T(square.edge) / T(2.0) + T(offset);
  if (plane.count == 0) {
    return plane;
  }
  const Wide3<T> p = line.at(plane.s[0]);
  const bool inside = p.x <= half && -half <= p.x && p.z <= half && -half <= p.z;
  return inside ? plane : Crossings<T>{};
}

/// A mesh of one triangle, whose edges are moved outward by `offset`.
template <class T>
Crossings<T> crossings(const Mesh& mesh, const Line<T>& line, double offset) {
  using std::sqrt;
  const Corners& corners = mesh.data->triangles[0];
  const std::array<Wide3<T>, 3> v{widened<T>(mesh.data->positions[corners[0]]),
                                  widened<T>(mesh.data->positions[corners[1]]),
                                  widened<T>(mesh.data->positions[corners[2]])};
  const Wide3<T> cross_product = cross(v[1] - v[0], v[2] - v[0]);
  const Wide3<T> normal = (T(1.0) / sqrt(dot(cross_product, cross_product))) * cross_product;
  const T cosine = dot(normal, line.direction);
  Crossings<T> c;
  if (!(cosine < T(0.0) || cosine > T(0.0))) {
    return c;
  }
  const T s = dot(normal, v[0] - line.origin) / cosine;
  const Wide3<T> p = line.at(s);
  for (std::size_t i = 0; i < 3; ++i) {
    const Wide3<T> edge = v[(i + 1) % 3] - v[i];
    const T distance = dot(cross(edge, p - v[i]), normal) / sqrt(dot(edge, edge));
    // Distances seen along the ray: where it is foreshortened, so is what rounding can do.
    const Wide3<T> in_plane = cross(normal, edge);
    const T slant = dot(in_plane, line.direction) / (sqrt(dot(edge, edge)) * cosine);
    const T stretch = sqrt(T(1.0) + slant * slant);
    if (distance < -T(offset) * stretch) {
      return c;
    }
  }
  c.add(s, static_cast<double>(cosine));
  return c;
}

}  // namespace rt::stability
