import io
import math
import re
from dataclasses import replace

import numpy as np
import pytest
from gcodeparser import parse_gcode_lines

from workbench.errors import Refused
from workbench.files.export.cut_plan import planning
from workbench.files.export.gcode import write_gcode
from workbench.files.export.options import Cutting
from workbench.geometry.ball_cutter import CutFace
from workbench.geometry.outlines import Rectangle
from workbench.geometry.surface import ControlNet
from workbench.progress import finished
from workbench.scene.making.milling import Milling
from workbench.scene.making.polishing import Polishing

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


def passes(text):
    """Straight moves of each pass of a program, as (feed or rapid, start, end), by a parser.

    Comments in parentheses are removed first: the parser reads only comments after semicolons.
    """
    found, at = [], np.full(3, np.nan)
    for line in parse_gcode_lines(re.sub(r"\(.*?\)", "", text)):
        if line.command == ("M", 3):
            found.append([])
        if line.command in (("G", 0), ("G", 1)):
            end = [float(line.params.get(axis, now)) for axis, now in zip("XYZ", at, strict=True)]
            if found:
                found[-1].append((line.command[1], at, np.array(end)))
            at = np.array(end)
    return found


def moves(text):
    """Places at the ends of all cuts of the last pass of a program."""
    return np.array([end for kind, _, end in passes(text)[-1] if kind == 1])


@pytest.fixture
def program(make_design):
    def write(height=lambda x, y: 0.5 + 0.1 * x + 0.05 * x**2 + 0 * y, **cutting):
        net = {"lens.control_points": [40, 30], "unit": cutting.pop("unit", "cm")}
        x, y = make_design(net).net.positions
        cutting = Cutting(**{"tool_radius": 0.2, "scallop": 0.002, **cutting})
        design = replace(make_design(net, height(x[:, None], y)), options=(cutting,))
        file = io.BytesIO()
        return file, write_gcode(design, file), design

    return write


def test_a_program_is_in_millimetres_and_travels_at_a_safe_height(program):
    file, deviation, design = program(rim=0.1, safe_height=0.3, feed=400.0)
    text = file.getvalue().decode()
    lines = text.splitlines()
    assert "G21 G90 G17 G94 G54" in lines
    assert "(stock 22.000 x 16.000 x " in text  # of 20 × 14 mm, a rim of 1 mm around
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
    begin = ["G61", "G0 Z", "M3 S12000", "G4 P2.5", "G0 X Y", "G1 Z F90", "G1 X Y Z F480"]
    assert kinds[1:8] == begin
    assert set(kinds[8:-3]) == {"G1 X Y Z"}
    assert kinds[-3:] == ["G0 Z", "M5", "M30"]
    assert "spindle speed: 12000 clockwise" in text


@pytest.mark.parametrize("unit", ["mm", "m"])
def test_every_line_is_one_that_grbl_reads(program, unit):
    text = program(unit=unit)[0].getvalue().decode("ascii")
    word = r"(G(0|1|4|17|21|54|61|90|94)|M(3|5|30)|[XYZFSP]-?\d+(\.\d+)?)"
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
        ("tool_radius", -1, "above 0"),
        ("cutter", "7 mm", "one of 0.5 mm, 1 mm"),
        ("dialect", "heidenhain", "one of grbl, linuxcnc, fanuc"),
        ("program", 0, "from 1 to 9,999"),
        ("stock", 0, "above 0"),
    ],
)
def test_impossible_values_are_refused_with_what_is_allowed(field, value, allowed):
    with pytest.raises(Refused, match=f"^{field}: .*{allowed}"):
        Cutting(**{field: value})


WAYS = {
    "mould": {"negative": True},
    "ellipse": {"dialect": "fanuc", "origin": "corner", "rim": 0.2, "roughing": "flat"},
    "entrance": {"dialect": "linuxcnc", "origin": "bottom", "roughing": "ball"},
    "mirror": {"dialect": "fanuc", "roughing": "ball", "roughing_cutter": "3 mm"},
}


