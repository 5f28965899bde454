"""``freeform inspect``: figures, plot, corrected session, and refusals in one sentence."""

import json

import numpy as np
import pytest

from tests.accounts import result_of
from tests.analysis.lenses import net_of
from workbench.files.session import Session, read_session, write_session
from workbench.geometry.surface import ControlNet

pytestmark = pytest.mark.usefixtures("upright_parts")

FORM = 2e-4  # cm


def relief(x, y):
    return 0.5 + 0.03 * x**2 + 0.02 * np.sin(3 * x + y) * np.cos(2 * y)


@pytest.fixture
def designed(make_scene, tmp_path):
    scene = make_scene()
    path = tmp_path / "designed.freeform"
    image = np.ones((32, 32))
    write_session(Session(scene, image, result_of(net_of(scene, relief), image)), path)
    return path


@pytest.fixture
def part(designed, tmp_path):
    """A measurement in mm of a part with astigmatism."""
    session = read_session(designed)
    net = ControlNet.of(session.scene.optic)
    middles = 2 * (np.arange(40) + 0.5) / 40 - 1
    x, y = (each.ravel() for each in np.meshgrid(middles, middles))
    z = net.at(x, y, session.heights["lens.back"])[0] + FORM * x * y
    path = tmp_path / "part.csv"
    np.savetxt(path, 10 * np.column_stack([x, y, z]), delimiter=",", header="x [mm],y [mm],z [mm]")
    return path


def test_figures_and_corrected_session(freeform, designed, part, tmp_path):
    out, plot = tmp_path / "corrected.freeform", tmp_path / "part.png"
    arguments = ("--rays", "200000", "--json", "-o", out, "--plot", plot)
    status, stdout, stderr = freeform("inspect", designed, part, part, *arguments)
    assert (status, stderr) == (0, "")
    found = json.loads(stdout)
    first, second = found["parts"]
    # The mean square of x y over the square is 1/9.
    assert first["rms_um"] == pytest.approx(2 / 3, rel=0.2)
    assert (first["points"], first["missing"], first["covered"]) == (1600, 0, 1)
    assert first["rms_um"] == second["rms_um"] and found["spread_um"] == pytest.approx(0)
    assert 0 < found["relative_l2"] < 1 and 0 < first["relative_l2"] < 1
    assert 0 < found["corrected_relative_l2"] < 1
    assert plot.read_bytes().startswith(b"\x89PNG")
    heights = [read_session(path).heights["lens.back"] for path in (designed, out)]
    x, y = ControlNet.of(read_session(designed).scene.optic).positions
    expected = FORM * x[:, None] * y  # x and y of control points are those of the face
    assert np.corrcoef((heights[0] - heights[1]).ravel(), expected.ravel())[0, 1] > 0.95
    status, stdout, _ = freeform("validate", out, "--rays", "200000", "--json")
    assert status == 0
    checked = json.loads(stdout)["deterministic"]["relative_l2"]
    assert checked == pytest.approx(found["corrected_relative_l2"], rel=0.05)


def test_text(freeform, designed, part):
    status, stdout, stderr = freeform("inspect", designed, part, "--rays", "200000", "--scale")
    assert (status, stderr) == (0, "")
    for words in (
        "1600 on 100.0 % of lens.back",
        "µm rms",
        "mrad rms",
        "turned by",
        "\nscale  ",
        "as designed",
        "as measured",
    ):
        assert words in stdout


def test_a_part_of_a_corrected_lens(freeform, designed, part, tmp_path):
    first, second = tmp_path / "first.freeform", tmp_path / "second.freeform"
    for arguments in ((part, "-o", first), (part, "--made-from", first, "-o", second)):
        status, _, stderr = freeform("inspect", designed, *arguments, "--rays", "200000")
        assert (status, stderr) == (0, "")
    one, two, three = (
        read_session(path).heights["lens.back"] for path in (designed, first, second)
    )
    np.testing.assert_allclose(one - two, two - three, rtol=0, atol=1e-12)


@pytest.mark.parametrize(
    ("arguments", "reason"),
    [
        (("--unit", "m"), "the unit mm fits"),
        (("--unit", "cm", "--z-unit", "mm"), "fit"),
        (("--face", "lens.front"), "lens.front' is no freeform face; lens.back"),
    ],
)
def test_refusals(freeform, designed, part, arguments, reason):
    status, stdout, stderr = freeform("inspect", designed, part, *arguments)
    assert (status, stdout) == (2, "")
    assert reason in stderr and stderr.count("\n") == 1


def test_bad_files(freeform, designed, tmp_path):
    for name, content, reason in (
        ("part.xyz", "1 2 nan\n" * 200, "0 points with a height"),
        ("part.doc", "", "is no measured surface"),
        ("part.stl", "solid", "0 triangles"),
    ):
        path = tmp_path / name
        path.write_text(content)
        status, _, stderr = freeform("inspect", designed, path)
        assert status == 2 and reason in stderr and stderr.count("\n") == 1
