#!/usr/bin/env python3
"""Renders a scene of bench/scenes with Mitsuba 3, in the peers' terms of light.

usage: PYTHON bench/mitsuba_peer.py SCENE WxH SAMPLES PASSES SEED OUT.pfm

PYTHON must be one that has mitsuba (pip install mitsuba in a virtual environment). The picture is the
mean of PASSES, each of SAMPLES a pixel by the multijitter sampler. Prints processor seconds of
loading, of a first pass (which compiles the kernel) and of the passes of the picture, as JSON.

Mitsuba finds the hits: it intersects, tests shadows and runs the kernel that Dr.Jit compiles from the
loop below. Its own materials and lights would give another picture (1/d^2 falloff, no ambient term).
Not comparable all the same: it computes in single precision; planes are squares of 2e4 units, tori
meshes of 2 x 128 x 64 triangles with normals of their own; glass and checkers are not brought over.
"""
import json
import math
import os
import pathlib
import struct
import sys
import tempfile
import time

# Kernels are kept in the home folder: compile them anew, and leave nothing there.
scratch = tempfile.TemporaryDirectory()
os.environ["HOME"] = scratch.name

import drjit as dr  # noqa: E402
import mitsuba as mi  # noqa: E402

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import peers  # noqa: E402

mi.set_variant("llvm_ad_rgb")
dr.set_thread_count(1)
FAR = 1e4
RING, TUBE = 128, 64  # quads of a torus


# --- geometry ------------------------------------------------------------------------------------

def torus_file(centre, axis, major, minor, path):
    """A PLY of the torus with its exact normals."""
    axis = peers.unit(axis)
    u, w = peers.basis(axis)
    vertices = []
    for i in range(RING):
        a = 2 * math.pi * i / RING
        out = [math.cos(a) * x + math.sin(a) * y for x, y in zip(u, w)]
        for j in range(TUBE):
            b = 2 * math.pi * j / TUBE
            n = [math.cos(b) * x + math.sin(b) * y for x, y in zip(out, axis)]
            p = peers.along(peers.along(centre, major, out), minor, n)
            vertices.append(struct.pack("<6f", *p, *n))
    faces = []
    for i in range(RING):
        for j in range(TUBE):
            a, b = i * TUBE + j, i * TUBE + (j + 1) % TUBE
            c, d = ((i + 1) % RING) * TUBE + j, ((i + 1) % RING) * TUBE + (j + 1) % TUBE
            faces += [struct.pack("<B3i", 3, a, c, b), struct.pack("<B3i", 3, b, c, d)]
    head = ["ply", "format binary_little_endian 1.0", f"element vertex {len(vertices)}",
            *[f"property float {k}" for k in ("x", "y", "z", "nx", "ny", "nz")],
            f"element face {len(faces)}", "property list uchar int vertex_indices", "end_header\n"]
    path.write_bytes("\n".join(head).encode() + b"".join(vertices) + b"".join(faces))
    return {"type": "ply", "filename": str(path)}


def shapes_of(kind, rest, folder, number):
    """What Mitsuba has for an object."""
    transform = mi.ScalarTransform4f()
    if kind == "plane":
        lie = transform.translate([0, rest[0], 0]).rotate([1, 0, 0], -90).scale([FAR, FAR, 1])
        yield {"type": "rectangle", "to_world": lie}
    elif kind == "sphere":
        yield {"type": "sphere", "center": rest[0], "radius": rest[1]}
    elif kind == "box":
        yield {"type": "cube",
               "to_world": transform.translate(rest[0]).rotate([0, 1, 0], rest[2]).scale(rest[1])}
    elif kind == "cylinder":
        a, b, radius = rest
        yield {"type": "cylinder", "p0": a, "p1": b, "radius": radius}
        for end, other in ((a, b), (b, a)):
            outward = peers.minus(end, other)
            aside, _ = peers.basis(peers.unit(outward))
            yield {"type": "disk", "to_world": transform.look_at(
                origin=end, target=peers.along(end, 1, outward), up=aside).scale(radius)}
    else:
        yield torus_file(*rest, folder / f"torus{number}.ply")


def loaded(scene, folder):
    """Mitsuba's scene, and for every number of a BSDF the index of the material it stands for."""
    names = list(scene["materials"])
    description = {"type": "scene"}
    for i, name in enumerate(names):  # all different, lest Mitsuba take two for one
        description[f"m{i}"] = {"type": "diffuse", "id": f"m{i}",
                                "reflectance": {"type": "rgb", "value": (i + 1) / (len(names) + 1)}}
    for number, (kind, *rest, material) in enumerate(peers.expanded(scene)):
        for part, shape in enumerate(shapes_of(kind, rest, folder, number)):
            bsdf = {"type": "ref", "id": f"m{names.index(material)}"}
            description[f"s{number}_{part}"] = {**shape, "bsdf": bsdf}
    made = mi.load_dict(description)
    numbers = {}
    for bsdf in {shape.bsdf() for shape in made.shapes()}:
        numbers[dr.reinterpret_array(mi.UInt32, mi.BSDFPtr(bsdf))[0]] = int(bsdf.id()[1:])
    return made, mi.UInt32([numbers.get(i, 0) for i in range(max(numbers) + 1)])


# --- light ---------------------------------------------------------------------------------------

