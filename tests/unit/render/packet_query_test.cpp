// What packets of rays meet, and what blocks them, is what each ray meets alone.
#include <gtest/gtest.h>

#include <random>

#include "packet_scenes.h"
#include "rt/render/packet/packet_query.h"
#include "rt/render/packet/packet_shading.h"
#include "rt/render/packet/packet_tracer.h"
#include "rt/render/query.h"

namespace rt {
namespace {

class Random {
 public:
  double uniform(double lo, double hi) {
    return lo + (hi - lo) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
  }
  Vec3 vector(double size) {
    return {uniform(-size, size), uniform(-size, size), uniform(-size, size)};
  }
  Vec3 direction() { return glm::normalize(vector(1)); }
  std::uint32_t below(std::size_t n) { return static_cast<std::uint32_t>(engine_() % n); }
  unsigned some_lanes() { return static_cast<unsigned>(engine_()) & all_lanes; }

 private:
  std::mt19937_64 engine_{5};
};

/// Rays from anywhere; what the lanes that are not active hold is no ray.
Packet from_anywhere(Random& random) {
  Packet packet;
  packet.active = random.some_lanes();
  for (int i = 0; i < lanes; ++i) {
    const bool active = (packet.active >> i & 1U) != 0;
    packet.ray.origin.set(i, active ? random.vector(8) : Vec3(NAN));
    packet.ray.direction.set(i, active ? random.direction() : Vec3(NAN));
  }
  return packet;
}

struct Tally {
  int hits = 0;
  int blocked = 0;
};

void compare(const RenderPlan& plan, const Packet& packet, Random& random, Tally& tally) {
  const PacketHits found = closest_hits(plan, packet);
  Wide t_max(0.0);
  for (std::size_t i = 0; i < lanes; ++i) {
    t_max[i] = random.uniform(-1, 15);
  }
  std::uint32_t last = no_instance;
  const unsigned blocked = occluded_lanes(plan, packet, t_max, last);
  EXPECT_EQ(blocked == 0, last == no_instance);
  ASSERT_EQ(blocked & ~packet.active, 0u);
  each_lane(packet.active, [&](int i) {
    const auto at = static_cast<std::size_t>(i);
    const SceneHit one = closest_hit(plan, packet.lane(i)).value_or(SceneHit{});
    ASSERT_EQ(found.instance[at], one.instance);
    if (one.instance != no_instance) {
      ++tally.hits;
      ASSERT_EQ(found.t[at], one.t);
      ASSERT_EQ(found.lane(i).feature, one.feature);
    }
    ASSERT_EQ((blocked >> i & 1U) != 0, occluded(plan, packet.lane(i), t_max[at]));
    tally.blocked += static_cast<int>(blocked >> i & 1U);
  });
}

/// The points that were met, and rays from them: anywhere, or along the surface.
void go_on(const RenderPlan& plan, const Packet& packet, Random& random, Tally& tally) {
  const PacketHits found = closest_hits(plan, packet);
  const unsigned bits = packet.active & ~lanes_where(found.instance, no_instance);
  if (bits == 0) {
    return;
  }
  const WideShadingPoint from = shading_points(plan, packet, found, bits);
  Wide3 direction;
  for (int i = 0; i < lanes; ++i) {
    const Vec3 any = random.direction();
    const Vec3 along = glm::cross(from.normal.lane(i), any) + 1e-7 * random.direction();
    direction.set(i, random.uniform(0, 1) < 0.5 ? any : glm::normalize(along));
  }
  const Packet next = leave(from, direction, bits);
  each_lane(bits, [&](int i) {
    const auto at = static_cast<std::size_t>(i);
    const ShadingPoint one = shading_point(plan, packet.lane(i), found.lane(i));
    ASSERT_EQ(from.position.lane(i), one.position);
    ASSERT_EQ(from.normal.lane(i), one.normal);
    ASSERT_EQ(from.shading_normal.lane(i), one.shading_normal);
    ASSERT_EQ(from.lane(i).position_error, one.position_error);
    ASSERT_EQ(next.lane(i).leaving, leave(one, direction.lane(i)).leaving);
    ASSERT_EQ(next.lane(i).instance, found.instance[at]);
  });
  compare(plan, next, random, tally);
}

TEST(PacketQuery, AnswersAsForEachRayAlone) {
  for (const test::PacketScene& scene : test::packet_scenes()) {
    for (const AccelChoice accel : {AccelChoice::automatic, AccelChoice::none, AccelChoice::grid,
                                    AccelChoice::list, AccelChoice::bvh}) {
      RenderJob job = scene.job;
      job.options.accel = accel;
      const RenderPlan plan = make_plan(job);
      // In render space, whose origin is the eye.
      const Vec3 centre = job.instances[1].world_from_model.offset - job.camera.eye;
      Random random;
      Tally tally;
      for (int k = 0; k < 400; ++k) {
        Packet packet = from_anywhere(random);
        packet.ray.origin += Wide3(centre);
        compare(plan, packet, random, tally);
        go_on(plan, packet, random, tally);
        ASSERT_FALSE(HasFatalFailure()) << scene.name << ", search " << static_cast<int>(accel);
      }
      EXPECT_GT(tally.hits, 400) << scene.name;
      EXPECT_GT(tally.blocked, 10) << scene.name;
    }
  }
}

/// A point of some edge of the mesh, within rounding error or exactly.
Vec3 near_an_edge(const MeshData& mesh, double error, Random& random) {
  const Corners& corners = mesh.triangles[random.below(mesh.triangles.size())];
  const std::size_t first = random.below(3);
  const Vec3& a = mesh.positions[corners[first]];
  const Vec3& b = mesh.positions[corners[(first + 1) % 3]];
  const double along = random.below(4) == 0 ? 0.0 : random.uniform(0, 1);
  return a + along * (b - a) + static_cast<double>(random.below(3)) * random.vector(error);
}

// From near and from a million sizes away, where the points met are off by a billionth.
TEST(PacketQuery, AnswersAsForEachRayAloneAtTheEdgesOfTriangles) {
  for (const double away : {0.0, 1e6}) {
    RenderJob job = test::fine_mesh_scene();
    job.camera.eye += away * Vec3(1, 0.3, -0.7);
    const RenderPlan plan = make_plan(job);
    Random random;
    Tally tally;
    for (int k = 0; k < 3000; ++k) {
      const Instance mesh = job.instances[1 + random.below(5)];
      Packet packet;
      packet.active = all_lanes;
      for (int i = 0; i < lanes; ++i) {
        const Vec3 in_model =
            near_an_edge(*std::get<Mesh>(*mesh.shape).data, 1e-15 * (1.0 + away), random);
        const Vec3 target = mesh.world_from_model.point(in_model) - job.camera.eye;
        const Vec3 back = random.direction();
        packet.ray.origin.set(i, target + back);
        packet.ray.direction.set(i, -back);
      }
      compare(plan, packet, random, tally);
      go_on(plan, packet, random, tally);
      ASSERT_FALSE(HasFatalFailure()) << "from " << away;
    }
    EXPECT_GT(tally.hits, 3000 * lanes);
  }
}

// A ray through an edge meets both triangles at one distance, to the last bit where they are level.
TEST(PacketQuery, OfTrianglesMetAtOnceTheLowestCounts) {
  constexpr std::uint32_t edge = 12;
  auto data = std::make_shared<MeshData>();
  for (std::uint32_t i = 0; i <= edge; ++i) {
    for (std::uint32_t j = 0; j <= edge; ++j) {
      data->positions.emplace_back(i, 0, j);
      if (i < edge && j < edge) {
        const std::uint32_t a = i * (edge + 1) + j;
        data->triangles.push_back({a, a + 1, a + edge + 1});
        data->triangles.push_back({a + 1, a + edge + 2, a + edge + 1});
      }
    }
  }
  Random random;
  for (std::size_t i = data->triangles.size(); i > 1; --i) {
    std::swap(data->triangles[i - 1], data->triangles[random.below(i)]);
  }
  RenderJob job = test::bare_job();
  test::add(job, Mesh{data}, {}, test::matt(Rgb(1.0)));
  job.camera.eye = Vec3(0.0);
  const RenderPlan plan = make_plan(job);
  Tally tally;
  for (int k = 0; k < 1000; ++k) {
    Packet packet;
    packet.active = all_lanes;
    const Vec3 corner(1.0 + random.below(edge - 2), 0, 1.0 + random.below(edge - 2));
    for (int i = 0; i < lanes; ++i) {  // corners, middles of edges and of diagonals
      const Vec3 there = corner + 0.5 * Vec3(random.below(3), 0, random.below(3));
      packet.ray.origin.set(i, there + Vec3(0, 3, 0));
      packet.ray.direction.set(i, Vec3(0, -1, 0));
    }
    compare(plan, packet, random, tally);
    ASSERT_FALSE(HasFatalFailure());
  }
  EXPECT_EQ(tally.hits, 1000 * lanes);
}

}  // namespace
}  // namespace rt
