"""Pictures as linear arrays, and how far apart two are."""
import struct
import zlib

import numpy as np

# --- reading ---------------------------------------------------------------------------------------

EXR_TYPES = {1: (np.dtype("<f2"), 2), 2: (np.dtype("<f4"), 4)}  # half, float
EXR_LINES = {0: 1, 2: 1, 3: 16}  # lines a block, of no compression, ZIPS and ZIP


def text(data, at):
    end = data.index(b"\0", at)
    return data[at:end].decode(), end + 1


def exr_header(data):
    """The attributes as bytes, and where they end."""
    attributes, at = {}, 8
    while data[at]:
        name, at = text(data, at)
        _, at = text(data, at)
        (size,) = struct.unpack_from("<i", data, at)
        attributes[name] = data[at + 4:at + 4 + size]
        at += 4 + size
    return attributes, at + 1


def exr_channels(raw):
    at = 0
    while raw[at]:
        name, at = text(raw, at)
        (kind,) = struct.unpack_from("<i", raw, at)
        yield name, EXR_TYPES[kind]
        at += 16


def unzipped(block, size):
    """One block: bytes as differences, the even ones before the odd ones."""
    if len(block) == size:
        return block  # what compression would have made larger
    delta = np.frombuffer(zlib.decompress(block), np.uint8).astype(np.int64)
    delta[1:] -= 128
    halves = np.cumsum(delta).astype(np.uint8)
    out = np.empty(size, np.uint8)
    out[0::2], out[1::2] = halves[:(size + 1) // 2], halves[(size + 1) // 2:]
    return out.tobytes()


def read_exr(path):
    """A scan-line EXR with channels R, G, B, uncompressed or zip (openexr.com, file layout)."""
    data = path.read_bytes()
    attributes, at = exr_header(data)
    x0, y0, x1, y1 = struct.unpack("<4i", attributes["dataWindow"])
    width, height = x1 - x0 + 1, y1 - y0 + 1
    compression = attributes["compression"][0]
    channels = list(exr_channels(attributes["channels"]))
    lines = EXR_LINES[compression]
    row = width * sum(size for _, (_, size) in channels)
    out = np.zeros((height, width, 3))
    for offset in struct.unpack_from(f"<{-(-height // lines)}Q", data, at):
        y, size = struct.unpack_from("<2i", data, offset)
        block, count = data[offset + 8:offset + 8 + size], min(lines, y1 + 1 - y)
        if compression:
            block = unzipped(block, row * count)
        place = 0
        for line in range(y - y0, y - y0 + count):
            for name, (kind, size) in channels:
                if name in "RGB":
                    out[line, :, "RGB".index(name)] = np.frombuffer(block, kind, width, place)
                place += width * size
    return out


def read_ppm(path):
    """A binary PPM of 8 or 16 bits, as values in [0,1]."""
    data = path.read_bytes()
    words, at = [], 0
    while len(words) < 4:
        end = data.index(b"\n", at)
        words += data[at:end].split(b"#")[0].split()
        at = end + 1
    width, height, top = map(int, words[1:])
    kind = ">u2" if top > 255 else "u1"
    values = np.frombuffer(data, kind, width * height * 3, at).astype(float)
    return values.reshape(height, width, 3) / top


def read_pfm(path):
    """A portable float map: RGB, little-endian, rows from the bottom."""
    _, size, scale, values = path.read_bytes().split(b"\n", 3)
    width, height = map(int, size.split())
    if float(scale) >= 0:
        raise ValueError(f"{path} is big-endian")
    return np.frombuffer(values, "<f4").astype(float).reshape(height, width, 3)[::-1]


def read(path):
    return {".exr": read_exr, ".pfm": read_pfm}.get(path.suffix, read_ppm)(path)


# --- comparing -------------------------------------------------------------------------------------

def rmse(a, b):
    """Root of the mean squared difference of linear values, clamped to what can be displayed."""
    return float(np.sqrt(np.mean((np.clip(a, 0, 1) - np.clip(b, 0, 1)) ** 2)))


def blocks(picture, edge):
    """Means over square blocks; what does not fill one is left out."""
    height, width = (n // edge for n in picture.shape[:2])
    cut = picture[:height * edge, :width * edge]
    return cut.reshape(height, edge, width, edge, 3).mean(axis=(1, 3))


def differ_by_noise(a, b, edge=8):
    """Whether what is between two pictures averages out as independent errors of pixels do: over
    blocks of edge x edge to 1/edge of the whole; up to twice that."""
    return rmse(blocks(a, edge), blocks(b, edge)) <= 2 * rmse(a, b) / edge


def lab(picture):
    """CIE L*a*b* (D65) of linear Rec.709 values in [0,1]."""
    to_xyz = np.array([[0.4124564, 0.3575761, 0.1804375], [0.2126729, 0.7151522, 0.0721750],
                       [0.0193339, 0.1191920, 0.9503041]])
    xyz = np.clip(picture, 0, 1) @ (to_xyz / to_xyz.sum(axis=1, keepdims=True)).T
    f = np.where(xyz > (6 / 29) ** 3, np.cbrt(xyz), xyz / (3 * (6 / 29) ** 2) + 4 / 29)
    return np.stack([116 * f[..., 1] - 16, 500 * (f[..., 0] - f[..., 1]),
                     200 * (f[..., 1] - f[..., 2])], axis=-1)


def ciede2000(lab1, lab2):
    """Colour differences (Sharma, Wu and Dalal, "The CIEDE2000 color-difference formula:
    implementation notes", Color Research & Application 30(1), 2005), equations (2) to (22)."""
    c1, c2 = (np.hypot(v[..., 1], v[..., 2]) for v in (lab1, lab2))
    seventh = ((c1 + c2) / 2) ** 7
    g = 0.5 * (1 - np.sqrt(seventh / (seventh + 25.0 ** 7)))
    a1, a2 = (1 + g) * lab1[..., 1], (1 + g) * lab2[..., 1]
    c1, c2 = np.hypot(a1, lab1[..., 2]), np.hypot(a2, lab2[..., 2])
    h1 = np.degrees(np.arctan2(lab1[..., 2], a1)) % 360
    h2 = np.degrees(np.arctan2(lab2[..., 2], a2)) % 360
    grey = c1 * c2 == 0
    dh = np.where(grey, 0, (h2 - h1 + 180) % 360 - 180)
    d_light, d_chroma = lab2[..., 0] - lab1[..., 0], c2 - c1
    d_hue = 2 * np.sqrt(c1 * c2) * np.sin(np.radians(dh / 2))
    light, chroma = (lab1[..., 0] + lab2[..., 0]) / 2, (c1 + c2) / 2
    hue = np.where(grey, h1 + h2, (h1 + dh / 2) % 360)

    def cos(times, less):
        return np.cos(np.radians(times * hue - less))
    t = 1 - 0.17 * cos(1, 30) + 0.24 * cos(2, 0) + 0.32 * cos(3, -6) - 0.20 * cos(4, 63)
    s_light = 1 + 0.015 * (light - 50) ** 2 / np.sqrt(20 + (light - 50) ** 2)
    s_chroma, s_hue = 1 + 0.045 * chroma, 1 + 0.015 * chroma * t
    seventh = chroma ** 7
    turn = np.sin(2 * np.radians(30 * np.exp(-((hue - 275) / 25) ** 2)))
    rotation = -turn * 2 * np.sqrt(seventh / (seventh + 25.0 ** 7))
    x, y, z = d_light / s_light, d_chroma / s_chroma, d_hue / s_hue
    return np.sqrt(np.maximum(0, x * x + y * y + z * z + rotation * y * z))


def mean_difference(a, b):
    """Mean CIEDE2000 of two linear pictures; 1 is about what an eye can just tell apart."""
    return float(np.mean(ciede2000(lab(a), lab(b))))
