#!/usr/bin/python3
"""The arithmetic behind the charts."""
import importlib.machinery
import importlib.util
import math
import pathlib
import sys
import tempfile
import unittest

try:
    import numpy as np
    import matplotlib  # noqa: F401
except ModuleNotFoundError as missing:
    print(f"SKIPPED: Debian's Python has no {missing.name}; ./bootstrap --charts installs it")
    sys.exit(77)

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "bench"))
from charting import curves, flip, pictures, speed_table, tables, torus  # noqa: E402

loader = importlib.machinery.SourceFileLoader("chart_tool", str(ROOT / "tools/chart"))
tool = importlib.util.module_from_spec(importlib.util.spec_from_loader("chart_tool", loader))
loader.exec_module(tool)

# Of table 1 of Sharma, Wu and Dalal 2005: pairs on which implementations have gone wrong.
SHARMA = [((50, 2.6772, -79.7751), (50, 0, -82.7485), 2.0425),
          ((50, 3.1571, -77.2803), (50, 0, -82.7485), 2.8615),
          ((50, 0, 0), (50, -1, 2), 2.3669),
          ((50, 2.49, -0.001), (50, -2.49, 0.0009), 7.1792),
          ((50, 2.5, 0), (73, 25, -18), 27.1492),
          ((50, 2.5, 0), (61, -5, 29), 22.8977),
          ((60.2574, -34.0099, 36.2677), (60.4626, -34.1751, 39.4387), 1.2644),
          ((90.8027, -2.0831, 1.4410), (91.1528, -1.6435, 0.0447), 1.4441),
          ((2.0776, 0.0795, -1.1350), (0.9033, -0.0636, -0.5514), 0.9082)]


