#include "rt/scene/instance_list.h"

#include <algorithm>
#include <array>
#include <bit>
#include <functional>
#include <stdexcept>

#include "rt/math/hash.h"

namespace rt {
namespace {

constexpr std::size_t recent = 256;

constexpr std::uint32_t none = ~0U;

constexpr int numbers_of_map = 12;
constexpr std::array diagonal{0, 4, 8};

double& number(Affine& map, int i) { return i < 9 ? map.linear[i / 3][i % 3] : map.offset[i - 9]; }

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

}  // namespace

template <class T>
std::uint32_t SharedValues<T>::add(const std::shared_ptr<const T>& value) {
  recent_.resize(recent, none);
  std::uint32_t& last = recent_[mix64(reinterpret_cast<std::uintptr_t>(value.get())) % recent];
  if (last == none || values_[last] != value) {
    last = static_cast<std::uint32_t>(values_.size());
    values_.push_back(value);
  }
  return last;
}

void InstanceList::push_back(const Instance& instance) { records_.push_back(recorded(instance)); }

InstanceList::Record InstanceList::recorded(const Instance& instance) {
  Record record{.name = named(instance.name),
                .numbers = static_cast<std::uint32_t>(numbers_.size()),
                .shape = shapes_.add(instance.shape),
                .material = materials_.add(instance.material),
                .textures = textures_.add(instance.textures),
                .motion = motions_.add(instance.motion),
                .kept = 0,
                .even = false};
  Affine map = instance.world_from_model;
  Affine identity;
  record.even = std::ranges::all_of(
      diagonal, [&](int i) { return same_bits(number(map, i), number(map, diagonal[0])); });
  for (int i = 0; i < numbers_of_map; ++i) {
    const bool repeats = record.even && (i == diagonal[1] || i == diagonal[2]);
    if (!repeats && !same_bits(number(map, i), number(identity, i))) {
      record.kept = static_cast<std::uint16_t>(record.kept | 1U << i);
      numbers_.push_back(number(map, i));
    }
  }
  return record;
}

std::uint32_t InstanceList::named(const std::string& name) {
  recent_names_.resize(recent, none);
  std::uint32_t& last = recent_names_[std::hash<std::string>{}(name) % recent];
  if (last == none || name != names_.c_str() + last) {
    if (names_.size() + name.size() >= none) {
      return 0;  // names are for messages: beyond 4 GB of them, another will do
    }
    last = static_cast<std::uint32_t>(names_.size());
    names_.append(name.c_str()).push_back('\0');
  }
  return last;
}

Instance InstanceList::operator[](std::size_t index) const {
  const Record& record = records_[index];
  Instance instance{{},
                    shapes_[record.shape],
                    materials_[record.material],
                    textures_[record.textures],
                    names_.c_str() + record.name,
                    motions_[record.motion]};
  Affine& map = instance.world_from_model;
  std::size_t next = record.numbers;
  for (int i = 0; i < numbers_of_map; ++i) {
    if ((record.kept >> i & 1) != 0) {
      number(map, i) = numbers_[next++];
    }
  }
  if (record.even) {
    number(map, diagonal[1]) = number(map, diagonal[2]) = number(map, diagonal[0]);
  }
  return instance;
}

std::size_t InstanceList::bytes() const {
  return records_.size() * sizeof(Record) + numbers_.size() * sizeof(double) + names_.size() +
         shapes_.bytes() + materials_.bytes() + textures_.bytes() + motions_.bytes();
}

Instance InstanceList::at(std::size_t index) const {
  if (index >= size()) {
    throw std::out_of_range("there is no such instance");
  }
  return (*this)[index];
}

}  // namespace rt
