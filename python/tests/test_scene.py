"""Tests of the Python package, against the program and closed forms."""

import json
import math
import os
import pathlib
import random
import subprocess
import sys
import threading

import numpy as np
import pytest

import bentray

PROGRAM = pathlib.Path(os.environ["BENTRAY"])
BALL = """
[image]
size = [40, 30]
[camera]
position = [0, 0, 5]
[rays]
bounding_sphere = { radius = 10 }
[sky]
color = [0.2, 0.3, 0.4]
[materials.red]
kind = "emissive"
color = [1, 0, 0]
[[objects]]
shape = "sphere"
material = "red"
"""
HOLE = {"law": {"kind": "schwarzschild"}, "rays": {"bounding_sphere": {"radius": 50}, "sky_at_infinity": True}}


def from_program(folder, text, *options):
    (folder / "scene.toml").write_text(text)
    subprocess.run([PROGRAM, "render", "scene.toml", "-o", "a.npz", *options], cwd=folder, check=True)
    return np.load(folder / "a.npz")


def same(arrays, expected):
    names = [name for name in expected.files if name != "metadata.json"]
    assert set(arrays) == set(names)
    for name in names:
        own, other = arrays[name], expected[name]
        assert own.dtype == other.dtype and own.shape == other.shape, name
        assert np.array_equal(own.view(np.uint32), other.view(np.uint32)), name


@pytest.mark.parametrize(
    "change",
    [
        ("[rays]", "[rays]"),
        ("[rays]", '[law]\nkind = "schwarzschild"\nmass = 0.2\n[rays]'),
        ("[rays]", '[law]\nkind = "kerr-newman"\nmass = 0.2\nspin = 0.19\n[rays]\nmethod = "rk4"'),
        ("[rays]", '[rays]\nlighting = "path-tracing"'),
        ('material = "red"', "interior = 1.5"),
        ("[sky]\ncolor = [0.2, 0.3, 0.4]", 'sky = "transparent"'),
    ],
)
def test_images_have_the_bits_of_the_program(tmp_path, change):
    text = BALL.replace(*change)
    if "transparent" in text:
        text = 'sky = "transparent"\n' + text.replace('sky = "transparent"', "")
    expected = from_program(tmp_path, text, "--samples", "2")
    layers = [name for name in expected.files if name not in ("color", "alpha", "metadata.json")]
    same(bentray.Scene(text).render(samples=2, layers=layers), expected)


def test_later_images_have_the_layers_that_are_asked_for():
    text = BALL.replace("[rays]", '[law]\nkind = "schwarzschild"\nmass = 0.2\n[rays]')
    scene = bentray.Scene(text)
    scene.render()
    for layers in [["steps"], ["normal", "samples"], [], ["status", "depth"]]:
        picture, fresh = scene.render(layers=layers), bentray.Scene(text).render(layers=layers)
        assert set(picture) == {"color", *layers}
        assert all(np.array_equal(picture[name], fresh[name]) for name in picture)
    for layer in ["redshift", "image_order", "accumulated", "standard_error"]:
        with pytest.raises(ValueError, match=layer):
            scene.render(layers=[layer])


def test_a_dict_a_text_and_a_file_are_one_scene(tmp_path):
    scene = {
        "image": {"size": [40, 30]},
        "camera": {"position": np.array([0, 0, 5.0])},
        "rays": {"bounding_sphere": {"radius": 10}},
        "sky": {"color": (0.2, 0.3, 0.4)},
        "materials": {"red": {"kind": "emissive", "color": [1, 0, 0]}},
        "objects": [{"shape": "sphere", "material": "red"}],
    }
    (tmp_path / "scene.toml").write_text(BALL)
    images = [bentray.Scene(scene), bentray.Scene(BALL), bentray.Scene.load(tmp_path / "scene.toml")]
    colors = [image.render()["color"] for image in images]
    assert np.array_equal(colors[0], colors[1]) and np.array_equal(colors[0], colors[2])


