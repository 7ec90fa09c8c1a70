#pragma once
/// The functions that bindings.cpp declares to scripts: each reads its arguments, makes a plain
/// value of rt/scene, and returns how many results it left on the stack.

namespace rt::lua {

class Call;

// methods.cpp
int node_add_child(Call& call);
int node_set_material(Call& call);
int node_translate(Call& call);
int node_rotate(Call& call);
int node_scale(Call& call);

// surfaces.cpp
int node_set_texture(Call& call);
int node_perlin_noise(Call& call);

// motion.cpp
int node_motion(Call& call);

// meshes.cpp, materials.cpp, textures.cpp, lights.cpp, render.cpp
int make_mesh(Call& call);
int make_material(Call& call);
int make_checker(Call& call);
int make_texture(Call& call);
int make_light(Call& call);
int render(Call& call);

// modules.cpp
int require_module(Call& call);
int run_file(Call& call);

}  // namespace rt::lua
