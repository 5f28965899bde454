"""``freeform robust``."""

import json

import pytest

from workbench.files.session import read_session


@pytest.fixture
def scene_file(tmp_path, make_scene):
    def write(**uncertainty):
        path = tmp_path / "hat.json"
        small = make_scene({"lens.control_points": [24, 24], "screen.pixels": [32, 32]})
        path.write_text(json.dumps(small.to_data() | {"uncertainty": uncertainty}))
        return path

    return write


@pytest.mark.full
def test_each_design_is_judged_over_the_whole_uncertainty(freeform, scene_file, tmp_path):
    plot, folder = tmp_path / "compromise.png", tmp_path / "designs"
    arguments = ("--shares", "0", "1", "--iterations", "1", "--plot", plot, "-o", folder, "--json")
    status, stdout, _ = freeform("robust", scene_file(distance=1), *arguments)
    assert status == 0
    nominal, robust = json.loads(stdout)["designs"]
    assert (nominal["share"], robust["share"]) == (0, 1)
    assert nominal["cases"] == robust["cases"] == 3
    assert robust["mean"] < nominal["mean"]
    assert plot.read_bytes().startswith(b"\x89PNG")
    scene = read_session(folder / "hat-100.freeform").scene
    assert scene.uncertainty.distance == 1


def test_a_scene_without_uncertainty_is_refused(freeform, scene_file):
    status, stdout, stderr = freeform("robust", scene_file())
    assert (status, stdout) == (2, "")
    assert stderr.startswith("freeform: uncertainty: nothing is uncertain; ")
