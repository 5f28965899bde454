from pathlib import Path

import pytest

from workbench.errors import Refused
from workbench.files.export.formats import ENDINGS, format_of
from workbench.files.export.write import export
from workbench.files.session import Session

pytestmark = pytest.mark.usefixtures("small_grids")


@pytest.fixture
def session(make_design):
    design = make_design()
    return Session(design.scene, design.result.state.irradiance, design.result)


@pytest.mark.parametrize("ending", ENDINGS)
def test_every_ending_is_written(session, tmp_path, ending):
    path = tmp_path / f"my.lens{ending.upper()}"
    (written,) = export(session, [path], chord_error=0.01)
    assert written.path == path
    assert written.format == format_of(path).name
    assert path.stat().st_size > 1000
    assert 0 <= written.deviation.size < 0.01


@pytest.mark.parametrize(
    "name", ["lens", "lens.png", "lens.csv", "lens.freeform", "step", ".height"]
)
def test_unknown_endings(name):
    with pytest.raises(Refused, match=r"has no ending that tells a format; one of \.step, \.stp,"):
        format_of(Path(name))


class TestNothingIsWritten:
    def refused(self, session, paths, chord_error=None):
        with pytest.raises(Refused) as caught:
            list(export(session, paths, chord_error))
        return str(caught.value)

    def test_if_one_ending_is_unknown(self, session, tmp_path):
        told = self.refused(session, [tmp_path / "lens.step", tmp_path / "lens.dwg"])
        assert "lens.dwg: has no ending" in told
        assert list(tmp_path.iterdir()) == []

    def test_if_one_folder_is_missing(self, session, tmp_path):
        told = self.refused(session, [tmp_path / "lens.step", tmp_path / "missing" / "lens.stl"])
        assert told.endswith("cannot be written: its folder does not exist")
        assert list(tmp_path.iterdir()) == []

    def test_without_a_lens(self, session, tmp_path):
        task = Session(session.scene, session.target)
        assert "holds no lens yet" in self.refused(task, [tmp_path / "lens.step"])

    def test_over_a_file_that_is_there_if_the_format_cannot_hold_it(self, session, tmp_path):
        path = tmp_path / "lens.stl"
        path.write_bytes(b"old")
        assert "is finer than the numbers" in self.refused(session, [path], chord_error=1e-12)
        assert path.read_bytes() == b"old"
        assert list(tmp_path.iterdir()) == [path]
