/// How samplers' errors fall, on two integrals whose values are known, as CSV:
///
///   bench_sampling PIXELS LARGEST_COUNT
///
/// *penumbra*: an edge before a disc-like light, seen from one point, as in
/// tests/convergence/penumbra_test.cpp: visible where l.n < s, l uniform on the unit disc.
///
/// *path*: a pixel through which a glossy surface is seen, that shows a moving one in a penumbra:
/// seven dimensions, visible where n.(pixel + lobe + light) + time < s; `rays` counts camera,
/// reflected and shadow rays. "nested" is a pixel of 16 samples with m reflected rays at each and m
/// shadow rays at each of those, all at random; "one path" takes one of each for a sample.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <random>
#include <string>

#include "rt/math/sampler.h"
#include "rt/math/warp.h"

namespace rt {
namespace {

struct Random {
  std::mt19937_64 engine;
  double operator()() { return std::uniform_real_distribution<>(0.0, 1.0)(engine); }
  Vec2 square() {
    const double x = (*this)();
    return {x, (*this)()};
  }
};

struct Edge {
  Vec2 n;
  double s;
};

Edge edge_of(Random& random) {
  const double angle = 2.0 * pi * random();
  return {{std::cos(angle), std::sin(angle)}, 1.6 * random() - 0.8};
}

double disc_share(double s) {
  s = std::clamp(s, -1.0, 1.0);
  return 1.0 - (std::acos(s) - s * std::sqrt(1.0 - s * s)) / pi;
}

using Light = std::function<Vec2(int i)>;  // sample i, in the unit square

double penumbra(const Edge& e, int count, const Light& light) {
  double sum = 0.0;
  for (int i = 0; i < count; ++i) {
    sum += glm::dot(to_disc(light(i)), e.n) < e.s ? 1.0 : 0.0;
  }
  return sum / count;
}

void penumbras(int pixels, int largest) {
  for (int side = 1; side * side <= largest; side *= 2) {
    const int count = side * side;
    double squares[4] = {};
    for (int p = 0; p < pixels; ++p) {
      Random random{std::mt19937_64(static_cast<std::uint64_t>(p))};
      const Edge e = edge_of(random);
      const Sampler sampler(7, p, 0, 0);
      const auto cell = [&](int i, Vec2 at) {
        return Vec2((i % side + at.x) / side, (i / side + at.y) / side);  // NOLINT
      };
      const Light lights[4] = {
          [&](int) { return random.square(); },
          [&](int i) {
            return cell(i, {0.5, 0.5});
          },
          [&](int i) { return cell(i, random.square()); },
          [&](int i) { return sampler.at(static_cast<std::uint32_t>(i)).light(); }};
      for (int k = 0; k < 4; ++k) {
        const double d = penumbra(e, count, lights[k]) - disc_share(e.s);
        squares[k] += d * d;
      }
    }
    constexpr const char* names[4] = {"random", "fixed grid", "stratified", "Owen-Sobol"};
    for (int k = 0; k < 4; ++k) {
      fmt::print("penumbra,{},{},{:.6g}\n", names[k], count, std::sqrt(squares[k] / pixels));
    }
  }
}

/// The path integral: 1 where what is met lies before the edge.
double met(const Edge& e, Vec2 pixel, Vec2 lobe, Vec2 light, double time) {
  const Vec2 at = 0.5 * (pixel - 0.5) + 0.7 * to_disc(lobe) + 0.7 * to_disc(light);
  return glm::dot(at, e.n) + time - 0.5 < e.s ? 1.0 : 0.0;
}

double one_path(const Edge& e, int count, const std::function<Sampler(int)>& sample) {
  double sum = 0.0;
  for (int i = 0; i < count; ++i) {
    const Sampler s = sample(i);
    sum += met(e, s.pixel(), s.lobe(), s.light({1, 0}), s.time());
  }
  return sum / count;
}

double nested(const Edge& e, int m, Random& random) {
  double sum = 0.0;
  for (int p = 0; p < 16; ++p) {
    const Vec2 pixel = random.square();
    const double time = random();
    for (int r = 0; r < m; ++r) {
      const Vec2 lobe = random.square();
      for (int l = 0; l < m; ++l) {
        sum += met(e, pixel, lobe, random.square(), time);
      }
    }
  }
  return sum / (16.0 * m * m);
}

void paths(int pixels, int largest) {
  const auto report = [&](const char* name, int rays,
                          const std::function<double(int)>& difference) {
    double squares = 0.0;
    for (int p = 0; p < pixels; ++p) {
      const double d = difference(p);
      squares += d * d;
    }
    fmt::print("path,{},{},{:.6g}\n", name, rays, std::sqrt(squares / pixels));
  };
  const auto edge = [](int p) {
    Random random{std::mt19937_64(static_cast<std::uint64_t>(p))};
    return edge_of(random);
  };
  std::vector<double> truth(static_cast<std::size_t>(pixels));
  for (int p = 0; p < pixels; ++p) {
    const Sampler s(99, p, 0, 0);
    truth[static_cast<std::size_t>(p)] =
        one_path(edge(p), 1 << 16, [&](int i) { return s.at(static_cast<std::uint32_t>(i)); });
  }
  const auto exact = [&](int p) { return truth[static_cast<std::size_t>(p)]; };
  for (int m = 1; 16 * m * m <= largest; m *= 2) {
    report("nested at random", 16 * (1 + m * (1 + m)), [&](int p) {
      Random random{std::mt19937_64(static_cast<std::uint64_t>(1000 + p))};
      return nested(edge(p), m, random) - exact(p);
    });
  }
  for (int count = 1; count <= largest; count *= 4) {
    report("one path a sample at random", 3 * count, [&](int p) {
      return one_path(edge(p), count, [&](int i) { return Sampler(3, p, i + 1, 0); }) - exact(p);
    });
    report("one path a sample by Owen-Sobol", 3 * count, [&](int p) {
      const Sampler s(5, p, 0, 0);
      return one_path(edge(p), count, [&](int i) { return s.at(static_cast<std::uint32_t>(i)); }) -
             exact(p);
    });
  }
}

}  // namespace
}  // namespace rt

int main(int argc, char** argv) {
  const int pixels = argc > 1 ? std::atoi(argv[1]) : 256;
  const int largest = argc > 2 ? std::atoi(argv[2]) : 1024;
  fmt::print("integral,sampler,count,rmse\n");
  rt::penumbras(pixels, largest);
  rt::paths(pixels, largest);
}