def test_changes_are_those_of_a_new_scene(tmp_path):
    scene = bentray.Scene(BALL)
    first = scene.render()["color"]
    scene.set({"camera.position": [0, 0, 4], "sky.color": [0, 0, 1]})
    moved = scene.render()["color"]
    fresh = bentray.Scene(BALL.replace("[0, 0, 5]", "[0, 0, 4]").replace("[0.2, 0.3, 0.4]", "[0, 0, 1]"))
    assert np.array_equal(moved, fresh.render()["color"]) and not np.array_equal(moved, first)
    # A box is another program than a ball.
    scene.set({"objects.0.shape": "box"})
    assert not np.array_equal(scene.render()["color"], moved)
    with pytest.raises(bentray.SceneError):
        scene.set({"camera.fov": 0})
    assert scene.size == (40, 30)
    assert scene.render(size=(16, 12))["color"].shape == (12, 16, 3)


def test_deflection_has_its_closed_form():
    b = np.geomspace(30, 3000, 50)
    x = np.stack([np.full_like(b, -49.0), b, 0 * b], axis=-1)
    rays = {"bounding_sphere": {"radius": 5000}, "sky_at_infinity": True, "precision": "f64", "accuracy": 1e-9}
    scene = bentray.Scene({**HOLE, "rays": rays})
    x[:, 0] = -1e4
    ends = scene.trace(x, [1, 0, 0])
    assert (ends["status"] == bentray.Status.ESCAPED).all()
    bent = np.arctan2(-ends["v"][:, 1], ends["v"][:, 0])
    # The series in 1/b; the next term is 3584 / (5 b^5).
    expected = 4 / b + 15 * math.pi / 4 / b**2 + 128 / 3 / b**3 + 3465 * math.pi / 64 / b**4
    assert np.allclose(bent, expected, rtol=0, atol=2e-9 + 1000 / b**5)


def test_the_shadow_is_3_sqrt_3_wide():
    b = np.linspace(5.19, 5.20, 1001)
    x = np.stack([np.full_like(b, -1e5), b, 0 * b], axis=-1)
    rays = {"bounding_sphere": {"radius": 50}, "sky_at_infinity": True, "precision": "f64"}
    ends = bentray.Scene({**HOLE, "rays": rays}).trace(x, [1, 0, 0])
    captured = b[ends["status"] == bentray.Status.CAPTURED]
    assert abs(captured.max() - math.sqrt(27)) < 2e-5


MAPPED = {
    "image": {"size": [48, 32], "samples": 2},
    "camera": {"position": [0, 1, 12]},
    "law": {"kind": "schwarzschild", "mass": 0.4},
    "rays": {"bounding_sphere": {"radius": 30}},
    "sky": {"color": [0.1, 0.2, 0.3]},
    "materials": {"red": {"kind": "emissive", "color": [1, 0, 0]}},
    "objects": [{"shape": "sphere", "material": "red", "center": [3, 0, 0]}],
}


def test_a_map_is_shaded_again():
    scene = bentray.Scene(MAPPED)
    lens_map = scene.map()
    assert lens_map.size == (48, 32) and set(lens_map["id.status"].ravel()) == {1, 2, 3}
    assert np.array_equal(scene.render(lens_map=lens_map)["color"], scene.render()["color"])
    changes = {"sky.color": [0.5, 0, 0], "materials.red.color": [0, 1, 0]}
    scene.set(changes)
    shaded = scene.render(lens_map=lens_map, layers=["object"])
    fresh = scene.render(layers=["object"])
    assert np.array_equal(shaded["color"], fresh["color"]) and np.array_equal(shaded["object"], fresh["object"])
    with pytest.raises(ValueError, match="describes a whole path"):
        scene.render(lens_map=lens_map, layers=["depth"])
    with pytest.raises(KeyError):
        lens_map["direction"]
    scene.set({"camera.position": [0, 2, 12]})
    with pytest.raises(ValueError, match="`camera.position` differs"):
        scene.render(lens_map=lens_map)


def test_verify_measures_the_image():
    errors = bentray.Scene(MAPPED).verify(200)
    assert errors["rays"] + errors["unresolved"] + errors["wrong_terminations"] <= 200
    assert errors["angle_radians"]["p99"] < 1e-2 and errors["wrong_terminations"] <= 4
    with pytest.raises(ValueError):
        bentray.Scene(MAPPED).verify(0)


