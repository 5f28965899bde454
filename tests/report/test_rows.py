"""Rows of a report: bound, check, differences."""

import numpy as np
import pytest

from resources import path
from tests.analysis.lenses import net_of
from tests.lamps import PLATE, led
from tests.scenes import changed
from workbench.analysis.light_limit import light_limits
from workbench.analysis.manufacture import manufacture
from workbench.analysis.shop_limits import Limits
from workbench.analysis.validation import validate
from workbench.cli.validate import print_image
from workbench.extended.bound import Bound
from workbench.report.element_table import element_table
from workbench.report.figures import area_table, bound_rows, check_rows, percent, result_table
from workbench.report.scene_rows import differences, field_rows, scene_rows
from workbench.scene import Scene, Screen

GRID = {"kind": "grid", "center": [0, 0, -4], "half_width": [0.3, 0.3], "points": [50, 50]}


def test_report_says_what_no_lens_is_below(make_scene, rng):
    found = Bound(make_scene({"source": GRID}), rng.random((32, 32)))
    light, least, narrower, blur = bound_rows(found)
    assert light == ("light with any lens, at most", f"{light_limits(found.scene)[0].percent} %")
    assert (least.name, least.value) == ("no lens is below", percent(found.relative_l2))
    assert (narrower.name, narrower.value) == (
        "a source half as wide would allow",
        percent(found.half_as_wide),
    )
    assert found.half_as_wide < found.relative_l2
    assert "pixels" in blur.value


@pytest.fixture(scope="module")
def checked(tmp_path_factory):
    """A flat plate before 4,000 rays of a file, on an image that their number makes rough."""
    source = led(tmp_path_factory.mktemp("led"), 4000)
    few = {"source": source, "screen.half_width": [1.0, 1.0]}
    scene = Scene.from_data(changed(PLATE | few))
    heights = {"lens.back": net_of(scene, lambda x, y: np.full_like(x + y, 0.5))}
    even = validate(scene, np.ones((40, 40)), heights, 4000, accuracy=1e-3)
    return validate(scene, even.by_cells.irradiance, heights, 4000, accuracy=1e-3)


def test_an_error_that_few_rays_cannot_tell_from_none_is_below_its_upper_end(checked):
    found, rows = checked, dict(check_rows(checked, 0.0))
    assert found.by_cells.relative_l2_corrected_interval[0] == 0
    high = found.by_cells.relative_l2_corrected_interval[1]
    assert rows["verified error"] == f"< {100 * high:.3f} %"
    assert rows["error by random rays"].startswith("< ")
    assert "off" not in rows["beam mesh"]
    assert rows["error by image pairs"].startswith("4,000 rays, 95 % confidence; off by up")


def test_so_says_the_command(checked, capsys):
    print_image(checked, None, Screen(position=(0.0, 0.0, 5), half_width=(1, 1), pixels=(40, 40)))
    lines = capsys.readouterr().out.splitlines()
    high = checked.by_cells.relative_l2_corrected_interval[1]
    assert lines[0] == f"verified error    < {high:.5f}  (relative L2, 0.00000 to {high:.5f})"
    assert lines[2].split() == ["loss", "-"]
    assert any(line.startswith("without ray noise <") for line in lines)


def test_scenes_differ_where_their_values_do(make_scene):
    one = make_scene()
    other = make_scene({"screen.z": 6.5, "target": {"builtin": "ball"}, "run.seed": 3})
    found = dict(differences(one, other))
    assert found["Run · Seed"] == ("0", "3")
    assert found["Images 1 · Receiver · Position"] == ("0, 0, 5 cm", "0, 0, 6.5 cm")
    assert all(title.startswith(("Run", "Images 1 · ")) for title in found)
    assert differences(one, one) == ()


def rows(scene):
    return {group: dict(facts) for group, facts in scene_rows(scene).items()}


def test_every_field_has_a_row_with_its_unit(make_scene):
    found = rows(make_scene({"unit": "mm", "run.min_radius": 0.5}))
    assert found["Lens"]["Size"] == "2 × 2 mm"  # as in forms
    assert found["Lens"]["Back face · Height range"] == "-0.3 to 0.3 mm"
    assert found["Lens"]["Back face · Control points"] == "12 × 10"
    assert found["Receiver"]["Position"] == "0, 0, 5 mm"
    assert found["Image filter"]["Alpha"] == "1 per pixel²"
    assert found["Target"]["Invert"] == "no"
    assert found["Run"]["Smallest radius"] == "0.5 mm"
    assert found["Scene"] == {"Unit": "mm", "Weight": "1"}


