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

/// Lays nodes out in the order of a walk through all of them, each before what is below it: what is
/// found together lies together. On the way a node takes the boxes of a child in the child's place
/// where it has room: it tests eight at the price of one.
class BoxTree::Layout {
 public:
  explicit Layout(const std::vector<Node>& from) : from_(from) {
    nodes_.reserve(from.size());
  }

  /// A node and all below it; its new index.
  std::uint32_t put(std::uint32_t index) {
    const auto to = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back(from_[index]);
    join(nodes_.back());
    for (unsigned rest = BoxSpace::filled(nodes_[to].boxes); rest != 0; rest &= rest - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(rest));
      if ((nodes_[to].child[lane] & leaf) == 0) {
        const std::uint32_t below = put(nodes_[to].child[lane]);
        nodes_[to].child[lane] = below;
      }
    }
    return to;
  }

  std::vector<Node> take() {
    nodes_.shrink_to_fit();
    return std::move(nodes_);
  }

 private:
  void join(Node& node) const {
    for (;;) {
      const unsigned used = BoxSpace::filled(node.boxes);
      const int lane = largest_that_fits(node, used);
      if (lane < 0) {
        return;
      }
      const Node& child = from_[node.child[lane]];
      unsigned free = (~used & 0xffU) | 1U << lane;
      for (unsigned rest = BoxSpace::filled(child.boxes); rest != 0; rest &= rest - 1) {
        const int to = std::countr_zero(free);
        const int at = std::countr_zero(rest);
        free &= free - 1;
        for (std::size_t k = 0; k < 3; ++k) {
          node.boxes.lo[k][to] = child.boxes.lo[k][at];
          node.boxes.hi[k][to] = child.boxes.hi[k][at];
        }
        node.child[to] = child.child[at];
      }
    }
  }

  /// Of the children whose boxes all find room that with the largest surface, which most rays would
  /// ask for; -1: none.
  int largest_that_fits(const Node& node, unsigned used) const {
    const int room = static_cast<int>(BoxGroup::width) - std::popcount(used) + 1;
    int best = -1;
    float most = 0.0F;
    for (unsigned rest = used; rest != 0; rest &= rest - 1) {
      const int lane = std::countr_zero(rest);
      const std::uint32_t child = node.child[lane];
      if ((child & leaf) != 0 ||
          std::popcount(BoxSpace::filled(from_[child].boxes)) > room) {
        continue;
      }
      const auto edge = [&](std::size_t k) {
        return node.boxes.hi[k][lane] - node.boxes.lo[k][lane];
      };
      const float surface = edge(0) * edge(1) + edge(1) * edge(2) + edge(2) * edge(0);
      if (best < 0 || surface > most) {
        best = lane;
        most = surface;
      }
    }
    return best;
  }

  const std::vector<Node>& from_;
  std::vector<Node> nodes_;
};

std::vector<std::uint32_t> BoxTree::arrange() {
  std::vector<std::uint32_t> order;
  for (Node& node : nodes_) {
    for (unsigned rest = BoxSpace::filled(node.boxes); rest != 0; rest &= rest - 1) {
      std::uint32_t& child = node.child[std::countr_zero(rest)];
      if ((child & leaf) != 0) {
        order.push_back(child & ~leaf);
        child = leaf | static_cast<std::uint32_t>(order.size() - 1);
      }
    }
  }
  return order;
}

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
  const std::vector<Node> nodes = builder.take();
  if (!nodes.empty()) {
    Layout layout(nodes);
    root_ = layout.put(root_);
    nodes_ = layout.take();
  }
}

}  // namespace rt
