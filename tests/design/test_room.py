"""The range of a run: what its task needs of it, and what is said where that is not allowed."""

import numpy as np
import pytest

from workbench.design import room as room_module
from workbench.design.aim import first_lens
from workbench.design.room import Room
from workbench.design.run import run
from workbench.design.shortfall import Shortfall, wider_entrance

FREE = {"lens.height_range": None, "lens.control_points": [24, 24]}


@pytest.fixture
def corner():
    """Light in one quarter of the screen."""
    image = np.zeros((32, 32))
    image[4:14, 4:14] = 1.0
    return image


def ends(room):
    free = room.height_range().ranges["exit"]
    return free.lower.min().item(), free.upper.max().item()


def test_an_automatic_range_holds_the_first_lens_with_some_space(make_scene, corner):
    room = Room(make_scene(FREE), corner)
    low, high = ends(room)
    most = np.abs(room.first["exit"] - 0.5).max()
    assert high - 0.5 == pytest.approx(3 * most)
    assert low == max(0.05, 0.5 - 3 * most)
    assert room.notes == (f"heights within {3 * most:.3g} cm of the base",)


def test_an_automatic_range_holds_the_lens_that_the_run_goes_on_from(make_scene, corner):
    heights = np.full((24, 24), 1.9)
    assert ends(Room(make_scene(FREE), corner, {"exit": heights}))[1] > 1.9


def test_an_automatic_range_keeps_to_the_stock(make_scene, corner):
    stock = {"lens.max_thickness": 0.6, "lens.min_thickness": 0.2}
    assert ends(Room(make_scene(FREE | stock), corner)) == (0.2, 0.6)


def test_an_automatic_range_is_never_empty(make_scene):
    # An even image as large as the lens needs no bending at all.
    low, high = ends(Room(make_scene(FREE), np.ones((32, 32))))
    assert 0.01 < 0.5 - low < 0.3 and 0.01 < high - 0.5 < 0.3


def test_the_range_of_a_scene_is_taken_as_it_is(make_scene, corner):
    room = Room(make_scene(), corner)
    assert ends(room) == pytest.approx((0.2, 0.8))
    assert room.notes == ()


def test_runs_by_either_method_take_an_automatic_range(make_scene, corner):
    for settings in ({"method": "auto", "iterations": 3}, {"method": "paper", "iterations": 3}):
        shots = list(run(make_scene(FREE | {"run": settings}), corner))
        assert shots[-1].state.loss < shots[0].state.loss
        assert "of the base" in shots[-1].notes[-1]
        assert shots[0].state.heights["exit"] == pytest.approx(0.5, abs=1e-12)
        assert shots[-1].state.shortfall is None


def test_a_too_small_range_is_reported_with_the_range_that_is_needed(make_scene, corner):
    *_, last = run(make_scene(FREE | {"lens.height_range": [-0.05, 0.05]}), corner)
    short = last.state.shortfall
    first = Room(make_scene(FREE), corner).first["exit"]
    assert (short.cause, short.allowed) == ("height_range", (-0.05, 0.05))
    assert short.needed == pytest.approx((first.min() - 0.5, first.max() - 0.5), rel=0.1)
    assert short.share > 0.1


def test_a_range_that_is_large_enough_is_no_shortfall(make_scene, corner):
    assert all(shot.state.shortfall is None for shot in run(make_scene({}), np.ones((32, 32))))


def test_too_thin_stock_is_reported_with_the_thickness_that_is_needed(make_scene, corner):
    stock = {"lens.max_thickness": 0.2, "lens.min_thickness": 0.1}
    *_, last = run(make_scene(FREE | stock), corner)
    short = last.state.shortfall
    extent = np.ptp(Room(make_scene(FREE), corner).first["exit"])
    assert (short.cause, short.allowed) == ("max_thickness", (0.1, 0.2))
    assert short.needed == pytest.approx((0.1, 0.1 + extent), rel=0.1)


def test_stock_is_the_limit_even_where_a_range_is_given(make_scene, corner):
    stock = {"lens.max_thickness": 0.55, "lens.min_thickness": 0.45}
    *_, last = run(make_scene(FREE | stock | {"lens.height_range": [-0.3, 0.3]}), corner)
    assert last.state.shortfall.cause == "max_thickness"


def test_a_continued_run_reports_a_shortfall_once_heights_are_at_their_limits(make_scene, corner):
    scene = make_scene(FREE | {"lens.height_range": [-0.05, 0.05]})
    first, *_ = run(scene, corner, start={"exit": np.full((24, 24), 0.5)})
    assert first.state.shortfall is None
    half = np.where(np.arange(24)[:, None] < 12, 0.45, 0.55) * np.ones((24, 24))
    first, *_ = run(scene, corner, start={"exit": half})
    assert first.state.shortfall.cause == "height_range" and first.state.shortfall.share == 1.0


