"""Mean FLIP: how far apart an eye that flips between two pictures finds them.

Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom and Fairchild, "FLIP: A Difference Evaluator
for Alternating Images", Proc. ACM Comput. Graph. Interact. Tech. 3(2), 2020: colours as seen from a
distance, and the edges and points that differ, which weigh colour differences up. In [0,1].
"""
import math

import numpy as np

# The paper's viewer: 0.7 m before a screen 0.7 m and 3840 pixels wide.
PIXELS_PER_DEGREE = 0.7 * 3840 / 0.7 * math.pi / 180

# Section 4.1, table 1: the eye's contrast sensitivity, sums of a sqrt(pi / b) exp(-pi^2 r^2 / b)
# for the achromatic, the red-green and the blue-yellow channel.
SENSITIVITY = (((1, 0.0047),), ((1, 0.0053),), ((34.1, 0.04), (13.5, 0.025)))
COLOUR_EXPONENT = 0.7      # q_c: large colour differences differ less
KNEE = (0.4, 0.95)         # p_c, p_t: below this share of the largest difference lies this much
FEATURE_WIDTH = 0.082      # degrees of an edge as seen
FEATURE_EXPONENT = 0.5     # q_f

TO_XYZ = np.array([[0.4124564, 0.3575761, 0.1804375], [0.2126729, 0.7151522, 0.0721750],
                   [0.0193339, 0.1191920, 0.9503041]])
WHITE = TO_XYZ.sum(axis=1)


def opponent(linear):
    """Y, Cx, Cz: L*a*b* without its cube roots, so that it can be averaged."""
    x, y, z = np.moveaxis(linear @ (TO_XYZ / WHITE[:, None]).T, -1, 0)
    return np.stack([116 * y - 16, 500 * (x - y), 200 * (y - z)], axis=-1)


def linear_of(seen):
    y = (seen[..., 0] + 16) / 116
    xyz = np.stack([seen[..., 1] / 500 + y, y, y - seen[..., 2] / 200], axis=-1) * WHITE
    return np.clip(xyz @ np.linalg.inv(TO_XYZ).T, 0, 1)


def along(picture, weights, axis):
    """The picture with its columns or rows weighed; its edge pixels go on beyond it."""
    reach = len(weights) // 2
    pad = [(0, 0)] * picture.ndim
    pad[axis] = (reach, reach)
    padded, size = np.pad(picture, pad, mode="edge"), picture.shape[axis]
    return sum(w * np.take(padded, range(i, i + size), axis) for i, w in enumerate(weights))


def offsets(standard_deviation):
    reach = math.ceil(3 * standard_deviation)
    return np.arange(-reach, reach + 1)


def seen_from_afar(picture):
    """Every channel blurred as the eye blurs it. A Gaussian of r is one of x times one of y."""
    widest = max(b for terms in SENSITIVITY for _, b in terms)
    x = offsets(math.sqrt(widest / 2) / math.pi * PIXELS_PER_DEGREE) / PIXELS_PER_DEGREE
    out = np.empty_like(picture)
    for channel, terms in enumerate(SENSITIVITY):
        rows = [np.exp(-np.pi ** 2 * x ** 2 / b) for _, b in terms]
        sizes = [a * math.sqrt(math.pi / b) for a, b in terms]
        whole = sum(size * row.sum() ** 2 for size, row in zip(sizes, rows))
        one = picture[..., channel]
        out[..., channel] = sum(size / whole * along(along(one, row, 1), row, 0)
                                for size, row in zip(sizes, rows))
    return out


def hunt_lab(linear):
    """L*a*b*, colours of dark pixels less colourful."""
    ratios = linear @ (TO_XYZ / WHITE[:, None]).T
    knee = (6 / 29) ** 3
    f = np.where(ratios > knee, np.cbrt(ratios), ratios / (3 * (6 / 29) ** 2) + 4 / 29)
    light = 116 * f[..., 1] - 16
    chroma = np.stack([500 * (f[..., 0] - f[..., 1]), 200 * (f[..., 1] - f[..., 2])], axis=-1)
    return light, 0.01 * light[..., None] * chroma


def far_apart(a, b):
    """The HyAB distance, to the paper's power."""
    (light_a, chroma_a), (light_b, chroma_b) = hunt_lab(a), hunt_lab(b)
    chroma = np.sqrt(((chroma_a - chroma_b) ** 2).sum(axis=-1))
    return (np.abs(light_a - light_b) + chroma) ** COLOUR_EXPONENT


def colour_difference(a, b):
    largest = far_apart(np.array([0.0, 1, 0]), np.array([0.0, 0, 1]))
    share = far_apart(a, b) / largest
    knee, there = KNEE
    return np.where(share < knee, share * there / knee,
                    there + (share - knee) / (1 - knee) * (1 - there))


def features(brightness):
    """How strong edges and points are about every pixel."""
    deviation = FEATURE_WIDTH / 2 * PIXELS_PER_DEGREE
    x = offsets(deviation)
    smooth = np.exp(-x ** 2 / (2 * deviation ** 2))
    for slope in (-x * smooth, (x ** 2 / deviation ** 2 - 1) * smooth):
        # As two-dimensional filters whose positive and negative weights sum to 1 and to -1 each.
        up, down = np.maximum(slope, 0), np.minimum(slope, 0)
        across = up / up.sum() - down / down.sum()
        flat = smooth / smooth.sum()
        yield np.hypot(along(along(brightness, across, 1), flat, 0),
                       along(along(brightness, flat, 1), across, 0))


def flip(a, b):
    """Map of the differences of two linear pictures."""
    a, b = (opponent(np.clip(p, 0, 1)) for p in (a, b))
    colour = colour_difference(*(linear_of(seen_from_afar(p)) for p in (a, b)))
    pairs = zip(*(features((p[..., 0] + 16) / 116) for p in (a, b)))
    feature = np.max([np.abs(one - other) for one, other in pairs], axis=0)
    return colour ** (1 - (feature / math.sqrt(2)) ** FEATURE_EXPONENT)


def mean_flip(a, b):
    return float(np.mean(flip(a, b)))
