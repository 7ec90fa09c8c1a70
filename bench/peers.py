#!/usr/bin/env python3
"""Writes the scenes of bench/scenes for POV-Ray 3.7 (.pov) and Tachyon (.tachyon.dat).

usage: bench/peers.py FOLDER [SCENE...]
"""
import math
import pathlib
import re
import sys

SCENES = pathlib.Path(__file__).resolve().parent / "scenes"
ALL = ["S1", "S1n", "S2", "S3", "S3b", "S4", "S5", "S5n", "S5s", "trivial"]

# --- reading: the table of a scene, which is a literal -------------------------------------------

TOKEN = re.compile(r'\s+|--[^\n]*|(?P<text>"[^"]*")|(?P<number>-?[0-9.]+(?:e[-+]?[0-9]+)?)'
                   r'|(?P<name>[A-Za-z_]\w*)|(?P<mark>[{}=,])')


def tokens(text):
    at = 0
    while at < len(text):
        match = TOKEN.match(text, at)
        if not match:
            raise ValueError(f"not a plain value: {text[at:at + 20]!r}")
        at = match.end()
        if match.lastgroup:
            yield match.lastgroup, match.group(match.lastgroup)


def value(stream, kind, text):
    """A number, a string, a list or a dict, beginning with the given token."""
    if kind == "text":
        return text[1:-1]
    if kind == "number":
        return float(text)
    if (kind, text) != ("mark", "{"):
        raise ValueError(f"expected a value, got {text}")
    items, fields = [], {}
    for kind, text in stream:
        if text == "}" and kind == "mark":
            return fields or items
        if text == "," and kind == "mark":
            continue
        if kind == "name":
            if next(stream)[1] != "=":
                raise ValueError(f"expected = after {text}")
            fields[text] = value(stream, *next(stream))
        else:
            items.append(value(stream, kind, text))
    raise ValueError("a table is not closed")


def load(name):
    text = (SCENES / name).read_text()
    stream = tokens(text[text.index('require "peer"') + len('require "peer"'):])
    scene = value(stream, *next(stream))
    if "base" in scene:
        base = load(scene["base"])
        base["objects"] = [o for o in base["objects"] if o[0] != scene.get("without")]
        scene = {**base, **scene}
    return scene


# --- geometry ------------------------------------------------------------------------------------

