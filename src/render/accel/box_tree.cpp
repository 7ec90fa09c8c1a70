#include "rt/render/accel/box_tree.h"

#include <embree3/rtcore.h>

#include <memory>
#include <new>

namespace rt {
namespace {

RTCDevice device() {
  // One for the process; it holds no scene's data. It keeps the number of threads that it finds
  // when it is first wanted (with_threads), for building only.
  static RTCDevice shared = rtcNewDevice("set_affinity=0");
  return shared;
}

/// A node as Embree builds it. Children are BuildNodes, or leaves: odd numbers, 2 index + 1.
struct BuildNode {
  unsigned count = 0;
  void* children[BoxGroup::width] = {};
  RTCBounds bounds[BoxGroup::width] = {};
};

bool is_leaf(const void* child) { return (reinterpret_cast<std::uintptr_t>(child) & 1U) != 0; }

std::uint32_t index_of(const void* leaf) {
  return static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(leaf) >> 1U);
}

void* create_node(RTCThreadLocalAllocator allocator, unsigned, void*) {
  return new (rtcThreadLocalAlloc(allocator, sizeof(BuildNode), alignof(BuildNode))) BuildNode;
}

void set_children(void* node, void** children, unsigned count, void*) {
  auto& to = *static_cast<BuildNode*>(node);
  to.count = count;
  std::copy_n(children, count, to.children);
}

void set_bounds(void* node, const RTCBounds** bounds, unsigned count, void*) {
  for (unsigned i = 0; i < count; ++i) {
    static_cast<BuildNode*>(node)->bounds[i] = *bounds[i];
  }
}

void* create_leaf(RTCThreadLocalAllocator, const RTCBuildPrimitive* primitives, std::size_t,
                  void*) {
  return reinterpret_cast<void*>((std::uintptr_t{primitives->primID} << 1U) | 1U);
}

RTCBuildArguments arguments_for(std::vector<RTCBuildPrimitive>& primitives) {
  RTCBuildArguments a = rtcDefaultBuildArguments();
  a.maxBranchingFactor = BoxGroup::width;
  a.maxLeafSize = 1;
  a.primitives = primitives.data();
  a.primitiveCount = primitives.size();
  a.primitiveArrayCapacity = primitives.size();
  a.createNode = create_node;
  a.setNodeChildren = set_children;
  a.setNodeBounds = set_bounds;
  a.createLeaf = create_leaf;
  return a;
}

}  // namespace

/// Copies Embree's nodes, parents before children.
struct BoxTree::Builder {
  std::vector<Node>& nodes;

  std::uint32_t add() {
    Node node;
    for (std::size_t lane = 0; lane < BoxGroup::width; ++lane) {
      BoxSpace::put(node.boxes, lane, BoxSpace::nothing());
      node.child[lane] = leaf;
    }
    nodes.push_back(node);
    return static_cast<std::uint32_t>(nodes.size() - 1);
  }

  void set(std::uint32_t node, std::size_t lane, const BoxSpace::Box& box, std::uint32_t child) {
    BoxSpace::put(nodes[node].boxes, lane, box);
    nodes[node].child[lane] = child;
  }

  void copy(const BuildNode& root) {
    std::vector<std::pair<const BuildNode*, std::uint32_t>> open{{&root, add()}};
    while (!open.empty()) {
      const auto [from, to] = open.back();
      open.pop_back();
      for (unsigned i = 0; i < from->count; ++i) {
        const RTCBounds& b = from->bounds[i];
        const BoxSpace::Box box{{b.lower_x, b.lower_y, b.lower_z},
                                {b.upper_x, b.upper_y, b.upper_z}};
        if (is_leaf(from->children[i])) {
          set(to, i, box, leaf | index_of(from->children[i]));
        } else {
          const std::uint32_t child = add();
          set(to, i, box, child);
          open.emplace_back(static_cast<const BuildNode*>(from->children[i]), child);
        }
      }
    }
  }
};

BoxTree::BoxTree(const std::vector<Bounds>& boxes) : space_(boxes) {
  std::vector<RTCBuildPrimitive> primitives(boxes.size());
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    const BoxSpace::Box b = space_.box(boxes[i]);
    primitives[i] = {b.lo[0], b.lo[1], b.lo[2], 0, b.hi[0], b.hi[1], b.hi[2], i};
  }
  Builder builder{nodes_};
  if (boxes.size() < 2) {
    if (!boxes.empty()) {
      builder.set(builder.add(), 0, space_.box(boxes[0]), leaf);
    }
    return;
  }
  RTCBuildArguments arguments = arguments_for(primitives);
  const std::unique_ptr<RTCBVHTy, void (*)(RTCBVH)> bvh(rtcNewBVH(device()), rtcReleaseBVH);
  arguments.bvh = bvh.get();
  const void* root = rtcBuildBVH(&arguments);
  if (root == nullptr || rtcGetDeviceError(device()) != RTC_ERROR_NONE) {
    throw std::bad_alloc();
  }
  builder.copy(*static_cast<const BuildNode*>(root));
}

}  // namespace rt
