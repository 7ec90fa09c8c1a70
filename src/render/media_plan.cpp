#include "media_plan.h"

#include <algorithm>

namespace rt {
namespace {

struct Medium {
  std::uint32_t id;
  std::uint32_t order;
  Bounds box;
  double volume;
};

bool meet(const Bounds& a, const Bounds& b) {
  return a.lo.x <= b.hi.x && b.lo.x <= a.hi.x && a.lo.y <= b.hi.y && b.lo.y <= a.hi.y &&
         a.lo.z <= b.hi.z && b.lo.z <= a.hi.z;
}

double volume(const Bounds& b) {
  const Vec3 e = b.extent();
  return e.x * e.y * e.z;
}

/// The transmissive instances, by where their boxes begin in x.
std::vector<Medium> media_of(const RenderPlan& plan) {
  std::vector<Medium> media;
  for (std::uint32_t id = 0; id < plan.instances.size(); ++id) {
    const PlannedInstance& instance = plan.instances[id];
    if (!instance.clear) {
      continue;
    }
    const Bounds box = box_of(plan, instance);
    if (!box.empty()) {
      media.push_back({id, instance.order, box, volume(box)});
    }
  }
  std::ranges::sort(media, {}, [](const Medium& m) { return m.box.lo.x; });
  return media;
}

}  // namespace

void find_media(RenderPlan& plan) {
  const std::vector<Medium> media = media_of(plan);
  if (media.empty()) {
    return;
  }
  double widest = 0.0;
  for (const Medium& m : media) {
    widest = std::max(widest, m.box.extent().x);
  }
  std::vector<const Medium*> found;
  plan.media_ranges.resize(plan.instances.size());
  for (std::uint32_t id = 0; id < plan.instances.size(); ++id) {
    const PlannedInstance& instance = plan.instances[id];
    found.clear();
    if (plan.absorbs || instance.clear) {
      const Bounds box = box_of(plan, instance);
      // None that begins further left than the widest is wide can reach the box.
      auto m = std::ranges::lower_bound(media, box.lo.x - widest, {},
                                        [](const Medium& e) { return e.box.lo.x; });
      for (; m != media.end() && m->box.lo.x <= box.hi.x; ++m) {
        if (meet(m->box, box)) {
          found.push_back(&*m);
        }
      }
    }
    std::ranges::sort(found, [](const Medium* a, const Medium* b) {
      return a->volume != b->volume ? a->volume < b->volume : a->order > b->order;
    });
    const auto begin = static_cast<std::uint32_t>(plan.media.size());
    for (const Medium* m : found) {
      plan.media.push_back(m->id);
    }
    plan.media_ranges[id] = {begin, static_cast<std::uint32_t>(plan.media.size())};
  }
}

}  // namespace rt
