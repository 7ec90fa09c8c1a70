#pragma once
/// Scenes with all that packets serve, for comparison with one ray at a time.
#include <string>
#include <vector>

#include "pictures.h"
#include "probe.h"

namespace rt::test {

struct PacketScene {
  std::string name;
  RenderJob job;
};

/// Balls, a box and a torus of glass: in each other, touching, half opaque, with gloss.
RenderJob glass_scene();
/// Mirrors that spread, under a spherical and a rectangular light.
RenderJob gloss_scene();
/// Pictures, checkers, noise, bumps and normal maps.
RenderJob textured_scene();
/// Meshes whose shading normals are not the geometric ones: mirror, glass and matt.
RenderJob mesh_scene();
/// Meshes of some hundred triangles each, likewise.
RenderJob fine_mesh_scene();
/// Coloured glass: nested, in water, behind mirrors.
RenderJob absorbing_scene(double water_level);
/// Shapes of all kinds, lights and the camera move; textured, mirrors and glass among them.
RenderJob moving_scene();
/// Surfaces that coincide: equal balls, boxes face to face, a box on a plane.
RenderJob coincident_scene();
/// More shapes than a list holds, turned, stretched and mirrored.
RenderJob crowded_scene();

/// All of these and variations: a lens, a camera far away, lights in odd places.
std::vector<PacketScene> packet_scenes();

}  // namespace rt::test