class Materials:
    """The peers' finishes, one value a material."""

    def __init__(self, scene):
        finishes = list(scene["materials"].values())

        def column(make):
            return mi.Float([float(make(m)) for m in finishes])
        self.ambient, self.diffuse, self.phong, self.reflect = (
            column(lambda m, k=k: m.get(k, 0)) for k in ("ambient", "diffuse", "phong", "reflect"))
        self.exponent = column(lambda m: m.get("phong_size", 40))
        self.colour = [column(lambda m, k=k: m["color"][k]) for k in range(3)]

    def at(self, name, index, active):
        return dr.gather(mi.Float, getattr(self, name), index, active)

    def colour_at(self, index, active):
        return mi.Color3f(*[dr.gather(mi.Float, c, index, active) for c in self.colour])


def place_on(light, u):
    """A point of a light, u in the unit square."""
    at = mi.Point3f(light["position"])
    if "u" in light:
        at += (u.x - 0.5) * mi.Vector3f(light["u"]) + (u.y - 0.5) * mi.Vector3f(light["v"])
    return at


def lit(scene, si, normal, view, light, u, m, index, active):
    """colour * diffuse * (n.l) + phong * (r.v)^phong_size, where the light is seen."""
    way = place_on(light, u) - si.p
    l = dr.normalize(way)
    n_dot_l = dr.dot(normal, l)
    facing = active & (n_dot_l > 0)
    seen = facing & ~scene.ray_test(si.spawn_ray_to(place_on(light, u)), facing)
    r_dot_v = 2 * n_dot_l * dr.dot(normal, view) - dr.dot(l, view)
    r_dot_v = dr.select(r_dot_v > 0, r_dot_v, 0)  # LLVM 14 has no maximum here
    shine = m.at("phong", index, active) * dr.power(r_dot_v, m.at("exponent", index, active))
    value = m.colour_at(index, active) * (m.at("diffuse", index, active) * n_dot_l) + shine
    return dr.select(seen, value * mi.Color3f(light["color"]), 0)


def radiance(description, scene, material_of, m, ray, sampler):
    """Mirrors are followed one after another: nothing branches."""
    throughput, total = mi.Float(1), mi.Color3f(0)
    active = mi.Bool(True)
    background = mi.Color3f(description["background"])
    level = int(description["trace_level"])
    if not any(f.get("reflect") for f in description["materials"].values()):
        level = 1
    for depth in range(level):
        si = scene.ray_intersect(ray, active)
        hit = active & si.is_valid()
        total += dr.select(active & ~hit, throughput * background, 0)
        index = dr.gather(mi.UInt32, material_of, dr.reinterpret_array(mi.UInt32, si.bsdf()), hit)
        view = -ray.d
        normal = dr.select(dr.dot(si.sh_frame.n, view) < 0, -si.sh_frame.n, si.sh_frame.n)
        value = m.colour_at(index, hit) * m.at("ambient", index, hit)
        for light in description["lights"]:
            u = sampler.next_2d() if "u" in light else mi.Point2f(0.5)
            value += lit(scene, si, normal, view, light, u, m, index, hit)
        total += dr.select(hit, throughput * value, 0)
        if depth + 1 < level:
            throughput = throughput * m.at("reflect", index, hit)
            active = hit & (throughput > 0)
            ray = si.spawn_ray(mi.Vector3f(2 * dr.dot(normal, view) * normal - view))
    return total


def one_pass(description, scene, material_of, size, samples, sampler, seed):
    width, height = size
    camera = description["camera"]
    forward = peers.unit(peers.minus(camera["look_at"], camera["eye"]))
    right = peers.unit(peers.cross(forward, camera["up"]))
    up = peers.cross(right, forward)
    half = math.tan(math.radians(camera["fov"]) / 2)
    index = dr.arange(mi.UInt32, width * height * samples) // samples
    sampler.seed(seed, width * height * samples)
    offset = mi.Point2f(0.5) if samples == 1 else sampler.next_2d()
    x = (2 * (mi.Float(index % width) + offset.x) / width - 1) * (half * width / height)
    y = (1 - 2 * (mi.Float(index // width) + offset.y) / height) * half
    direction = mi.Vector3f(forward) + x * mi.Vector3f(right) + y * mi.Vector3f(up)
    ray = mi.Ray3f(mi.Point3f(camera["eye"]), dr.normalize(direction))
    values = radiance(description, scene, material_of, Materials(description), ray, sampler)
    pixels = mi.Float(dr.ravel(values))
    if samples > 1:
        sums = dr.zeros(mi.Float, 3 * width * height)
        for k in range(3):
            dr.scatter_add(sums, values[k] / samples, 3 * index + k)
        pixels = sums
    dr.eval(pixels)
    dr.sync_thread()
    return pixels


def main(scene_name, size, samples, passes, seed, out):
    description = peers.load(scene_name + ".lua")
    size, samples, passes, seed = tuple(map(int, size.split("x"))), *map(int, (samples, passes, seed))
    told = {"version": mi.__version__}
    begin = time.process_time()
    scene, material_of = loaded(description, pathlib.Path(scratch.name))
    dr.eval(material_of)
    told["load"] = time.process_time() - begin
    sampler = mi.load_dict({"type": "multijitter" if samples > 1 else "independent",
                            "sample_count": samples})
    sampler.set_samples_per_wavefront(samples)

    def pixels(number):
        return one_pass(description, scene, material_of, size, samples, sampler, number)

    begin = time.process_time()
    pixels(seed)
    told["first"] = time.process_time() - begin
    begin = time.process_time()
    picture = pixels(seed)
    for number in range(seed + 1, seed + passes):
        picture = picture + pixels(number)
        dr.eval(picture)
    dr.sync_thread()
    told["trace"] = time.process_time() - begin
    mi.Bitmap(mi.TensorXf(picture / passes, (size[1], size[0], 3))).write(out)
    print(json.dumps(told))


if __name__ == "__main__":
    if len(sys.argv) != 7:
        sys.exit(__doc__)
    main(*sys.argv[1:])
