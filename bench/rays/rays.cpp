/// Rays per second against those of bare Embree, on the same rays, one thread, in turns, as CSV:
///
///   bench_rays PRIMITIVES PICTURE_EDGE ROUNDS
///
/// Ours find hits in double precision, with nothing added to t; Embree finds triangles in single
/// precision, balls by leaves in double. `agreeing` is the share of rays of which both say that
/// they hit or miss, hits within a thousandth of the subject's size.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "common/job.h"
#include "rays/embree.h"
#include "rays/scenes.h"
#include "rt/render/packet/packet_query.h"
#include "rt/render/query.h"
#include "rt/render/threads.h"

namespace rt::bench {
namespace {

constexpr double same_hit = 4e-3;

/// The answer to ray i: a distance, infinite for none; for shadow rays 0 or infinity.
template <class Answer>
double timed(const Rays& rays, std::vector<double>& answers, const Answer& answer) {
  const double begin = thread_seconds();
  for (std::size_t i = 0; i < rays.rays.size(); ++i) {
    answers[i] = answer(rays.rays[i], rays.reach.empty() ? INFINITY : rays.reach[i]);
  }
  return thread_seconds() - begin;
}

/// The camera's rays in packets, as the renderer takes them where it can.
std::vector<Packet> packets_of(const std::vector<TraceRay>& rays) {
  std::vector<Packet> packets((rays.size() + lanes - 1) / lanes);
  for (std::size_t i = 0; i < lanes * packets.size(); ++i) {
    const TraceRay& ray = rays[std::min(i, rays.size() - 1)];
    Packet& packet = packets[i / lanes];
    packet.ray.origin.set(static_cast<int>(i % lanes), ray.origin);
    packet.ray.direction.set(static_cast<int>(i % lanes), ray.direction);
    packet.active = all_lanes;
  }
  return packets;
}

double timed(const RenderPlan& plan, const std::vector<Packet>& packets,
             std::vector<double>& answers) {
  const double begin = thread_seconds();
  for (std::size_t i = 0; i < answers.size(); i += lanes) {
    const PacketHits hits = closest_hits(plan, packets[i / lanes]);
    for (std::size_t k = i; k < std::min(i + lanes, answers.size()); ++k) {
      answers[k] = hits.t[k - i];
    }
  }
  return thread_seconds() - begin;
}

double agreeing(const std::vector<double>& a, const std::vector<double>& b) {
  std::size_t same = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    same += a[i] == b[i] || std::abs(a[i] - b[i]) < same_hit ? 1 : 0;
  }
  return static_cast<double>(same) / static_cast<double>(std::max<std::size_t>(a.size(), 1));
}

struct Timed {
  double seconds;
  std::vector<double> answers;
};

void print(const char* name, const Subject& subject, const char* kind, const Timed& own,
           const Timed& theirs) {
  const auto count = static_cast<double>(own.answers.size());
  fmt::print("{},{},{},{},{:.6g},{:.6g},{:.6f}\n", name,
             subject.mesh ? subject.mesh->triangles.size() : subject.balls.size(), kind, count,
             count / own.seconds, count / theirs.seconds, agreeing(own.answers, theirs.answers));
}

void compare_once(const char* name, const Subject& subject, const RenderPlan& plan,
                  const RawEmbree& embree, const Rays& rays) {
  const bool shadow = !rays.reach.empty();
  Timed own{0.0, std::vector<double>(rays.rays.size())};
  Timed theirs = own;
  own.seconds = timed(rays, own.answers, [&](const TraceRay& ray, double reach) {
    if (shadow) {
      return occluded(plan, ray, reach) ? 0.0 : INFINITY;
    }
    const auto hit = closest_hit(plan, ray);
    return hit ? hit->t : INFINITY;
  });
  theirs.seconds = timed(rays, theirs.answers, [&](const TraceRay& ray, double reach) {
    return shadow ? (embree.occluded(ray, reach) ? 0.0 : INFINITY) : double{embree.closest(ray)};
  });
  print(name, subject, rays.kind, own, theirs);
  if (!shadow && rays.rays[0].instance == no_instance) {
    const std::vector<Packet> packets = packets_of(rays.rays);
    own.seconds = timed(plan, packets, own.answers);
    print(name, subject, "camera (ours in packets)", own, theirs);
  }
}

void compare(const char* name, const Subject& subject, int edge, int rounds) {
  const RenderJob job = job_of(subject, edge);
  const RenderPlan plan = make_plan(job);
  const RawEmbree embree(subject, job.camera.eye);
  const std::vector<Rays> kinds = rays_through(plan, edge);
  for (int round = 0; round < rounds; ++round) {
    for (const Rays& rays : kinds) {
      compare_once(name, subject, plan, embree, rays);
    }
  }
}

}  // namespace
}  // namespace rt::bench

int main(int argc, char** argv) {
  if (argc != 4) {
    fmt::print(stderr, "usage: bench_rays PRIMITIVES PICTURE_EDGE ROUNDS\n");
    return 2;
  }
  using namespace rt::bench;
  const int count = std::stoi(argv[1]);
  const int edge = std::stoi(argv[2]);
  const int rounds = std::stoi(argv[3]);
  fmt::print("subject,primitives,kind,rays,own,embree,agreeing\n");
  rt::with_threads(1, [&] {
    compare("balls", cloud_of_balls(count), edge, rounds);
    compare("mesh", rippled_sheet(count), edge, rounds);
  });
}
