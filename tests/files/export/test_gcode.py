import io
import math
import re
from dataclasses import replace

import numpy as np
import pytest

from workbench.errors import Refused
from workbench.files.export.gcode import planning, write_gcode
from workbench.files.export.options import Cutting
from workbench.geometry.ball_cutter import CutFace
from workbench.geometry.outlines import Rectangle
from workbench.geometry.surface import ControlNet
from workbench.progress import finished

NET = ControlNet((24, 20), (3, 3), (1.0, 0.8))
RADIUS, SCALLOP = 0.2, 0.002


def face_of(height):
    """A face whose control heights are those of a function: close to it."""
    x, y = NET.positions
    return CutFace(NET, height(x[:, None], y), Rectangle(NET.half_width))


def bowl(x, y):
    return 0.3 * (x**2 + y**2)


def waves(x, y):
    return 0.02 * np.cos(5 * x) * np.cos(4 * y)


def test_a_plane_is_left_with_ridges_of_the_stated_height():
    face = face_of(lambda x, y: 0 * x + 0 * y)
    raster = finished(face.plan_raster(RADIUS, SCALLOP, 10**6))
    assert raster.tip == pytest.approx(0, abs=1e-15)
    apart = raster.y[1] - raster.y[0]
    ridge = RADIUS - math.sqrt(RADIUS**2 - (apart / 2) ** 2)
    assert 0.9 * SCALLOP < ridge <= SCALLOP * (1 + 1e-12)  # a whole number of cuts
    between = (raster.y[3] + raster.y[4]) / 2
    cut = raster.cut_at(raster.x[[7, 7]], np.array([between, raster.y[3]]))
    assert cut == pytest.approx([ridge, 0], rel=0.01, abs=1e-4 * SCALLOP)


@pytest.mark.parametrize(
    "height", [bowl, lambda x, y: -bowl(x, y), waves, lambda x, y: 0.5 * x - 0.3 * y]
)
def test_nothing_is_cut_off_and_ridges_are_at_most_as_high_as_stated(height):
    face = face_of(height)
    raster = finished(face.plan_raster(RADIUS, SCALLOP, 10**6))
    cut_off, left, _ = finished(face.cut_errors(raster))
    assert cut_off < 0.02 * SCALLOP
    assert 0.2 * SCALLOP < left < 1.1 * SCALLOP


def moves(text):
    """Places of all cuts of a program."""
    found = re.findall(r"^G1 X(\S+) Y(\S+) Z(\S+)$", text, re.MULTILINE)
    return np.array(found, dtype=float)


@pytest.fixture
def program(make_design):
    def write(height=lambda x, y: 0.5 + 0.1 * x + 0.05 * x**2 + 0 * y, **cutting):
        net = {"lens.control_points": [40, 30], "unit": cutting.pop("unit", "cm")}
        x, y = make_design(net).net.positions
        cutting = Cutting(**{"tool_radius": 0.2, "scallop": 0.002, **cutting})
        design = replace(make_design(net, height(x[:, None], y)), cutting=cutting)
        file = io.BytesIO()
        return file, write_gcode(design, file), design

    return write


def test_a_program_is_in_millimetres_and_travels_at_a_safe_height(program):
    file, deviation, design = program(rim=0.1, safe_height=0.3, feed=400.0)
    text = file.getvalue().decode()
    lines = text.splitlines()
    assert "G21 G90 G17 G94" in lines
    assert "(stock 22.000 x 16.000," in text  # of 20 × 14 mm, a rim of 1 mm around
    x, y, z = moves(text).T
    assert x.max() >= 10 and y.max() >= 7
    safe = [float(line.removeprefix("G0 Z")) for line in lines if line.startswith("G0 Z")]
    assert safe == pytest.approx([z.max() + 3] * 2, abs=1e-4)
    top = z[(abs(x) < 10) & (abs(y) < 7)].max()
    assert -0.1 < top < 0.1  # at the top of the face, where the ball's side touches it
    assert deviation.unit == design.unit
    assert 0 < deviation.size < 2 * 0.002


def test_a_program_starts_the_spindle_and_waits_before_it_plunges(program):
    values = {"feed": 480.0, "plunge_feed": 90.0, "spindle_speed": 12_000.0, "dwell": 2.5}
    text = program(**values)[0].getvalue().decode()
    lines = [line for line in text.splitlines() if not line.startswith("(")]
    kinds = [re.sub(r"([XYZ])\S+", r"\1", line) for line in lines]
    begin = ["G0 Z", "M3 S12000", "G4 P2.5", "G0 X Y", "G1 Z F90", "G1 X Y Z F480"]
    assert kinds[1:7] == begin
    assert set(kinds[7:-3]) == {"G1 X Y Z"}
    assert kinds[-3:] == ["G0 Z", "M5", "M30"]
    assert "spindle speed: 12000 clockwise" in text