def lowest(path, ball, x, y):
    """Lowest height of the cutter along moves over points (m,), by dense places of its tip."""
    radius, is_ball = ball
    share = np.linspace(0, 1, 24)[:, None, None]
    starts, ends = (np.array(each) for each in zip(*path, strict=True))
    places = (starts + share * (ends - starts)).reshape(-1, 3)
    found = []
    for x_k, y_k in zip(x, y, strict=True):
        square = radius**2 - (places[:, 0] - x_k) ** 2 - (places[:, 1] - y_k) ** 2
        side = radius - np.sqrt(square.clip(0)) if is_ball else 0.0
        found.append((places[:, 2] + side)[square > 0].min(initial=np.inf))
    return np.array(found)


def zero_of(text, origin):
    """The zero of a program from the middle and the top of the stock, by its comments, mm."""
    text = text.lower()
    size = re.search(r"stock (\S+) x (\S+) x (\S+), cut", text)
    width, height, thick = map(float, size.groups())
    return {
        "top": (0, 0, 0),
        "corner": (-width / 2, -height / 2, 0),
        "bottom": (0, 0, -thick),
    }[origin]


@pytest.mark.parametrize("side", WAYS)
def test_cutters_along_the_written_moves_leave_the_face(make_design, make_mirror, rng, side):
    """Read back by another parser and swept by other means: nothing is cut too deep."""
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
    cutting = Cutting(scallop=0.01, stock_above=0.05, **WAYS[side])
    file = io.BytesIO()
    deviation = write_gcode(replace(design, options=(cutting,)), file)
    text, mm = file.getvalue().decode(), 1e3 * design.metres
    radii = [float(each) for each in re.findall(r"radius (\S+)\)", text, re.IGNORECASE)]
    cutters = [(radius, True) for radius in radii]
    if cutting.roughing == "flat":
        cutters[0] = radii[0], False
    x, y = design.outline.evenly(*rng.random((2, 25)))
    z = design.net.at(x, y, design.heights)[0]
    up = -design.outward if cutting.negative else design.outward
    top = (up * design.heights).max() + cutting.stock_above
    zero = np.array(zero_of(text, cutting.origin))
    x, y, z = up * x * mm - zero[0], y * mm - zero[1], (up * z - top) * mm - zero[2]
    above = []
    found = passes(text)
    assert len(found) == len(cutters) == (1 if cutting.roughing == "none" else 2)
    for moves_of, cutter in zip(found, cutters, strict=True):
        cuts = [(start, end) for kind, start, end in moves_of if kind == 1]
        above.append(lowest(cuts, cutter, x, y) - z)
        assert lowest(cuts, cutter, x, y).max() < np.inf
    assert above[-1].min() > -1e-3  # mm
    assert above[-1].max() < 1.3 * deviation.size * mm
    if cutting.roughing != "none":
        allowance = float(re.search(r"allowance (\S+)\)", text, re.IGNORECASE)[1])
        assert above[0].min() > allowance
        stated = re.search(r"leaves (\S+) to (\S+) along", text, re.IGNORECASE).groups()
        assert float(stated[0]) < above[0].min() + 0.05 and above[0].max() < float(stated[1]) + 0.05
    assert finished(planning(replace(design, options=(cutting,)))).errors.cut_off * mm < 1e-3


def test_travel_is_above_the_stock_and_plunges_are_straight(program):
    text = program(roughing="flat", stock_above=0.2, safe_height=0.1)[0].getvalue().decode()
    for moves_of in passes(text):
        for kind, start, end in moves_of[1:]:
            if kind == 0:  # up, or across at the safe height: 1 mm above the stock
                assert end[2] >= 1 - 1e-9 and (start[2] == end[2] or (start == end)[:2].all())
            elif (start == end)[:2].all():
                assert start[2] >= end[2]


def test_a_flat_face_is_roughed_to_the_allowance_level_by_level(program):
    cutting = {"roughing": "flat", "roughing_cutter": "2 mm", "stock_above": 0.25}
    file, *_ = program(lambda x, y: 0.5 + 0 * (x + y), step_down=0.1, allowance=0.02, **cutting)
    rough, _ = passes(file.getvalue().decode())
    levels = {round(end[2], 5) for kind, start, end in rough if kind == 1}
    assert levels == {-1.0, -2.0, -2.3}  # mm below the stock, which is 2.5 mm above the face


