#pragma once
#include "stability/oracle.h"

namespace rt::stability {

template <class T>
struct MeshCrossing {
  T s;
  double cosine;
};

/// Whether a line passes a triangle by so far that doubles can tell, with lengths of the order of
/// one: further from a corner than the triangle reaches.
template <class T>
bool passes_far_by(const Line<T>& line, const Vec3& a, const Vec3& b, const Vec3& c) {
  const auto narrowed = [](const Wide3<T>& v) {
    return Vec3(static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z));
  };
  const double reach = std::max(glm::length(b - a), glm::length(c - a)) + 1e-3;
  return glm::length(glm::cross(a - narrowed(line.origin), narrowed(line.direction))) > reach;
}

/// The first crossing of a closed mesh after line.begin, out of the solid (`exit`) or into it.
/// Faces are moved outward by `offset`, and reach over their edges by as much whatever its sign:
/// a moved solid has no gaps.
template <class T>
std::optional<MeshCrossing<T>> first_crossing(const MeshData& mesh, const Line<T>& line, bool exit,
                                              double offset) {
  using std::sqrt;
  std::optional<MeshCrossing<T>> first;
  for (const Corners& corners : mesh.triangles) {
    const Vec3& a = mesh.positions[corners[0]];
    const Vec3& b = mesh.positions[corners[1]];
    const Vec3& c = mesh.positions[corners[2]];
    if (passes_far_by(line, a, b, c)) {
      continue;
    }
    const std::array<Wide3<T>, 3> v{widened<T>(a), widened<T>(b), widened<T>(c)};
    const Wide3<T> across = cross(v[1] - v[0], v[2] - v[0]);
    const Wide3<T> normal = (T(1.0) / sqrt(dot(across, across))) * across;
    const T cosine = dot(normal, line.direction);
    if (!(exit ? cosine > T(0.0) : cosine < T(0.0))) {
      continue;
    }
    const T s = (T(offset) + dot(normal, v[0] - line.origin)) / cosine;
    if (!(s > line.begin) || (first && s >= first->s)) {
      continue;
    }
    const Wide3<T> p = line.at(s);
    bool within = true;
    for (std::size_t i = 0; i < 3; ++i) {
      const Wide3<T> inward = cross(normal, v[(i + 1) % 3] - v[i]);
      const T length = sqrt(dot(inward, inward));
      // A distance seen along the ray: where it is foreshortened, so is what an offset can do.
      const T slant = dot(inward, line.direction) / (length * cosine);
      const T reach = T(std::abs(offset)) * sqrt(T(1.0) + slant * slant);
      within = within && dot(inward, p - v[i]) >= -reach * length;
    }
    if (within) {
      first = MeshCrossing<T>{s, static_cast<double>(cosine)};
    }
  }
  return first;
}

}  // namespace rt::stability