def test_crossings_of_a_shell():
    shell = {
        **HOLE,
        "materials": {"shell": {"kind": "emissive", "color": [1, 1, 1]}},
        "objects": [{"shape": "sphere", "material": "shell", "radius": 8}],
    }
    x = [[-25.0, y, 0.0] for y in (0.0, 2.0, 4.0, 24.0)]
    found = bentray.Scene(shell).trace(x, [1, 0, 0], crossings=True)["crossings"]
    assert found["r"].shape == (4, 4) and found["x"].shape == (4, 4, 3)
    assert np.allclose(found["r"][:3, 0], 8, rtol=1e-6) and np.isnan(found["r"][3]).all() and np.isnan(found["r"][:, 1:]).all()
    assert list(found["object"][:, 0]) == [0, 0, 0, -1]
    clock = lambda r: np.sqrt(1 - 2 / r)
    start = np.linalg.norm(x, axis=1)[:3]
    # The ratio of the clocks of the shell and of the static observer at the start.
    assert np.allclose(found["g"][:3, 0], clock(8) / clock(start), rtol=1e-5)


def test_paths_lead_to_the_ends():
    x = [[-40, b, 0] for b in (3.0, 6.0, 20.0)]
    ends = bentray.Scene(HOLE).trace(x, [1, 0, 0], paths=True)
    for start, path, status, end in zip(x, ends["paths"], ends["status"], ends["x"]):
        assert path.shape[1] == 3 and len(path) > 2 and np.allclose(path[0], start)
        if status == bentray.Status.CAPTURED:
            assert np.linalg.norm(path[-1]) < 3
        else:
            # The ends of escaped rays are at infinity, and their paths end at the bounding sphere.
            assert np.isclose(np.linalg.norm(path[-1]), 50, rtol=0.2) and np.linalg.norm(end) >= 40


def test_errors_have_their_place_and_help():
    with pytest.raises(bentray.SceneError) as caught:
        bentray.Scene('[law]\nkind = "schwarzschild"\nmas = 2\n[rays]\nbounding_sphere = { radius = 50 }\n')
    (error,) = caught.value.errors
    assert (error["line"], error["column"]) == (3, 1)
    assert "mass" in error["help"] and "unknown key `mas`" in str(caught.value)
    with pytest.raises(bentray.SceneError, match="cannot read"):
        bentray.Scene.load("no/such/scene.toml")
    with pytest.raises(bentray.DeviceError, match="no such device"):
        bentray.Scene(BALL, device="no such device").render()
    with pytest.raises(bentray.RenderError, match="camera"):
        bentray.Scene(HOLE).render()
    with pytest.raises(ValueError, match="no layer"):
        bentray.Scene(BALL).render(layers=["colour"])


@pytest.mark.parametrize(
    "x, v",
    [
        ([1, 2], [1, 0, 0]),
        ([[1, 2, 3, 4]], [1, 0, 0]),
        ("abc", [1, 0, 0]),
        ([[0, 0, math.nan]], [1, 0, 0]),
        ([[0, 0, 0]], [math.inf, 0, 0]),
        ([[0, 0, 9]], [0, 0, 0]),
        ([[0, 0, 9]] * 2, [[1, 0, 0]] * 3),
        (np.zeros((2, 2, 3)), [1, 0, 0]),
        (np.array([[1j, 0, 0]]), [1, 0, 0]),
        ([[0, 0, 1e300]], [1, 0, 0]),
        (None, [1, 0, 0]),
    ],
)
def test_bad_rays_are_exceptions(x, v):
    with pytest.raises((ValueError, TypeError)):
        bentray.Scene(HOLE).trace(x, v)


def test_no_rays_have_no_ends():
    ends = bentray.Scene(HOLE).trace(np.empty((0, 3)), [1, 0, 0])
    assert ends["x"].shape == (0, 3) and ends["status"].shape == (0,)


def test_arrays_of_any_layout_and_type_are_rays():
    x = np.random.default_rng(1).uniform(-20, 20, (100, 3))
    scene = bentray.Scene(HOLE)
    expected = scene.trace(x, [1, 0, 0])
    for other in [np.asfortranarray(x), np.repeat(x, 2, axis=0)[::2], x.astype(">f8"), x.tolist()]:
        ends = scene.trace(other, np.array([1, 0, 0]))
        assert all(np.array_equal(ends[name], expected[name]) for name in expected)


