#include "rt/geometry/fan.h"

#include <array>
#include <cmath>
#include <limits>

namespace rt {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double cross(const Vec2& u, const Vec2& v) { return u.x * v.y - u.y * v.x; }

/// The directions that the extreme points of a convex piece span, which does not hold the origin:
/// less than a half turn. A point is origin + a start + b step, in direction s = b / a.
class Extremes {
 public:
  explicit Extremes(double nearest) : nearest_(nearest) {}

  void add(const Vec2& point) {
    if (!any_) {
      any_ = true;
      first_ = last_ = point;
    } else if (cross(first_, point) < 0.0) {
      first_ = point;
    } else if (cross(last_, point) > 0.0) {
      last_ = point;
    }
    finite_ = finite_ && std::abs(point.x) < infinity && std::abs(point.y) < infinity;
  }

  std::optional<Span> span() const {
    if (!any_) {
      return Span{infinity, -infinity};
    }
    // The piece holds the way from its first point to its last. Written so that NaN is near.
    const bool apart = cross(first_, last_) > nearest_ * glm::length(last_ - first_);
    if (!(finite_ && apart)) {
      return std::nullopt;
    }
    // Of less than a half turn, what is ahead (a > 0) reaches to the end that is not, and beyond
    // all s there.
    if (!(first_.x > 0.0 || last_.x > 0.0)) {
      return Span{infinity, -infinity};
    }
    const double lo = first_.x > 0.0 ? first_.y / first_.x : -infinity;
    const double hi = last_.x > 0.0 ? last_.y / last_.x : infinity;
    return Span{lo, hi};
  }

 private:
  double nearest_;
  bool any_ = false;
  bool finite_ = true;
  Vec2 first_{0.0}, last_{0.0};
};

/// Calls visit(x, y) for the real roots x / y of p x^2 + 2 q x + r, without cancellation.
template <class Visit>
void each_root(double p, double q, double r, Visit&& visit) {
  const double discriminant = q * q - p * r;
  if (discriminant > 0.0) {
    const double sum = -(q + std::copysign(std::sqrt(discriminant), q));
    visit(sum, p);
    visit(r, sum);
  }
}

/// The surface x^2 + z^2 + square y^2 + 2 linear y + constant = 0, of which a shape has the part
/// with lo <= y <= hi.
struct Round {
  double square, linear, constant;
  double lo, hi;
};

/// That surface over the fan's plane: aa a^2 + 2 ab a b + bb b^2 + 2 (a_ a + b_ b) + c = 0.
struct Conic {
  Conic(const Round& round, const Fan& fan) {
    const Vec3 weight{1.0, round.square, 1.0};
    aa = glm::dot(weight * fan.start, fan.start);
    ab = glm::dot(weight * fan.start, fan.step);
    bb = glm::dot(weight * fan.step, fan.step);
    a = glm::dot(weight * fan.origin, fan.start) + round.linear * fan.start.y;
    b = glm::dot(weight * fan.origin, fan.step) + round.linear * fan.step.y;
    c = glm::dot(weight * fan.origin, fan.origin) + 2.0 * round.linear * fan.origin.y +
        round.constant;
  }
  double along(const Vec2& u, const Vec2& v) const {
    return aa * u.x * v.x + ab * (u.x * v.y + u.y * v.x) + bb * u.y * v.y;
  }