@pytest.mark.parametrize("unit", ["mm", "m"])
def test_every_line_is_one_that_grbl_and_linuxcnc_read(program, unit):
    text = program(unit=unit)[0].getvalue().decode("ascii")
    word = r"(G(0|1|4|17|21|90|94)|M(3|5|30)|[XYZFSP]-?\d+(\.\d+)?)"
    for line in text.splitlines():
        assert len(line) < 80
        assert re.fullmatch(rf"\([^()]*\)|{word}( {word})*", line)
        letters = [word[0] for word in line.split() if word[0] not in "G("]
        assert line.startswith("(") or len(letters) == len(set(letters))


@pytest.mark.parametrize(
    "field, value, allowed",
    [
        ("spindle_speed", 0, "from 1 to 200,000 rpm"),
        ("feed", 0, "from 1 to 100,000 mm/min"),
        ("plunge_feed", math.nan, "from 1 to 100,000 mm/min"),
        ("dwell", -1, "from 0 to 600 s"),
        ("safe_height", 0, "above 0"),
        ("rim", -1, "0 or more"),
        ("tool_radius", math.inf, "above 0"),
    ],
)
def test_impossible_values_are_refused_with_what_is_allowed(field, value, allowed):
    with pytest.raises(Refused, match=f"^{field}: .*{allowed}"):
        Cutting(**{field: value})


@pytest.mark.parametrize("side", ["mould", "ellipse", "entrance", "mirror"])
def test_balls_along_the_written_moves_leave_the_face(make_design, make_mirror, rng, side):
    """Read back and swept by other means: what remains is what the program states."""
    unit = "inch"
    changes = {"unit": unit, "version": 2}
    heights = 0.5 + 0.004 * rng.normal(size=(12, 10))
    if side == "mirror":
        design = make_mirror({"unit": unit}, 0.004 * rng.normal(size=(7, 6)))
    elif side == "entrance":
        changes["lens.entrance"] = {"shape": "freeform", "control_points": [7, 9]}
        small = 0.004 * rng.normal(size=(7, 9))
        design = replace(make_design(changes, heights, entrance=small), face="lens.front")
    else:
        outline = {"lens.outline": "ellipse"} if side == "ellipse" else {}
        design = make_design(changes | outline, heights)
    cutting = Cutting(scallop=0.01, negative=side == "mould")
    file = io.BytesIO()
    deviation = write_gcode(replace(design, cutting=cutting), file)
    text = file.getvalue().decode()
    mm = 1e3 * design.metres
    ball = float(re.search(r"radius (\S+)\)", text)[1])
    path = moves(text)
    share = np.linspace(0, 1, 8, endpoint=False)[:, None, None]
    path = (path[:-1] + share * np.diff(path, axis=0)).reshape(-1, 3)
    x, y = design.outline.evenly(*rng.random((2, 25)))
    z = design.net.at(x, y, design.heights)[0]
    up = -design.outward if cutting.negative else design.outward
    top = (up * design.heights).max()
    left = []
    for x_k, y_k, z_k in zip(up * x * mm, y * mm, (up * z - top) * mm, strict=True):
        square = ball**2 - (path[:, 0] - x_k) ** 2 - (path[:, 1] - y_k) ** 2
        side_z = path[:, 2] + ball - np.sqrt(square.clip(0))
        left.append(side_z[square > 0].min() - z_k)
    assert -1e-3 * 0.01 * mm < min(left)
    assert finished(planning(replace(design, cutting=cutting))).errors.cut_off < 1e-3 * 0.01
    assert max(left) < 1.3 * deviation.size * mm


def test_a_cutter_that_does_not_fit_is_refused_with_one_that_fits(program):
    def height(x, y):
        return 0.5 + 0.02 * np.cos(40 * x) + 0 * y

    with pytest.raises(Refused, match=r"^tool_radius: a ball cutter of 0.2 cm does not fit") as no:
        program(height=height)
    (fitting,) = re.findall(r"one of (\S+) cm fits", str(no.value))
    assert 0 < program(height=height, tool_radius=float(fitting), scallop=0.004)[1].size < 0.008