def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def along(a, t, d):
    return [x + t * y for x, y in zip(a, d)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def unit(a):
    length = math.sqrt(sum(x * x for x in a))
    return [x / length for x in a]


def basis(up):
    """Two unit vectors that make a right-handed frame u, up, w of the unit vector up."""
    w = unit(cross([0, 0, 1] if abs(up[0]) > 0.9 else [1, 0, 0], up))
    return cross(up, w), w


def flake(middle, radius, up, levels):
    """The balls of peer.lua's sphereflake: centre and radius."""
    yield middle, radius
    if levels == 0:
        return
    u, w = basis(up)
    for child in range(9):
        azimuth = math.radians(60 * child if child < 6 else 30 + 120 * (child - 6))
        height = 0 if child < 6 else math.radians(54.7356)
        d = [math.cos(azimuth) * math.cos(height) * x for x in u]
        d = unit(along(along(d, math.sin(azimuth) * math.cos(height), w), math.sin(height), up))
        yield from flake(along(middle, radius + radius / 3, d), radius / 3, d, levels - 1)


def expanded(scene):
    """The objects, compositions resolved into spheres."""
    for kind, *rest in scene["objects"]:
        if kind == "sphereflake":
            centre, radius, levels, material = rest
            for middle, r in flake(centre, radius, [0, 1, 0], levels):
                yield "sphere", middle, r, material
        elif kind == "balls":
            (x, z), names, rows = rest
            for i, row in enumerate(rows):
                for j in range(len(row) // 5):
                    r = int(row[5 * j:5 * j + 4]) / 10000
                    yield "sphere", [x + i, r, z + j], r, names[int(row[5 * j + 4])]
        else:
            yield (kind, *rest)


# --- POV-Ray -------------------------------------------------------------------------------------

def number(x, digits=12):
    return f"{x + 0.0:.{digits}g}"


def angle(values, digits=12):
    return "<" + ",".join(number(x, digits) for x in values) + ">"


def pov_material(name, m):
    finish = "ambient {} diffuse {} phong {} phong_size {}".format(
        *(number(m.get(k, 0)) for k in ("ambient", "diffuse", "phong")),
        number(m.get("phong_size", 40)))
    interior = ""
    if "checker" in m:
        # Lowered, lest the plane y = 0 fall between two layers of cells.
        c1, c2, size = m["checker"]
        pigment = (f"checker rgb {angle(c1)}, rgb {angle(c2)} scale {number(size)} "
                   "translate <0,-0.37,0>")
    elif "glass" in m:
        pigment = "rgbt <1,1,1,1>"
        finish += " reflection{0,1 fresnel on} conserve_energy"
        interior = f" interior{{ior {number(m['glass'])}}}"
    else:
        pigment = f"rgb {angle(m['color'])}"
    if m.get("reflect"):
        finish += f" reflection {number(m['reflect'])}"
    return (f"#declare M_{name}=material{{texture{{pigment{{{pigment}}} "
            f"finish{{{finish}}}}}{interior}}}")


def pov_light(light):
    text = f"light_source{{{angle(light['position'])} rgb {angle(light['color'])}"
    edges, shape = (light.get("u"), light.get("v")), ""
    if "radius" in light:
        d = 2 * light["radius"]
        edges, shape = ([d, 0, 0], [0, 0, d]), "circular orient"
    if edges[0]:
        text += (f" area_light {angle(edges[0])},{angle(edges[1])},AN,AN {shape} "
                 "#if(AAD>=0) adaptive AAD #end #if(AJ) jitter #end")
    return text + "}"


def pov_object(kind, *rest):
    *rest, name = rest
    material = f" material{{M_{name}}}}}"
    if kind == "plane":
        return f"plane{{<0,1,0>,{number(rest[0])}" + material
    if kind == "sphere":
        return f"sphere{{{angle(rest[0])},{number(rest[1])}" + material
    if kind == "cylinder":
        return f"cylinder{{{angle(rest[0])},{angle(rest[1])},{number(rest[2])}" + material
    if kind == "box":
        centre, half, degrees = rest
        c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
        matrix = [c, 0, -s, 0, 1, 0, s, 0, c, *centre]
        return f"box{{{angle([-h for h in half])},{angle(half)} matrix{angle(matrix)}" + material
    centre, axis, major, minor = rest
    axis = unit(axis)
    u, w = basis(axis)
    matrix = angle([*u, *axis, *w, *centre], 15)
    return f"torus{{{number(major)},{number(minor)} matrix{matrix}" + material


def pov(scene):
    camera, (width, height) = scene["camera"], scene["size"]
    across = math.degrees(
        2 * math.atan(width / height * math.tan(math.radians(camera["fov"] / 2))))
    yield "#version 3.7;"
    yield "#ifndef(ADC) #declare ADC=1/255; #end"
    yield (f"global_settings{{assumed_gamma 1.0 max_trace_level {number(scene['trace_level'])} "
           "adc_bailout ADC}")
    yield "#ifndef(AN) #declare AN=8; #end"
    yield "#ifndef(AAD) #declare AAD=-1; #end"
    yield "#ifndef(AJ) #declare AJ=0; #end"
    yield f"background{{rgb {angle(scene['background'])}}}"
    yield (f"camera{{perspective location {angle(camera['eye'])} right <{-width / height:.12g},0,0> "
           f"up <0,1,0> direction <0,0,1> sky {angle(camera['up'])} angle {across:.12g} "
           f"look_at {angle(camera['look_at'])}}}")
    yield from map(pov_light, scene["lights"])
    for name, material in scene["materials"].items():
        yield pov_material(name, material)
    for item in expanded(scene):
        yield pov_object(*item)


# --- Tachyon: left-handed, hence x negated -------------------------------------------------------

def point(v):
    return " ".join(number(x) for x in (-v[0], v[1], v[2]))


def plain(v):
    return " ".join(number(x) for x in v)


def dat_box(centre, half, degrees, material):
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    axes = [[c, 0, -s], [0, 1, 0], [s, 0, c]]

    def corner(name):
        at = centre
        for sign, h, axis in zip(name, half, axes):
            at = along(at, h if sign == "1" else -h, axis)
        return point(at)

    for face in ("000 010 011 001", "000 100 101 001", "000 100 110 010", "100 110 111 101",
                 "010 110 111 011", "001 101 111 011"):
        a, b, c_, d = map(corner, face.split())
        yield f"Tri V0 {a} V1 {b} V2 {c_} {material}"
        yield f"Tri V0 {a} V1 {c_} V2 {d} {material}"


def dat_object(kind, *rest):
    *rest, name = rest
    material = f"M_{name}"
    if kind == "plane":
        yield f"Plane Center 0 {number(rest[0])} 0 Normal 0 1 0 {material}"
    elif kind == "sphere":
        yield f"Sphere Center {point(rest[0])} Rad {number(rest[1])} {material}"
    elif kind == "box":
        yield from dat_box(*rest, material)
    else:
        a, b, radius = rest
        normal = point(unit(minus(b, a)))
        yield f"FCylinder Base {point(a)} Apex {point(b)} Rad {number(radius)} {material}"
        for end in (a, b):
            yield (f"Ring Center {point(end)} Normal {normal} Inner 0.0 "
                   f"Outer {number(radius)} {material}")


def dat(scene):
    camera = scene["camera"]
    zoom = 0.5 / math.tan(math.radians(camera["fov"] / 2))
    yield "Begin_Scene"
    yield f"Resolution {plain(scene['size'])}"
    yield "\nCamera"
    yield f"  Zoom {zoom:.9g}"
    yield "  Aspectratio 1.0"
    yield "  Antialiasing 0"
    yield f"  Raydepth {number(scene['trace_level'])}"
    yield f"  Center {point(camera['eye'])}"
    yield f"  Viewdir {point(unit(minus(camera['look_at'], camera['eye'])))}"
    yield f"  Updir {point(camera['up'])}"
    yield "End_Camera"
    yield f"Background {plain(scene['background'])}"
    for light in scene["lights"]:
        yield f"Light Center {point(light['position'])} Rad 0.001 Color {plain(light['color'])}"
    for name, m in scene["materials"].items():
        yield (f"TexDef M_{name} Ambient {number(m['ambient'])} Diffuse {number(m['diffuse'])} "
               f"Specular {number(m.get('reflect', 0))} Opacity 1 Phong Plastic "
               f"{number(m.get('phong', 0))} Phong_size {number(m.get('phong_size', 40))} "
               f"Color {plain(m['color'])} TexFunc 0")
    for item in expanded(scene):
        yield from dat_object(*item)
    yield "End_Scene"


def tachyon_can(scene):
    """It has no torus, no refraction, no checker and no area light."""
    return (all(o[0] != "torus" for o in scene["objects"])
            and all("color" in m for m in scene["materials"].values())
            and all(light.keys() <= {"position", "color"} for light in scene["lights"]))


def main(arguments):
    if not arguments or arguments[0].startswith("-"):
        print(__doc__.strip())
        return 0 if arguments and arguments[0] in ("-h", "--help") else 2
    folder = pathlib.Path(arguments[0])
    folder.mkdir(parents=True, exist_ok=True)
    for name in arguments[1:] or ALL:
        if name not in ALL:
            print(f"peers.py: there is no scene {name}; there are {' '.join(ALL)}", file=sys.stderr)
            return 2
        scene = load(name + ".lua")
        (folder / f"{name}.pov").write_text("\n".join(pov(scene)) + "\n")
        if tachyon_can(scene):
            (folder / f"{name}.tachyon.dat").write_text("\n".join(dat(scene)) + "\n")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