  double aa, ab, bb, a, b, c;
};

/// Where lines from the origin touch the conic: (a + s b)^2 = c (aa + 2 s ab + s^2 bb).
void add_tangents(const Conic& q, const Round& round, const Fan& fan, Extremes& extremes) {
  each_root(q.b * q.b - q.c * q.bb, q.a * q.b - q.c * q.ab, q.a * q.a - q.c * q.aa,
            [&](double x, double y) {
              const Vec2 way{y, x};
              const Vec2 point = way * (-(q.a * way.x + q.b * way.y) / q.along(way, way));
              const double height = fan.origin.y + point.x * fan.start.y + point.y * fan.step.y;
              if (!(height < round.lo || height > round.hi)) {
                extremes.add(point);
              }
            });
}

/// Where the conic meets the plane y = height: the corners of a disc that closes the shape.
void add_corners(const Conic& q, const Fan& fan, double height, Extremes& extremes) {
  const Vec2 rise{fan.start.y, fan.step.y};
  const double square = glm::dot(rise, rise);
  if (!(square > 0.0)) {
    return;  // the fan lies level
  }
  const Vec2 foot = rise * ((height - fan.origin.y) / square);
  const Vec2 way{-rise.y, rise.x};
  const double half = q.along(foot, way) + q.a * way.x + q.b * way.y;
  const double at_foot = q.along(foot, foot) + 2.0 * (q.a * foot.x + q.b * foot.y) + q.c;
  each_root(q.along(way, way), half, at_foot,
            [&](double x, double y) { extremes.add(foot + (x / y) * way); });
}

/// A solid of revolution bounded by round pieces, each above the other, and by discs.
template <std::size_t Count>
std::optional<Span> stopped_round(const std::array<Round, Count>& pieces, const Fan& fan) {
  Extremes extremes(fan.nearest);
  for (const Round& piece : pieces) {
    const Conic conic(piece, fan);
    if (!(conic.c > 0.0) && fan.origin.y >= piece.lo && fan.origin.y <= piece.hi) {
      return std::nullopt;  // inside
    }
    add_tangents(conic, piece, fan, extremes);
    for (const double height : {piece.lo, piece.hi}) {
      if (std::abs(height) < infinity) {
        add_corners(conic, fan, height, extremes);
      }
    }
  }
  return extremes.span();
}

std::optional<Span> stopped_by(const Sphere& sphere, const Fan& fan) {
  constexpr std::array<Round, 1> unit{{{1.0, 0.0, -1.0, -infinity, infinity}}};
  const double scale = 1.0 / sphere.radius;
  return stopped_round(unit, {scale * (fan.origin - sphere.centre), scale * fan.start,
                              scale * fan.step, fan.nearest});
}

std::optional<Span> stopped_by(const Cylinder&, const Fan& fan) {
  constexpr std::array<Round, 1> pieces{{{0.0, 0.0, -1.0, 0.0, 1.0}}};
  return stopped_round(pieces, fan);
}

// x^2 + z^2 = (1 - y)^2.
std::optional<Span> stopped_by(const PointedCone&, const Fan& fan) {
  constexpr std::array<Round, 1> pieces{{{-1.0, 1.0, -1.0, 0.0, 1.0}}};
  return stopped_round(pieces, fan);
}

// The head, and x^2 + z^2 = (sqrt(26) - y)^2 / 25.
std::optional<Span> stopped_by(const Blob&, const Fan& fan) {
  constexpr std::array<Round, 2> pieces{
      {{1.0, 0.0, -1.0, Blob::join, infinity},
       {-1.0 / 25.0, Blob::apex / 25.0, -26.0 / 25.0, -1.0, Blob::join}}};
  return stopped_round(pieces, fan);
}

// The plane of the fan cuts those of the twelve edges whose ends lie on either side of it. The box
// is the sum of three edges, so a corner's coordinates (a, b and its side) are sums of three terms.
std::optional<Span> stopped_by(const Box& box, const Fan& fan) {
  if (glm::all(glm::lessThanEqual(box.lo, fan.origin)) &&
      glm::all(glm::lessThanEqual(fan.origin, box.hi))) {
    return std::nullopt;  // inside
  }
  const Vec3 normal = glm::cross(fan.start, fan.step);
  const double square = glm::dot(normal, normal);
  const Mat3 dual{glm::cross(fan.step, normal) / square, glm::cross(normal, fan.start) / square,
                  normal};
  std::array<Vec3, 8> corners;
  for (std::size_t k = 0; k < 8; ++k) {
    const Vec3 corner{k & 1u ? box.hi.x : box.lo.x, k & 2u ? box.hi.y : box.lo.y,
                      k & 4u ? box.hi.z : box.lo.z};
    corners[k] = (corner - fan.origin) * dual;
  }
  Extremes extremes(fan.nearest);
  for (std::size_t k = 0; k < 8; ++k) {
    for (const std::size_t bit : {1u, 2u, 4u}) {
      const Vec3& from = corners[k];
      const Vec3& to = corners[k | bit];
      if ((k & bit) == 0 && (from.z < 0.0) != (to.z < 0.0)) {
        extremes.add(Vec2(from * to.z - to * from.z) / (to.z - from.z));
      }
    }
  }
  return extremes.span();
}

std::optional<Span> stopped_by(const Square& square, const Fan& fan) {
  const double half = 0.5 * square.edge;
  return stopped_by(Box{{-half, 0.0, -half}, {half, 0.0, half}}, fan);
}

template <class Other>
std::optional<Span> stopped_by(const Other&, const Fan&) {
  return std::nullopt;
}

}  // namespace

std::optional<Span> stopped(const Shape& shape, const Fan& fan) {
  return std::visit([&](const auto& s) { return stopped_by(s, fan); }, shape);
}

}  // namespace rt