def test_threads_share_a_scene():
    scene = bentray.Scene(BALL)
    expected = scene.render()["color"]
    results = []
    threads = [threading.Thread(target=lambda: results.append(scene.render()["color"])) for _ in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(results) == 8 and all(np.array_equal(result, expected) for result in results)


def test_a_notebook_shows_the_picture():
    png = bentray.Scene(BALL)._repr_png_()
    assert png.startswith(b"\x89PNG")
    assert json.loads(json.dumps(bentray.devices()))
    assert "40" in repr(bentray.Scene(BALL))


def test_a_forked_process_is_told():
    bentray.Scene(BALL).render()
    child = os.fork()
    if child == 0:
        try:
            bentray.Scene(BALL).render()
        except bentray.DeviceError as error:
            os._exit(0 if "fork" in str(error) else 2)
        os._exit(1)
    assert os.waitpid(child, 0)[1] == 0


def test_ctrl_c_cancels_a_render():
    script = (
        "import bentray, signal, threading, os, time\n"
        f"scene = bentray.Scene({BALL!r})\n"
        "scene.render()\n"
        "threading.Timer(0.5, lambda: os.kill(os.getpid(), signal.SIGINT)).start()\n"
        "start = time.monotonic()\n"
        "try:\n"
        "    scene.render(size=(4000, 3000), samples=4096)\n"
        "except KeyboardInterrupt:\n"
        "    assert time.monotonic() - start < 20\n"
        "    scene.render()\n"
        "    print('cancelled')\n"
    )
    ran = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=120)
    assert ran.stdout == "cancelled\n", ran.stderr


VALUES = [None, True, -1, 0, 3, 1e400, float("nan"), "", "a\x00b", "8 kpc", [], [1, 2, 3], [[1], 2], {}, {"a": 1}, {1: 2}]
VALUES += [np.zeros(3), np.zeros((0, 3)), np.float32(2), object(), b"x", 10**30, "[law]\nkind = ", {"law": {"kind": "kerr"}}]


def test_any_arguments_are_exceptions_or_right():
    rng = random.Random(1)
    scene = bentray.Scene(BALL)
    keys = ["camera.fov", "camera.position", "rays.method", "objects.0.radius", "sky", "image.size", "a.b", "", "units.mass"]
    calls = [
        lambda: bentray.Scene(rng.choice(VALUES)),
        lambda: bentray.Scene({rng.choice(["law", "rays", "camera", "sky", "x"]): rng.choice(VALUES)}),
        lambda: scene.set({rng.choice(keys): rng.choice(VALUES)}),
        lambda: scene.set({"camera.fov": 30}),
        lambda: scene.trace(rng.choice(VALUES), rng.choice(VALUES)),
        lambda: scene.render(layers=rng.choice([None, [], ["depth"], ["x"], VALUES])),
        lambda: scene.render(size=rng.choice([None, (0, 1), (8, 8), (1, 10**9), "ab", (1,), (-1, 2)])),
        lambda: scene.render(samples=rng.choice([None, 0, 1, 2, -1, 10**9, "x", 1.5]), size=(4, 4)),
    ]
    for _ in range(2000):
        try:
            rng.choice(calls)()
        except (ValueError, TypeError, OverflowError, bentray.RenderError, bentray.DeviceError):
            pass
        # A change that was accepted may be of any kind; a refused one leaves the scene as it was.
        if rng.random() < 0.05:
            scene = bentray.Scene(BALL)


DISK = """
[image]
size = [48, 36]
[camera]
position = [0, -30, 6]
up = [0, 0, 1]
observer = "static"
[law]
kind = "kerr-newman"
spin = 0.5
[rays]
bounding_sphere = { radius = 60 }
method = "separated"
[materials.matter]
kind = "accretion"
opacity = 0.5
temperature = 1e7
[[objects]]
shape = "disk"
material = "matter"
normal = [0, 0, 1]
radius = 14
inner_radius = 5
"""


def test_profiles_are_those_of_the_program(tmp_path):
    (tmp_path / "scene.toml").write_text(DISK)
    scene = bentray.Scene(DISK)
    for kind, column, options in [
        ("line", "g", {"emissivity": "r^-2"}),
        ("light-curve", "t", {"emissivity": "1 + cos(phi - 0.1 * t)", "range": (0, 50)}),
        ("spectrum", "frequency", {}),
    ]:
        extra = [f"--emissivity={options['emissivity']}"] if "emissivity" in options else []
        extra += ["--range=0,50"] if "range" in options else []
        command = [PROGRAM, "profile", "scene.toml", "--of", kind, "--points", "30", "-o", "a.npz", *extra]
        subprocess.run(command, cwd=tmp_path, check=True)
        expected = np.load(tmp_path / "a.npz")
        found = scene.profile(kind, points=30, **options)
        assert np.array_equal(found[column], expected[column]) and np.array_equal(found["flux"], expected["flux"])
        assert np.array_equal(found["orders"][:, 1], expected["order_1"]) and found["orders"][:, 1].max() > 0
    for arguments, problem in [
        ({"kind": "lines"}, "there is no kind"),
        ({"emissivity": "r^"}, "emissivity"),
        ({"emissivity": "4 - r"}, "the emissivity is -"),
        ({"kind": "light-curve"}, "requires a range"),
        ({"range": (2, 1)}, "empty or impossible"),
        ({"range": (math.nan, 1)}, "empty or impossible"),
        ({"points": 1}, "points"),
        ({"objects": [7]}, "there is no object 7"),
    ]:
        with pytest.raises(ValueError, match=problem):
            scene.profile(**arguments)
    with pytest.raises(ValueError, match="observer"):
        bentray.Scene(BALL).profile()


