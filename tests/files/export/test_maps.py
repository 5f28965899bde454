import csv
from functools import partial

import numpy as np
import pytest
from PIL import Image

from workbench.files.export.formats import format_of
from workbench.files.export.maps import height

pytestmark = pytest.mark.usefixtures("small_grids")


@pytest.fixture
def written(write, tmp_path):
    """Writes a map by the registry; its path and deviation."""

    def do(design, name):
        return write(format_of(tmp_path / name).load(), design, name)

    return do


class TestHeight:
    def test_rows_run_from_plus_y_down(self, make_design):
        x, y = make_design().net.positions
        shown = height(make_design(heights=0.5 + 0.1 * x[:, None] + 0.02 * y))
        assert shown.values == pytest.approx(0.5 + 0.1 * shown.x + 0.02 * shown.y[:, None])
        assert shown.values[0, 0] == pytest.approx(0.5 - 0.1 + 0.014)
        assert shown.x[[0, -1]] == pytest.approx([-1.0, 1.0])
        assert shown.y[[0, -1]] == pytest.approx([0.7, -0.7])

    def test_csv(self, make_design, written):
        design = make_design({"unit": "mm"})
        path, deviation = written(design, "lens.height.csv")
        with path.open(newline="") as file:
            head, *rows = csv.reader(file)
        assert head == ["x [mm]", "y [mm]", "height [mm]"]
        x, y, z = np.array(rows, dtype=float).T
        shown = height(design)
        assert x[: len(shown.x)] == pytest.approx(shown.x)
        assert y[: len(shown.x)] == pytest.approx(shown.y[0])
        assert np.abs(z - shown.values.ravel()).max() == deviation.size < 1e-14


class TestIrradiance:
    @pytest.mark.parametrize("ending", ["png", "npy", "csv", "tiff"])
    def test_every_kind_of_file_shows_the_same(self, make_design, written, ending):
        design = make_design()
        path, deviation = written(design, f"lens.irradiance.{ending}")
        read = {"npy": np.load, "csv": partial(np.loadtxt, delimiter=",", skiprows=1)}
        if ending in read:
            found = read[ending](path)
        else:
            with Image.open(path) as image:
                found = np.asarray(image, dtype=float)
                if ending == "png":
                    low, high = float(image.text["Black"]), float(image.text["White"])
                    found = low + found / 65535 * (high - low)
        found = found[:, 2].reshape(32, 32) if ending == "csv" else found
        error = np.abs(found - design.result.state.irradiance).max()
        assert error <= deviation.size * (1 + 1e-9)
        assert deviation.size < 1e-5
