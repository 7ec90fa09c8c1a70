#include "rt/scene/instance_list.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

namespace rt {
namespace {

TEST(InstanceList, GivesBackWhatItWasGiven) {
  const auto ball = std::make_shared<const Shape>(Sphere{});
  const auto box = std::make_shared<const Shape>(Box{});
  const auto red = std::make_shared<const Material>();
  const auto textures = std::make_shared<const TextureSet>();
  const auto path = std::make_shared<const MotionPath>();
  const Affine maps[] = {{},
                         Affine::translation({1, -0.0, 1e-300}),
                         Affine::scaling(Vec3(-0.0)),
                         Affine::scaling(Vec3(3.0)),
                         Affine::scaling({1, 2, 2}),
                         Affine::rotation(1, 33) * Affine::translation({1, 2, 3})};
  InstanceList list;
  for (int round = 0; round < 300; ++round) {
    for (const Affine& map : maps) {
      list.push_back({map, round % 2 == 0 ? ball : box, red, round % 3 == 0 ? textures : nullptr,
                      fmt::format("n{}", round), round % 5 == 0 ? path : nullptr});
    }
  }
  ASSERT_EQ(list.size(), 300 * std::size(maps));
  std::size_t i = 0;
  for (const Instance& instance : list) {
    const Affine& map = maps[i % std::size(maps)];
    const std::size_t round = i / std::size(maps);
    EXPECT_EQ(instance.world_from_model.linear, map.linear);
    EXPECT_EQ(instance.world_from_model.offset, map.offset);
    EXPECT_EQ(std::signbit(instance.world_from_model.offset.y), std::signbit(map.offset.y));
    EXPECT_EQ(std::signbit(instance.world_from_model.linear[2][2]), std::signbit(map.linear[2][2]));
    EXPECT_EQ(instance.shape, round % 2 == 0 ? ball : box);
    EXPECT_EQ(instance.material, red);
    EXPECT_EQ(instance.textures, round % 3 == 0 ? textures : nullptr);
    EXPECT_EQ(instance.name, fmt::format("n{}", round));
    EXPECT_EQ(instance.motion, round % 5 == 0 ? path : nullptr);
    ++i;
  }
  EXPECT_THROW(static_cast<void>(list.at(list.size())), std::out_of_range);
}

TEST(InstanceList, ReplacesOne) {
  InstanceList list;
  const auto ball = std::make_shared<const Shape>(Sphere{});
  for (const char* name : {"a", "b", "c"}) {
    list.push_back({Affine::translation({1, 2, 3}), ball, nullptr, nullptr, name});
  }
  Instance moved = list[1];
  moved.world_from_model.offset = {4, 5, 6};
  list.replace(1, moved);
  EXPECT_EQ(list[0].world_from_model.offset, Vec3(1, 2, 3));
  EXPECT_EQ(list[1].world_from_model.offset, Vec3(4, 5, 6));
  EXPECT_EQ(list[2].world_from_model.offset, Vec3(1, 2, 3));
  EXPECT_EQ(list[1].name, "b");
}

}  // namespace
}  // namespace rt