def test_a_program_for_fanuc_has_a_number_and_numbered_blocks(program):
    text = program(dialect="fanuc", program=42, coolant=True)[0].getvalue().decode()
    first, second, *lines, end, last = text.splitlines()
    assert (first, second, last) == ("%", "O0042", "%")
    blocks = [line for line in lines if not line.startswith("(")] + [end]
    assert [line.split()[0] for line in blocks[:3]] == ["N10", "N20", "N30"]
    assert all(line == line.upper() and re.match(r"N\d{1,5} ", line) for line in blocks)
    words = {word for line in blocks for word in line.split()}
    assert {"G43", "H1", "T1", "M6", "M8", "M9", "M30", "G54", "G80", "X3.000"} <= words
    numbers = [word[1:] for line in blocks for word in line.split()[1:] if word[0] in "XYZ"]
    assert all(re.fullmatch(r"-?\d+\.\d{3}", number) for number in numbers)


def test_linuxcnc_blends_roughing_within_the_allowance_and_finishes_exactly(program):
    cutting = {"dialect": "linuxcnc", "roughing": "flat", "roughing_cutter": "2 mm"}
    text = program(stock_above=0.1, allowance=0.03, **cutting)[0].getvalue().decode()
    lines = text.splitlines()
    assert lines.index("G64 P0.1500") < lines.index("T2 M6") < lines.index("G61")


def test_the_default_is_the_largest_standard_cutter_that_fits(program):
    def cutter(height):
        text = program(lambda x, y: 0.5 + height(x) + 0 * y, tool_radius=None, scallop=0.004)[0]
        return re.search(r"\((.*)ball cutter: radius (\S+)\)", text.getvalue().decode()).groups()

    assert cutter(lambda x: 0.05 * x**2) == (
        "1/4 inch ",
        "3.1750",
    )  # at most half of the half-width, 7 mm
    assert cutter(lambda x: 1.8 * x**2) == ("2 mm ", "1.0000")
    name, radius = cutter(lambda x: 0.04 * np.cos(40 * x))
    assert name == "" and 0 < float(radius) < 0.25


@pytest.mark.parametrize(
    "cutting, why",
    [
        ({"tool_radius": 0.8}, r"^tool_radius: .* wider than the part; at most 0.7 cm"),
        ({"roughing": "flat", "roughing_cutter": "6 mm"}, "^$"),
        ({"stock": 0.3}, r"^stock: 0.3 cm is too thin for the part; at least"),
        ({"stock": 0.62, "stock_above": 0.1}, r"^stock: .* too thin"),
        ({"negative": True, "stock": 0.01}, r"^stock: .* too thin"),
        ({"roughing": "flat", "step_down": 1e-7}, r"^step_down: .* levels"),
    ],
)
def test_what_cannot_be_cut_is_refused(program, cutting, why):
    if why == "^$":
        program(**cutting)
    else:
        with pytest.raises(Refused, match=why):
            program(**cutting)


def test_a_cutter_that_does_not_fit_is_refused_with_one_that_fits(program):
    def height(x, y):
        return 0.5 + 0.02 * np.cos(40 * x) + 0 * y

    with pytest.raises(Refused, match=r"^tool_radius: a ball cutter of 0.2 cm does not fit") as no:
        program(height=height)
    (fitting,) = re.findall(r"one of (\S+) cm fits", str(no.value))
    assert 0 < program(height=height, tool_radius=float(fitting), scallop=0.004)[1].size < 0.008


def test_the_cut_among_the_processes_of_a_design_is_written(make_design):
    """With its cutter and step-over, which make scallops higher on the steep parts."""
    bare = make_design()
    milled = bare.scene.altered(
        processes=(Milling(ball_radius=0.05, step_over=0.02), Polishing(width=0.01))
    )
    y = bare.net.positions[1]
    flat = np.full(bare.net.shape, 0.5)
    for heights, higher in ((flat + 0.3 * y, 1 + 0.3**2), (flat, 1.0)):
        design = replace(make_design(heights=heights), scene=milled)
        plan = finished(planning(design))
        assert plan.raster.radius == 0.05
        assert 0.95 * 0.02 < np.diff(plan.raster.y).max() <= 0.02 * (1 + 1e-9)
        planned = 0.05 - math.sqrt(0.05**2 - higher * 0.01**2)
        assert plan.scallop == pytest.approx(planned, rel=1e-3)
    other = finished(planning(replace(design, options=(Cutting(tool_radius=0.1),))))
    assert other.raster.radius == 0.1
