from pathlib import Path

import pytest

from workbench.errors import Refused
from workbench.files.export.formats import ENDINGS, format_of
from workbench.files.export.options import Cutting, Turning
from workbench.files.export.write import export
from workbench.files.session import Session

pytestmark = pytest.mark.usefixtures("small_grids", "coarse_tables", "few_gouges")


COARSE = Cutting(scallop=0.01), Turning(feed_per_turn=0.05, points_per_turn=128)
TWO_FACES = {"version": 2, "lens.entrance": {"shape": "freeform", "control_points": [7, 9]}}


@pytest.fixture
def make_session(make_design):
    def make(changes=None):
        design = make_design(changes)
        return Session(design.scene, design.result.state.irradiance, design.result)

    return make


@pytest.fixture
def session(make_session):
    return make_session()


@pytest.mark.parametrize("ending", ENDINGS)
def test_every_ending_is_written(make_session, tmp_path, ending):
    session = make_session(TWO_FACES if "entrance" in ending else None)
    path = tmp_path / f"my.lens{ending.upper()}"
    (written,) = export(session, [path], chord_error=0.01, options=COARSE)
    assert written.path == path
    assert written.format == format_of(path).name
    assert path.stat().st_size > 1000
    size = written.deviation.size / (100 if written.deviation.unit == "%" else 1)
    assert 0 <= size < (0.2 if ending in (".ies", ".ldt") else 0.02)  # of coarse tables


@pytest.mark.parametrize(
    "name", ["lens", "lens.png", "lens.csv", "lens.freeform", "step", ".height"]
)
def test_unknown_endings(name):
    with pytest.raises(Refused, match=r"has no known ending; use one of \.step, \.stp,"):
        format_of(Path(name))


class TestNothingIsWritten:
    def refused(self, session, paths, chord_error=None):
        with pytest.raises(Refused) as caught:
            list(export(session, paths, chord_error))
        return str(caught.value)

    def test_over_a_file_that_is_there_if_the_format_cannot_hold_it(self, session, tmp_path):
        path = tmp_path / "lens.stl"
        path.write_bytes(b"old")
        assert "is finer than the numbers" in self.refused(session, [path], chord_error=1e-12)
        assert path.read_bytes() == b"old"
        assert list(tmp_path.iterdir()) == [path]
