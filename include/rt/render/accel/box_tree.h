#pragma once
#include <algorithm>
#include <cstdint>
#include <functional>
#include <vector>

#include "rt/render/accel/box_group.h"

namespace rt {

/// A hierarchy over boxes that finds the candidates along a ray; which of them is hit, and where,
/// the caller decides in double precision. Embree builds it, by the surface area heuristic; nodes
/// of eight boxes are walked here, so that what is done with a candidate is compiled into the walk.
/// No candidate is lost (BoxSpace).
class BoxTree {
 public:
  /// Over box(i) for i < count, each asked for once, by several threads; `all` holds them all.
  /// Throws std::bad_alloc when memory runs out.
  BoxTree(const Bounds& all, std::size_t count, const std::function<Bounds(std::uint32_t)>& box);
  explicit BoxTree(const std::vector<Bounds>& boxes);

  /// Calls visit(index) -> double for every box whose part 0 <= t <= t_max the ray may touch,
  /// nearer ones mostly first. What it returns is the new t_max; a negative one ends the walk.
  template <class Visit>
  void walk(const Ray& ray, double t_max, Visit&& visit) const {
    BoxRay p;
    if (!nodes_.empty() && space_.enter(ray, glm::length(ray.direction), p)) {
      walk_from(p, t_max, visit);
    }
  }
  /// The same for a ray whose direction is a unit vector.
  template <class Visit>
  void walk_unit(const Ray& ray, double t_max, Visit&& visit) const {
    BoxRay p;
    if (!nodes_.empty() && space_.enter(ray, p)) {
      walk_from(p, t_max, visit);
    }
  }

  /// Calls visit(index) -> bool for every box that the shaft may touch, until that is false. False
  /// when the shaft could not be followed.
  template <class Visit>
  bool each_in(const Shaft& shaft, Visit&& visit) const {
    const auto b = space_.enter(shaft);
    if (!b || nodes_.empty()) {
      return b.has_value();
    }
    std::uint32_t stack[stack_size];
    int size = 0;
    stack[size++] = root_;
    while (size > 0) {
      const Node& node = nodes_[stack[--size]];
      for (unsigned hits = node.boxes.touched(*b); hits != 0; hits &= hits - 1) {
        const std::uint32_t child = node.child[std::countr_zero(hits)];
        if ((child & leaf) == 0) {
          stack[size++] = child;
        } else if (!visit(child & ~leaf)) {
          return true;
        }
      }
    }
    return true;
  }

  /// Several rays together: `rays` (packet_walk.h) says which of them may touch a group's boxes,
  /// and visit(index, lanes) is called for every box that some may; it returns their new limit,
  /// or null where that is the old one.
  template <class Rays, class Visit>
  void walk_together(Rays& rays, Visit& visit) const {
    struct Shared {
      float near;
      std::uint32_t child;
      unsigned lanes;
    };
    Shared stack[stack_size];
    int size = 0;
    Shared next{0.0F, root_, rays.before_end(rays.active(), 0.0F)};
    if (nodes_.empty() || next.lanes == 0) {
      return;
    }
    for (;;) {
      if ((next.child & leaf) == 0) {
        const Node& node = nodes_[next.child];
        const auto touched = rays.touched(node.boxes, next.lanes);
        if (touched.boxes != 0) {
          const auto child = [&](int box) {
            return Shared{touched.near[box], node.child[box], touched.lanes_at(box)};
          };
          next = nearest_of(touched.boxes, child, stack, size);
          continue;
        }
      } else if (const auto* shorter = visit(next.child & ~leaf, next.lanes)) {
        rays.limit(*shorter);
        if (rays.ended()) {
          return;
        }
      }
      do {
        if (size == 0) {
          return;
        }
        next = stack[--size];
        next.lanes = rays.before_end(next.lanes, next.near);
      } while (next.lanes == 0);
    }
  }

  /// Renumbers the boxes in the order of a walk through all of them. Box k is then what box order[k]
  /// was.
  std::vector<std::uint32_t> arrange();

  const BoxSpace& space() const { return space_; }
  std::size_t bytes() const { return nodes_.size() * sizeof(Node); }

 private:
  static constexpr std::uint32_t leaf = 1U << 31;
  /// Embree's deepest tree; each level leaves at most seven siblings behind.
  static constexpr int deepest = 40;
  static constexpr int stack_size = 7 * deepest + 8;

  struct Node {
    BoxGroup boxes;
    std::uint32_t child[BoxGroup::width];  ///< a node, or `leaf` + a box's index
  };
  struct Open {
    float near;
    std::uint32_t child;
  };
  class Builder;
  class Layout;

  template <class Visit>
  void walk_from(const BoxRay& ray, double t_max, Visit& visit) const {
    Open stack[stack_size];
    int size = 0;
    float limit = ray.limit(t_max);
    Open next{0.0F, root_};
    for (;;) {
      if ((next.child & leaf) == 0) {
        const Node& node = nodes_[next.child];
        alignas(32) float near[BoxGroup::width];
        const unsigned hits = node.boxes.touched(ray, limit, near);
        if (hits != 0) {
          next = nearest_of(
              hits, [&](int box) { return Open{near[box], node.child[box]}; }, stack, size);
          continue;
        }
      } else {
        t_max = visit(next.child & ~leaf);
        if (t_max < 0.0) {
          return;
        }
        limit = ray.limit(t_max);
      }
      do {
        if (size == 0) {
          return;
        }
        next = stack[--size];
      } while (next.near > limit);
    }
  }

  /// The nearest of a node's children in `hits`, not 0; the others come on the stack, nearer ones
  /// above. child(box) says what is kept of one.
  template <class Child, class Item>
  static Item nearest_of(unsigned hits, const Child& child, Item* stack, int& size) {
    const Item first = child(std::countr_zero(hits));
    hits &= hits - 1;
    if (hits == 0) {  // mostly they are one or two: those need no sorting
      return first;
    }
    const Item second = child(std::countr_zero(hits));
    hits &= hits - 1;
    const int begin = size;
    stack[size++] = first.near < second.near ? second : first;
    if (hits == 0) {
      return first.near < second.near ? first : second;
    }
    stack[size++] = first.near < second.near ? first : second;
    for (; hits != 0; hits &= hits - 1) {
      const Item next = child(std::countr_zero(hits));
      int place = size++;
      for (; place > begin && stack[place - 1].near < next.near; --place) {
        stack[place] = stack[place - 1];
      }
      stack[place] = next;
    }
    return stack[--size];
  }

  BoxSpace space_;
  std::uint32_t root_ = 0;
  std::vector<Node> nodes_;
};

}  // namespace rt