def test_jacobians_are_those_of_straight_rays():
    scene = bentray.Scene({"rays": {"bounding_sphere": {"radius": 10}, "precision": "f64"}})
    found = scene.trace([[0, 0, 0], [1, 2, 0]], [[1, 2, 3], [0.3, -1, 0]], jacobian=True)
    assert np.allclose(found["jacobian"]["direction"], np.eye(2), atol=1e-9)
    assert np.allclose(found["jacobian"]["magnification"], 1, atol=1e-9)
    distance = np.linalg.norm(found["x"] - [[0, 0, 0], [1, 2, 0]], axis=1)
    # The end is on the sphere, which is not perpendicular to a ray that misses its center.
    assert np.allclose(found["jacobian"]["position"][0], distance[0] * np.eye(2), atol=1e-7)
    assert scene.trace(np.zeros((0, 3)), np.zeros((0, 3)), jacobian=True)["jacobian"]["magnification"].shape == (0,)


def test_optical_paths_are_those_of_a_fisheye():
    eye = bentray.Scene(
        {
            "law": {"kind": "medium", "index": {"kind": "maxwell-fisheye", "n0": 2, "a": 1}},
            "rays": {"bounding_sphere": {"radius": 1}, "method": "dormand-prince", "tolerance": 1e-6},
        }
    )
    turns = np.array([0.3, 0.8, 1.2])
    found = eye.trace([1 - 1e-12, 0, 0], np.stack([-np.cos(turns), np.sin(turns), 0 * turns], -1), optical_path=True)
    assert np.allclose(found["optical_path"], math.pi, rtol=1e-8) and (found["length"] > 2).all()
    with pytest.raises(ValueError, match="medium"):
        bentray.Scene(HOLE).trace([10, 0, 0], [0, 1, 0], optical_path=True)


def test_a_law_is_a_string():
    law = """fn law_acceleration(x: Real3, held: Real) -> Real3 { return -law.k * x; }"""
    scene = bentray.Scene(
        {
            "law": {"kind": "wgsl", "code": law, "parameters": {"k": 1.0}},
            "rays": {"bounding_sphere": {"radius": 10}, "max_parameter": 1.25, "method": "rk4", "scaled_step": 0.01},
        }
    )
    found = scene.trace([2.0, 0, 0], [0, 1.0, 0])
    assert np.allclose(found["x"], [[2 * math.cos(1.25), math.sin(1.25), 0]], atol=1e-5)
    with pytest.raises(bentray.RenderError, match="law.code"):
        scene.set({"law.code": law.replace("* x", "* nonsense")})
        scene.trace([2.0, 0, 0], [0, 1.0, 0])


def test_methods_are_compared():
    scene = bentray.Scene(DISK.replace('method = "separated"', ""))
    rows = scene.compare(["separated"], rays=2000, compared=60, repeats=1)
    assert len(rows) > 2 and all(row["method"] == "separated" and row["seconds_per_ray"] > 0 for row in rows)
    assert rows[-1]["error_p99"] <= rows[0]["error_p99"]
    with pytest.raises(ValueError, match="there is no method"):
        scene.compare(["euler-maruyama"])


def test_long_work_shows_its_progress(monkeypatch):
    class Watched:
        def __init__(self):
            self.text = ""

        def isatty(self):
            return True

        def write(self, text):
            self.text += text

        def flush(self):
            pass

    watched = Watched()
    monkeypatch.setattr(sys, "stderr", watched)
    bentray.Scene(BALL).render(size=(800, 600), samples=64)
    assert "% done" in watched.text and watched.text.endswith("\r")
