#pragma once
/// The shapes of a scene, each placed in the world.
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "rt/geometry/shape.h"
#include "rt/math/transform.h"
#include "rt/scene/material.h"
#include "rt/scene/motion.h"
#include "rt/scene/texture_set.h"

namespace rt {

/// One shape placed in the world.
struct Instance {
  Affine world_from_model;             ///< has an inverse
  std::shared_ptr<const Shape> shape;  ///< shared by the instances of one node
  std::shared_ptr<const Material> material;
  std::shared_ptr<const TextureSet> textures;  ///< null: all is the material's
  std::string name;
  /// Null: still. Else world_from_model over the shutter's time; the map above is that at 0.
  std::shared_ptr<const MotionPath> motion = nullptr;
};

/// Values of which many instances share one. Equal ones are found again while others between them
/// are few.
template <class T>
class SharedValues {
 public:
  std::uint32_t add(const std::shared_ptr<const T>& value);
  /// What add() was given.
  const std::shared_ptr<const T>& operator[](std::uint32_t index) const { return values_[index]; }
  std::size_t bytes() const { return values_.size() * sizeof(values_[0]); }

 private:
  std::vector<std::shared_ptr<const T>> values_;
  std::vector<std::uint32_t> recent_;  ///< by a hash of the address
};

/// Instances in a few bytes each: of maps only those numbers are kept that differ from the
/// identity's, of values and names that many share one.
class InstanceList {
 public:
  void reserve(std::size_t count) { records_.reserve(count); }
  void push_back(const Instance& instance);
  void replace(std::size_t index, const Instance& instance) {
    records_.at(index) = recorded(instance);
  }

  std::size_t size() const { return records_.size(); }
  bool empty() const { return records_.empty(); }
  /// What it takes, without what shared values point to.
  std::size_t bytes() const;
  Instance operator[](std::size_t index) const;
  Instance at(std::size_t index) const;
  Instance back() const { return (*this)[size() - 1]; }

  class Iterator {
   public:
    Iterator(const InstanceList& list, std::size_t index) : list_(&list), index_(index) {}
    Instance operator*() const { return (*list_)[index_]; }
    Iterator& operator++() {
      ++index_;
      return *this;
    }
    bool operator==(const Iterator& other) const { return index_ == other.index_; }

   private:
    const InstanceList* list_;
    std::size_t index_;
  };
  Iterator begin() const { return {*this, 0}; }
  Iterator end() const { return {*this, size()}; }

 private:
  struct Record {
    std::uint32_t name;     ///< where it begins in names_
    std::uint32_t numbers;  ///< where those of its map begin in numbers_
    std::uint32_t shape, material, textures, motion;
    std::uint16_t kept;  ///< bit i: number i of the map is in numbers_
    bool even;           ///< the diagonal's numbers are all as the first
  };

  Record recorded(const Instance& instance);
  std::uint32_t named(const std::string& name);

  std::vector<Record> records_;
  std::vector<double> numbers_;
  SharedValues<Shape> shapes_;
  SharedValues<Material> materials_;
  SharedValues<TextureSet> textures_;
  SharedValues<MotionPath> motions_;
  std::string names_;                        ///< each ends with a zero
  std::vector<std::uint32_t> recent_names_;  ///< where they begin, by a hash
};

}  // namespace rt