def test_locked_heights_at_an_end_are_no_shortfall(make_scene):
    locked = np.zeros((24, 24), dtype=bool)
    locked[:, :6] = True
    start = np.where(locked, 0.8, 0.5)
    scene = make_scene(FREE | {"lens.height_range": [-0.3, 0.3]})
    first, *_ = run(scene, np.ones((32, 32)), start={"exit": start}, locked={"exit": locked})
    assert first.state.shortfall is None


@pytest.mark.parametrize(
    ("shortfall", "sentence"),
    [
        (
            Shortfall("height_range", (-2.2, 2.2), (-0.3, 0.3), 0.4),
            "The lens needs ±2.2 mm; ±0.3 mm is allowed",
        ),
        (
            Shortfall("height_range", (-1.0, 3.4), (-0.2, 0.3), 0.4),
            "The lens needs -1 to 3.4 mm; -0.2 to 0.3 mm is allowed",
        ),
        (
            Shortfall("height_range", None, (-0.3, 0.3), 0.4),
            "40 % of the control heights are at an end of their range; ±0.3 mm is allowed",
        ),
        (
            Shortfall("max_thickness", (2.0, 9.3), (2.0, 8.0), 0.4),
            "The lens needs to be 9.3 mm thick; the stock allows 8 mm",
        ),
        (
            Shortfall("screen", None, (2.0, 8.0), 0.4),
            "40 % of the control heights are at the largest thickness; 8 mm is the automatic limit",
        ),
        (
            Shortfall("screen", (2.0, 9.3), (2.0, 8.0), 0.4),
            "The lens needs to be 9.3 mm thick; the screen leaves room for 8 mm",
        ),
        (
            Shortfall("max_thickness", None, (2.0, 8.0), 0.4),
            "40 % of the control heights are at the largest thickness; the stock allows 8 mm",
        ),
        (
            Shortfall("min_thickness", None, (2.0, 8.0), 0.4),
            "40 % of the control heights are at the minimal thickness of 2 mm",
        ),
    ],
)
def test_a_shortfall_is_one_plain_sentence(make_scene, shortfall, sentence):
    assert shortfall.sentence(make_scene({"unit": "mm"})) == sentence


def test_a_shortfall_says_what_the_optic_is_called(make_scene):
    mirror = {"half_width": [1, 1], "control_points": [8, 8], "height_range": [-0.3, 0.3]}
    scene = make_scene({"lens": None, "mirror": mirror, "screen.z": -5.0})
    short = Shortfall("height_range", (-2.2, 2.2), (-0.3, 0.3), 0.4)
    assert short.sentence(scene) == "The mirror needs ±2.2 cm; ±0.3 cm is allowed"


MIRROR = {"mirror": {"half_width": [1, 1], "control_points": [16, 16]}, "lens": None}
FAR = {"screen": None, "far_field": {"half_angle": [8, 8], "pixels": [16, 16]}}


@pytest.mark.parametrize(
    ("cause", "changes", "field"),
    [
        ("height_range", {"lens.height_range": None}, "lens.height_range"),
        ("height_range", MIRROR | {"screen.z": -5.0}, "mirror.height_range"),
        ("screen", FAR, "lens.max_thickness"),
        ("entrance_range", {"lens.entrance": {"shape": "freeform"}}, "lens.entrance.height_range"),
    ],
)
@pytest.mark.parametrize("needed", [None, (0.1, 1.2)])
def test_a_limit_that_the_program_has_chosen_is_called_automatic(
    make_scene, cause, changes, field, needed
):
    scene = make_scene(changes | {"version": 2})
    said = Shortfall(cause, needed, (0.1, 1.0), 0.9).in_full(scene)
    assert "automatic" in said and f"set {field} to" in said
    assert "stock" not in said and "allowed" not in said


ASIDE = {
    "lens.height_range": None,
    "lens.control_points": [24, 24],
    "source": {"kind": "point", "position": [4, 0, -5]},
}


def test_an_automatic_thickness_is_as_large_as_the_first_lens_needs(make_scene):
    target = np.zeros((32, 32))
    target[8:24, 8:24] = 1.0
    room = Room(make_scene(ASIDE), target)
    half_way = (0.5 + 5.0) / 2
    assert room.limits["exit"].upper == pytest.approx(half_way)
    extent = np.ptp(room.first["exit"])
    assert extent > half_way - 0.05  # the nearer half before the screen is too thin
    assert room.limits["exit"].hold(room.limits["exit"].nearest(room.first["exit"]))
    assert room.limits["exit"].lacks(room.first["exit"]) <= 0
    assert half_way < room.limits["exit"].upper.max() < 4.5
    assert room.shortfall({"exit": room.first["exit"]}) is None
    stock = Room(make_scene(ASIDE | {"lens.max_thickness": half_way}), target)
    assert stock.first is not None and stock.shortfall(stock.begin).cause == "max_thickness"


