#include "rt/render/accel/box_tree.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <mutex>
#include <new>
#include <span>

#include "../parallel.h"

namespace rt {
namespace {

RTCDevice device() {
  // One for the process; it holds no scene's data. It keeps the number of threads that it finds
  // when it is first wanted (with_threads), for building only.
  static RTCDevice shared = rtcNewDevice("set_affinity=0");
  return shared;
}

}  // namespace

/// Nodes as Embree's threads make them. Embree knows a node by a number in place of its address:
/// even, 2 index + 2; a single box: odd, 2 index + 1.
class BoxTree::Builder {
 public:
  /// Hierarchies over so many boxes have fewer nodes.
  explicit Builder(std::size_t boxes)
      : parts_(boxes / part_size + 1), made_(new std::once_flag[parts_.size()]) {}

  /// The root's index.
  std::uint32_t build(std::vector<RTCBuildPrimitive>& primitives) {
    RTCBuildArguments arguments = arguments_for(primitives);
    const std::unique_ptr<RTCBVHTy, void (*)(RTCBVH)> bvh(rtcNewBVH(device()), rtcReleaseBVH);
    arguments.bvh = bvh.get();
    const void* root = rtcBuildBVH(&arguments);
    if (root == nullptr || rtcGetDeviceError(device()) != RTC_ERROR_NONE) {
      throw std::bad_alloc();
    }
    return child_of(root);
  }

  /// All nodes, and lets go of them.
  std::vector<Node> take() {
    std::vector<Node> nodes;
    nodes.reserve(count_);
    for (std::unique_ptr<Node[]>& part : parts_) {
      const std::size_t rest = count_ - nodes.size();
      nodes.insert(nodes.end(), part.get(), part.get() + std::min(rest, part_size));
      part.reset();
    }
    return nodes;
  }

  std::uint32_t add() {
    const std::uint32_t index = count_++;
    std::call_once(made_[index / part_size], [&] {
      parts_[index / part_size] = std::make_unique_for_overwrite<Node[]>(part_size);
    });
    for (std::size_t lane = 0; lane < BoxGroup::width; ++lane) {
      set(index, lane, BoxSpace::nothing(), leaf);
    }
    return index;
  }

  void set(std::uint32_t node, std::size_t lane, const BoxSpace::Box& box, std::uint32_t child) {
    BoxSpace::put(at(node).boxes, lane, box);
    at(node).child[lane] = child;
  }

 private:
  static constexpr std::size_t part_size = 1024;

  static void* name(std::uint32_t node) {
    return reinterpret_cast<void*>((std::uintptr_t{node} + 1) << 1U);
  }
  static std::uint32_t child_of(const void* name) {
    const auto number = reinterpret_cast<std::uintptr_t>(name);
    const auto half = static_cast<std::uint32_t>(number >> 1U);
    return (number & 1U) != 0 ? leaf | half : half - 1;
  }
  Node& at(std::uint32_t node) { return parts_[node / part_size][node % part_size]; }

  static void* create_node(RTCThreadLocalAllocator, unsigned, void* builder) {
    return name(static_cast<Builder*>(builder)->add());
  }
  static void set_children(void* node, void** children, unsigned count, void* builder) {
    Node& to = static_cast<Builder*>(builder)->at(child_of(node));
    std::transform(children, children + count, to.child, child_of);
  }
  static void set_bounds(void* node, const RTCBounds** bounds, unsigned count, void* builder) {
    Node& to = static_cast<Builder*>(builder)->at(child_of(node));
    for (unsigned i = 0; i < count; ++i) {
      const RTCBounds& b = *bounds[i];
      BoxSpace::put(to.boxes, i,
                    {{b.lower_x, b.lower_y, b.lower_z}, {b.upper_x, b.upper_y, b.upper_z}});
    }
  }
  /// Up to eight boxes make a node.
  static void* create_leaf(RTCThreadLocalAllocator, const RTCBuildPrimitive* primitives,
                           std::size_t count, void* builder) {
    if (count == 1) {
      return reinterpret_cast<void*>((std::uintptr_t{primitives->primID} << 1U) | 1U);
    }
    auto& self = *static_cast<Builder*>(builder);
    const std::uint32_t node = self.add();
    for (const RTCBuildPrimitive& b : std::span(primitives, count)) {
      // By their indices, for Embree's threads leave them in any order.
      const auto before = std::count_if(primitives, primitives + count,
                                        [&](const auto& other) { return other.primID < b.primID; });
      self.set(node, static_cast<std::size_t>(before),
               {{b.lower_x, b.lower_y, b.lower_z}, {b.upper_x, b.upper_y, b.upper_z}},
               leaf | b.primID);
    }
    return name(node);
  }

  RTCBuildArguments arguments_for(std::vector<RTCBuildPrimitive>& primitives) {
    RTCBuildArguments a = rtcDefaultBuildArguments();
    a.maxBranchingFactor = BoxGroup::width;
    // A node tests its boxes all at once: as few as fit into one are divided no further, and so
    // many count as one elsewhere.
    a.minLeafSize = BoxGroup::width;
    a.maxLeafSize = BoxGroup::width;
    a.sahBlockSize = BoxGroup::width;
    a.primitives = primitives.data();
    a.primitiveCount = primitives.size();
    a.primitiveArrayCapacity = primitives.size();
    a.createNode = create_node;
    a.setNodeChildren = set_children;
    a.setNodeBounds = set_bounds;
    a.createLeaf = create_leaf;
    a.userPtr = this;
    return a;
  }

  std::vector<std::unique_ptr<Node[]>> parts_;
  std::unique_ptr<std::once_flag[]> made_;
  std::atomic<std::uint32_t> count_{0};
};

BoxTree::BoxTree(const std::vector<Bounds>& boxes)
    : BoxTree(all_of(boxes), boxes.size(), [&](std::uint32_t i) { return boxes[i]; }) {}

BoxTree::BoxTree(const Bounds& all, std::size_t count,
                 const std::function<Bounds(std::uint32_t)>& box)
    : space_(all) {
  Builder builder(count);
  if (count < 2) {
    if (count == 1) {
      builder.set(builder.add(), 0, space_.box(box(0)), leaf);
    }
  } else {
    std::vector<RTCBuildPrimitive> primitives(count);
    constexpr std::size_t block = 4096;
    for_each_index((count + block - 1) / block, [&](std::size_t part) {
      for (std::size_t i = part * block; i < std::min(count, (part + 1) * block); ++i) {
        const auto id = static_cast<std::uint32_t>(i);
        const BoxSpace::Box b = space_.box(box(id));
        primitives[i] = {b.lo[0], b.lo[1], b.lo[2], 0, b.hi[0], b.hi[1], b.hi[2], id};
      }
    });
    root_ = builder.build(primitives);
  }
  nodes_ = builder.take();
}

}  // namespace rt
