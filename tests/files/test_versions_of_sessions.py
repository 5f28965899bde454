"""Sessions of version 2, written as version 3, and heights in coordinates of the element."""

import io
import json
import zipfile
from dataclasses import replace

import numpy as np
import pytest

from tests.accounts import account_of
from tests.scenes import changed
from workbench.design.lens_state import FurtherLight, LensState
from workbench.design.session import KeptRun, Session
from workbench.design.snapshot import Result
from workbench.files.figures import Figures
from workbench.files.session import read_session, write_session
from workbench.geometry.faces import FaceArrays
from workbench.scene import DrawnTarget, Scene

PLACE = 1.75  # z of the front face
NETS = {"lens.back": (5, 4), "lens.front": (4, 6)}
OLD = changed(
    {
        "version": 2,
        "lens.entrance_z": PLACE,
        "lens.base": {"shape": "flat", "height": 2.25},
        "lens.control_points": list(NETS["lens.back"]),
        "lens.entrance": {"shape": "freeform", "control_points": list(NETS["lens.front"])},
        "screen.pixels": [7, 6],
        "further_images": [
            {
                "screen": {"z": 9.0, "half_width": [2.0, 2.0], "pixels": [3, 2]},
                "target": {"builtin": "ball"},
                "weight": 2.0,
            }
        ],
    }
)


@pytest.fixture
def session(rng):
    """Both faces with results, locks, a further image and a kept run of each."""
    scene = Scene.from_data(OLD)
    drawn = scene.images[1].drawn_as(DrawnTarget(rng.random((2, 3))))
    scene = scene.with_images([scene.images[0], drawn])
    account = account_of(1.0, 0.7, 0.1, 0.0, 0.0, 0.06, 0.04, 0.1)

    def result():
        heights = {
            face: z + rng.random(NETS[face]) for face, z in (("lens.back", 2), ("lens.front", 1.5))
        }
        light = FurtherLight(rng.random((2, 3)), 0.5, account)
        state = LensState(FaceArrays(heights), rng.random((6, 7)), 0.25, account, further=(light,))
        return Result(state, losses=rng.random(3), seconds=2.0)

    locked = FaceArrays({face: rng.random(net) < 0.5 for face, net in NETS.items()})
    run = KeptRun("earlier", scene, rng.random((6, 7)), result())
    return Session(scene, rng.random((6, 7)), result(), locked, (run,))


def old_entries(design):
    """Arrays of a design as programs of version 2 named them."""
    state = design.result.state
    return {
        "target.npy": design.target,
        "further_target_1.npy": design.scene.images[1].wanted,
        "control_points.npy": state.heights["lens.back"],
        "entrance_points.npy": state.heights["lens.front"],
        "irradiance.npy": state.irradiance,
        "further_irradiance_1.npy": state.further[0].irradiance,
        "loss.npy": design.result.losses,
    }


def write_version_2(session, path):
    (run,) = session.runs
    header = {
        "format": "freeform-session",
        "version": 2,
        "scene": OLD,
        "result": Figures.of(session.result).model_dump(mode="json", exclude_none=True),
        "program": "freeform-lens-workbench 0.1.0",
    }
    kept = Figures.of(run.result).model_dump(mode="json", exclude_none=True)
    header["runs"] = [{"name": run.name, "scene": OLD, "result": kept}]
    arrays = old_entries(session) | {
        "locked.npy": session.locked["lens.back"],
        "entrance_locked.npy": session.locked["lens.front"],
    }
    arrays |= {f"runs/0/{name}": array for name, array in old_entries(run).items()}
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("session.json", json.dumps(header))
        for name, array in arrays.items():
            file = io.BytesIO()
            np.save(file, array)
            archive.writestr(name, file.getvalue())


def assert_same(found, expected):
    assert found.scene == expected.scene
    np.testing.assert_array_equal(found.target, expected.target)
    np.testing.assert_array_equal(found.result.losses, expected.result.losses)
    assert Figures.of(found.result) == Figures.of(expected.result)
    one, other = found.result.state, expected.result.state
    np.testing.assert_array_equal(one.irradiance, other.irradiance)
    np.testing.assert_array_equal(one.further[0].irradiance, other.further[0].irradiance)
    assert one.heights == other.heights


def test_a_session_of_version_2_is_the_same_when_written_as_version_3(session, tmp_path):
    old, new = tmp_path / "old.freeform", tmp_path / "new.freeform"
    write_version_2(session, old)
    before = read_session(old)
    assert_same(before, session)
    assert_same(before.runs[0], session.runs[0])
    assert before.locked == session.locked

    write_session(before, new)

    after = read_session(new)
    assert_same(after, before)
    assert_same(after.runs[0], before.runs[0])
    assert (after.runs[0].name, after.locked) == ("earlier", before.locked)


def arrays_of(path):
    with zipfile.ZipFile(path) as archive:
        names = [name for name in archive.namelist() if name.startswith("faces/")]
        return {name: np.load(io.BytesIO(archive.read(name))) for name in names}


def test_heights_of_a_file_are_counted_from_the_front_vertex(session, tmp_path):
    path, heights = tmp_path / "lens.freeform", session.result.state.heights
    write_session(session, path)
    arrays = arrays_of(path)
    np.testing.assert_array_equal(arrays["faces/lens.front.npy"], heights["lens.front"] - PLACE)
    np.testing.assert_array_equal(arrays["faces/lens.back.npy"], heights["lens.back"] - PLACE)
    write_session(replace(session, result=None, start=heights), path)
    start = arrays_of(path)["faces/lens.back.start.npy"]
    np.testing.assert_array_equal(start, heights["lens.back"] - PLACE)
    assert read_session(path).start == heights