class Charting(unittest.TestCase):
    def test_ciede2000_of_published_pairs(self):
        for a, b, difference in SHARMA:
            for one, other in ((a, b), (b, a)):
                found = pictures.ciede2000(np.array(one, float), np.array(other, float))
                self.assertAlmostEqual(float(found), difference, 4)

    def test_lab_of_known_colours(self):
        # White is the reference white; red as in any table of sRGB's primaries.
        np.testing.assert_allclose(pictures.lab(np.array([1.0, 1, 1])), [100, 0, 0], atol=1e-9)
        np.testing.assert_allclose(pictures.lab(np.array([1.0, 0, 0])), [53.24, 80.09, 67.20],
                                   atol=0.02)

    def test_flip_of_plain_colours(self):
        # Nothing has an edge, so that the paper's colour difference stands alone. Green and blue
        # are its largest; L*a*b* of both as in any table of sRGB's primaries.
        green, blue, black, white = (np.broadcast_to(np.array(c, float), (8, 9, 3)) for c in
                                     ((0, 1, 0), (0, 0, 1), (0, 0, 0), (1, 1, 1)))
        self.assertEqual(flip.mean_flip(green, green), 0)
        self.assertAlmostEqual(flip.mean_flip(green, blue), 1)
        (l1, a1, b1), (l2, a2, b2) = (87.737, -86.185, 83.181), (32.303, 79.197, -107.864)
        largest = (l1 - l2 + math.hypot(0.01 * (l1 * a1 - l2 * a2), 0.01 * (l1 * b1 - l2 * b2))) ** 0.7
        expected = 0.95 + 0.05 * (100 ** 0.7 / largest - 0.4) / 0.6
        self.assertAlmostEqual(flip.mean_flip(black, white), expected, 4)

    def test_flip_as_its_authors_program_reckons_it(self):
        y, x = np.mgrid[0:48, 0:64]
        one = np.stack([0.5 + 0.4 * np.sin(x / 5), (x > 30) * 0.8, 0.4 + 0.3 * np.cos(y / 3)], -1)
        # flip-evaluator 1.7, of the same pictures encoded as sRGB.
        self.assertAlmostEqual(flip.mean_flip(one, np.roll(one, 1, 1) * 0.9), 0.310793, 4)
        bluer = one.copy()
        bluer[..., 2] = np.roll(one[..., 2], 4, 0)
        self.assertAlmostEqual(flip.mean_flip(one, bluer), 0.378012, 4)

    def test_flip_weighs_edges_up(self):
        # Blurred as the eye blurs, the colours differ by half as much at the step as beyond it; but
        # there is an edge where there was none.
        flat = np.full((40, 40, 3), 0.5)
        step = flat.copy()
        step[:, 20:] += 0.2
        found = flip.flip(flat, step)
        self.assertGreater(found[20, 20], 1.2 * found[20, 38])
        self.assertLess(found[20, 2], 1e-6)

    def test_rmse_clamps_what_cannot_be_displayed(self):
        self.assertEqual(pictures.rmse(np.array([1.0, 5.0]), np.array([1.0, 9.0])), 0)
        self.assertAlmostEqual(pictures.rmse(np.array([0.0, 0.3]), np.array([0.0, 0.7])),
                               0.4 / math.sqrt(2))

    def test_noise_is_told_from_a_difference(self):
        noise = np.random.default_rng(1).normal(0, 0.05, (48, 64, 3))
        grey = np.full((48, 64, 3), 0.5)
        self.assertTrue(pictures.differ_by_noise(grey + noise, grey))
        darker = grey.copy()
        darker[8:24, 8:24] -= 0.05  # a thing in another light
        self.assertFalse(pictures.differ_by_noise(darker + noise, grey))

    def test_float_maps_are_read_from_the_bottom(self):
        rows = np.arange(12, dtype="<f4").reshape(2, 2, 3)
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "a.pfm"
            file.write_bytes(b"PF\n2 2\n-1.0\n" + rows[::-1].tobytes())
            np.testing.assert_array_equal(pictures.read(file), rows)

    def test_ratios_leave_out_what_is_not_the_same_picture(self):
        cases = {scene: {"raytracer": {"time": 1.0}, "povray": {"time": time}}
                 for scene, time in (("S1", 2.0), ("S2", 3.0), ("S4", 9.0))}
        line, = speed_table.ratios(cases, ["S1", "S2"], {"povray": "POV-Ray", "tachyon": "Tachyon"})
        self.assertIn("median **2.50**, 2.00 to 3.00 over 2 scenes", line)

    def test_slope_of_a_power(self):
        rows = [{"time": t, "rmse": 3 * t ** -0.75} for t in (1, 2, 7, 30)]
        self.assertAlmostEqual(curves.slope(rows), -0.75)

    def test_pareto_front_keeps_what_nothing_beats(self):
        rows = [{"time": t, "rmse": e} for t, e in ((3, 1), (1, 5), (2, 6), (2, 2), (4, 1))]
        self.assertEqual([(r["time"], r["rmse"]) for r in tool.pareto(rows, "rmse")],
                         [(1, 5), (2, 2), (3, 1)])

    def test_medians_and_spread(self):
        row = tables.median_row([{"s": "a", "time": t} for t in (5, 1, 2)], "time")
        self.assertEqual(row, {"s": "a", "time": 2, "time_min": 1, "time_max": 5, "runs": 3})

    def test_tables_of_the_stability_bench(self):
        text = ("## Torus\n\n| ns per ray | ours | theirs |\n| --- | --- | --- |\n| far | 9 | 8 |\n\n"
                "| missed per million | ours | theirs |\n| --- | --- | --- |\n"
                "| far | 0 | 20 (1.1e+05) |\n\n## Every shape\n\n| ns per ray | x |\n| far | 1 |\n")
        ours, theirs = torus.parsed(text)
        self.assertEqual((ours["ns"], ours["missed"]), (9, 0))
        self.assertEqual((theirs["missed"], theirs["missed_below_resolution"]), (20, 1.1e5))


if __name__ == "__main__":
    unittest.main()
