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

}  // namespace
}  // namespace rt