def test_the_first_lens_of_an_automatic_thickness_is_that_of_the_scene_as_it_is(make_scene, corner):
    """A stock that reaches far to the screen would be taken for the place of the exit face."""
    scene = make_scene(FREE | {"screen.z": 500.0, "screen.half_width": [40.0, 40.0]})
    assert Room(scene, corner).first["exit"] == pytest.approx(
        first_lens(scene, corner).heights["exit"], abs=1e-12
    )


def test_a_screen_that_is_too_near_is_the_limit_where_nothing_is_given(make_scene):
    target = np.ones((32, 32))
    scene = make_scene(ASIDE | {"screen.z": 1.5})
    *_, last = run(scene.altered(run=scene.run.altered(iterations=2)), target)
    short = last.state.shortfall
    assert short.cause == "screen" and short.allowed[1] == pytest.approx(1.5 - 0.05 * (1.5 - 0.5))
    assert "stock" not in short.in_full(scene) and "move the screen away" in short.in_full(scene)


def test_a_run_goes_on_from_a_lens_beyond_half_of_the_way_to_the_screen(make_scene):
    heights = np.full((24, 24), 3.9)
    assert Room(make_scene(FREE), np.ones((32, 32)), {"exit": heights}).begin["exit"].max() == 3.9


def test_a_shortfall_is_converted_with_its_lens():
    short = Shortfall("height_range", (-2.0, 3.0), (-0.5, 0.5), 0.4).scaled(10.0)
    assert (short.needed, short.allowed) == ((-20.0, 30.0), (-5.0, 5.0))


ENTRANCE = {"lens.entrance": {"shape": "freeform", "height_range": [-0.1, 0.1]}}


def test_an_entrance_face_that_fills_its_range_is_reported(make_scene, corner):
    half = np.where(np.arange(24)[:, None] < 12, -0.09, 0.09) * np.ones((24, 24))
    room = Room(make_scene(FREE | ENTRANCE), corner)
    short = room.shortfall({"exit": np.full((24, 24), 0.5), "entrance": half})
    assert (short.cause, short.allowed) == ("entrance_range", (-0.1, 0.1))
    assert short.share == pytest.approx(0.9)
    assert short.sentence(make_scene(ENTRANCE)) == (
        "The entrance face fills 90 % of its range of ±0.1 cm, and would bend more of the light "
        "in a wider one"
    )
    assert short.cure_in(make_scene(ENTRANCE)) == "widen the entrance range"


def test_an_entrance_face_with_room_or_locked_or_of_automatic_range_is_no_shortfall(
    make_scene, corner
):
    exit_face = np.full((24, 24), 0.5)
    half = np.where(np.arange(24)[:, None] < 12, -0.1, 0.1) * np.ones((24, 24))
    for entrance in (0.8 * half, np.full((24, 24), -0.1)):
        room = Room(make_scene(FREE | ENTRANCE), corner)
        assert room.shortfall({"exit": exit_face, "entrance": entrance}) is None
    heights = {"exit": exit_face, "entrance": half}
    locked = {"entrance": np.ones((24, 24), dtype=bool)}
    assert Room(make_scene(FREE | ENTRANCE), corner, heights, locked).shortfall(heights) is None
    automatic = make_scene(FREE | {"lens.entrance": {"shape": "freeform"}})
    assert Room(automatic, corner).shortfall(heights) is None


def test_a_run_whose_entrance_range_is_too_narrow_says_so(make_scene, corner):
    narrow = {"lens.entrance": {"shape": "freeform", "height_range": [-0.01, 0.01]}}
    *_, last = run(make_scene(FREE | narrow | {"run.iterations": 8}), corner)
    assert last.state.shortfall.cause == "entrance_range"
    assert last.state.shortfall.allowed == (-0.01, 0.01)
    wide = {"lens.entrance": {"shape": "freeform", "height_range": [-0.1, 0.3]}}
    *_, last = run(make_scene(FREE | wide | {"run.iterations": 8}), np.ones((32, 32)))
    assert last.state.shortfall is None


def test_a_wider_entrance_range_has_room_before_the_source_and_below_the_exit_face(make_scene):
    assert wider_entrance(make_scene(FREE)) is None  # flat
    assert wider_entrance(make_scene(FREE | ENTRANCE)) == pytest.approx((-0.2, 0.2))
    near = {"source": {"kind": "point", "position": [0, 0, -0.16]}}
    assert wider_entrance(make_scene(FREE | ENTRANCE | near)) == pytest.approx((-0.15, 0.15))
    touching = {"source": {"kind": "point", "position": [0, 0, -0.105]}}
    assert wider_entrance(make_scene(FREE | ENTRANCE | touching)) is None


def test_the_exit_face_alone_begins_with_the_lens_that_both_faces_were_compared_with(
    make_scene, corner, monkeypatch
):
    room = Room(make_scene(FREE | {"lens.entrance": {"shape": "freeform"}}), corner)
    assert room.first is not None
    expected = Room(room.alone().scene, corner).first
    monkeypatch.setattr(room_module, "first_lens", None)
    assert room.alone().first["exit"] == pytest.approx(expected["exit"], abs=1e-12)