def test_values_are_the_words_of_the_forms(make_scene):
    found = rows(make_scene({"target": {"image": "/some/folder/light.png"}}))
    assert (found["Source"]["Kind"], found["Lens"]["Front face · Shape"]) == (
        "Collimated light",
        "Plane",
    )
    assert (found["Target"]["Fit"], found["Run"]["Computes on"]) == (
        "All of the picture",
        "Processor",
    )
    assert found["Target"]["Image"] == "light.png"
    for values in found.values():
        assert not any("_" in text or "elements[" in text for text in (*values, *values.values()))


def leaves(data, path=""):
    if isinstance(data, dict):
        for name, value in data.items():
            yield from leaves(value, f"{path}.{name}" if path else name)
    elif isinstance(data, list) and not any(isinstance(value, (int, float)) for value in data):
        for number, value in enumerate(data):
            yield from leaves(value, f"{path}[{number}]")
    else:
        yield path


@pytest.mark.parametrize(
    "changes",
    [
        {},
        {"source": {"kind": "point", "position": [0, 0, -5]}},
        {"source": {"kind": "grid", "center": [0, 0, -5], "half_width": [1, 1], "points": [3, 3]}},
        {"run": {"method": "paper", "learning_rate": 0.01}},
        {"lens.outline": "ellipse"},
    ],
)
def test_every_field_of_the_scene_has_a_row(make_scene, changes):
    scene = make_scene(changes)
    wanted = set(leaves(scene.to_data())) - {"format", "version"}
    assert wanted == {row.path for row in field_rows(scene)}


@pytest.fixture(scope="module")
def even():
    """A flat plate whose image is even, with goals."""
    goals = {"run.min_uniformity": 0.5, "run.min_light": 0.95, "lens.min_thickness": 0.1}
    scene = Scene.from_data(changed({"screen.half_width": [0.5, 0.5]} | goals))
    heights = {"lens.back": np.full(scene.optic.net_shape, 0.5)}
    target = np.zeros((32, 32))
    target[8:24, 8:24] = 1.0
    return scene, validate(scene, target, heights, 4000, accuracy=1e-3), heights


def test_the_result_is_judged_by_goals_and_limits_of_the_part(even):
    scene, found, heights = even
    limits = Limits(min_thickness=0.1, min_radius=0.5)
    made = [(scene.optic, manufacture(scene.optic, heights), limits)]
    figures = {name: rest for name, *rest in result_table(scene, found, made).rows}
    assert figures["Relative L2 error"][1:] == ["–", "–"]
    assert figures["Light on the screen"][1:] == ["at least 95 %", "not met"]
    even = figures["U₀ (minimum / average) on the lit area of the target"]
    assert even[1:] == ["at least 0.5", "met"] and float(even[0]) > 0.99
    assert figures["Thickness"] == ["0.5 cm", "at least 0.1 cm", "met"]


def test_areas_stand_in_a_table_with_their_light(even):
    _, found, _ = even
    header, ((area, *values),) = area_table(found)
    assert area == "Lit area of the target"
    shown = dict(zip(header[1:], values, strict=True))
    assert shown["Average"].endswith("× mean")
    assert float(shown["U₁ (minimum / maximum)"]) > 0.99
    assert "uniformity" not in dict(check_rows(found, 0.0))


def test_elements_stand_in_a_table():
    dome = {"kind": "lens", "name": "dome", "position": [0, 0, -9.9], "half_width": [2.4, 2.4]}
    dome |= {"outline": "ellipse", "material": {"index": 1.41}, "thickness": 2.5}
    dome |= {"faces": [{"shape": "plane"}, {"shape": "conic", "radius": -2.5, "conic": -0.5}]}
    scene = Scene.from_json(path("examples", "dome-cover.json").read_text())
    scene = Scene.from_data(
        scene.to_data() | {"elements": [dome, *scene.to_data()["elements"][1:]]}
    )
    header, rows = element_table(scene)
    first = dict(zip(header, rows[0], strict=True))
    assert [row[0] for row in rows] == ["dome", "lens", "cover"]
    assert (first["Kind"], first["Material"], first["Tilt"]) == ("lens", "n = 1.41", "none")
    assert first["Position"] == "0, 0, -9.9 mm"
    assert first["Size"] == "4.8 × 4.8 mm, ellipse"
    assert first["Faces"] == "plane; conic, radius -2.5 mm, conic constant -0.5"
    assert rows[2][header.index("Material")].startswith("PMMA (n = 1.49")
