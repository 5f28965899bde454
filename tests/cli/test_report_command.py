import contextlib
import io
import json
import logging
import math
import os
import re
import shutil
import textwrap
from datetime import datetime
from html.parser import HTMLParser
from pathlib import Path

import numpy as np
import pytest

from tests.accounts import result_of
from tests.scenes import changed
from workbench.cli import main
from workbench.design.session import VerifiedError
from workbench.files.session import KeptRun, Session, write_session
from workbench.scene import Scene
from workbench.targets import load_target

DAY = datetime(2001, 2, 3, 4, 5, 6)
RAYS = ("--rays", 20_000)
OFF = ("--tolerances", 3, "--tilt", 1, "--surface", 0.001, 0.3)


@pytest.fixture(scope="module")
def white():
    return np.full((100, 160, 3), 255, dtype=np.uint8)


@pytest.fixture
def no_3d(monkeypatch, white):
    monkeypatch.setattr("workbench.pictures.report.lens_image", lambda *_, **__: white)


@pytest.fixture(scope="module")
def wavy(tmp_path_factory):
    """A session with a wavy lens that no run has made."""
    folder = tmp_path_factory.mktemp("wavy")
    scene = Scene.from_data(changed({}))
    target = load_target(scene, folder)
    waves = 0.5 + 0.01 * np.sin(np.arange(120.0)).reshape(12, 10)
    result = result_of(waves, losses=[0.3, 0.2, 0.1])
    checked = VerifiedError(0.0625, (0.06, 0.065))
    kept = KeptRun("first <try>", scene, target, result, checked)
    path = folder / "a <b> & 'c'.freeform"
    write_session(Session(scene, target, result, runs=(kept,)), path)
    os.utime(path, (DAY.timestamp(), DAY.timestamp()))
    return path


@pytest.fixture
def lens(wavy, tmp_path):
    """The same, for a test of its own."""
    return Path(shutil.copy2(wavy, tmp_path))


@pytest.fixture(scope="module")
def reports(wavy, white):
    """The folder of both reports of that lens, ``out.html`` and ``out.pdf``."""
    stated = io.StringIO()
    files = wavy.with_name("out.html"), wavy.with_name("out.pdf")
    arguments = [str(argument) for argument in ("report", wavy, *files, *RAYS, *OFF)]
    with (
        pytest.MonkeyPatch.context() as patch,
        contextlib.redirect_stdout(stated),
        contextlib.redirect_stderr(stated),
    ):
        patch.setattr("workbench.pictures.report.lens_image", lambda *_, **__: white)
        patch.setattr("workbench.analysis.cells.image._BEGIN", 1 << 18)  # as by `fewer_rays`
        patch.setattr("workbench.cli.output._LINES", math.inf)
        patch.setattr(logging.getLogger("workbench.compiled"), "disabled", True)
        status = main(arguments)
    assert (status, stated.getvalue()) == (0, "")
    return wavy.parent


class Page(HTMLParser):
    """Names and values, pictures, and all tags, which must close as they open."""

    VOID = ("meta", "img")

    def __init__(self, text):
        super().__init__()
        self.open, self.seen, self.rows, self.headings, self.images = [], set(), {}, [], []
        self.feed(text)
        self.close()
        assert self.open == []

    def handle_starttag(self, tag, attributes):
        self.seen.add(tag)
        if tag == "img":
            self.images.append(dict(attributes))
        if tag not in self.VOID:
            self.open.append(tag)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, text):
        if self.open[-1:] == ["dt"]:
            self._name = text
        if self.open[-1:] == ["dd"]:
            self.rows[self._name] = text
        if self.open[-1:] in (["h1"], ["h2"]):
            self.headings.append(text)


def number(text):
    head, *unit = text.split()
    return float(head.rstrip("°")) / (100 if unit[:1] == ["%"] else 1)


@pytest.mark.usefixtures("no_3d")
class TestHtml:
    @pytest.fixture
    def page(self, reports):
        return (reports / "out.html").read_text()

    def test_it_begins_with_light_result_and_drawing(self, page, wavy):
        found = Page(page)
        assert found.headings[:4] == [wavy.stem, "Light on the screen", "Result", "Drawing"]
        assert [image["alt"] for image in found.images][:2] == [
            "Light and target",
            "Front view and sections",
        ]

    def test_fields_have_the_words_of_forms(self, page):
        found = Page(page)
        fields = {name: value for name, value in found.rows.items() if name[0].isupper()}
        assert fields["Back face · Height range"] == "-0.3 to 0.3 cm"
        assert not [text for text in (*fields, *fields.values()) if re.search(r"\w_\w|\]\.", text)]

    @pytest.mark.full
    def test_mitsuba_stands_beside_the_check(self, freeform, lens, tmp_path, monkeypatch):
        pytest.importorskip("mitsuba")
        monkeypatch.setattr("workbench.analysis.mitsuba_elements._CELLS", 96)
        file = tmp_path / "beside.html"
        assert freeform("report", lens, file, *RAYS, "--with", "mitsuba") == (0, "", "")
        found = Page(file.read_text())
        assert "Beside Mitsuba 3" in found.headings
        noise = number(found.rows["by ray noise alone"])
        assert number(found.rows["difference of both images"]) == pytest.approx(noise, rel=0.2)
        ours, theirs = (number(each) for each in found.rows["efficiency, both"].split(" / "))
        assert theirs == pytest.approx(ours, rel=0.02)
        assert "Images of both tracers" in [image["alt"] for image in found.images]

    @pytest.mark.usefixtures("fewer_rays")
    def test_figures_are_those_of_the_check(self, freeform, page, lens):
        found = Page(page).rows
        check = json.loads(freeform("validate", lens, *RAYS, "--json")[1])
        for name, key in (
            ("error with ray noise", "relative_l2"),
            ("error by random rays", "relative_l2_corrected"),
            ("loss of the paper", "loss"),
            ("PSNR", "psnr"),
            ("SSIM", "ssim"),
            ("correlation", "correlation"),
            ("uniformity", "uniformity"),
            ("contrast", "contrast"),
            ("efficiency", "efficiency"),
            ("difference to the optimiser", "optimiser_difference"),
        ):
            assert number(found[name]) == pytest.approx(check[key], rel=1e-3, abs=1e-5), name
        exact = check["deterministic"]
        assert number(found["verified error"]) == pytest.approx(exact["relative_l2"], abs=1e-5)
        assert found["beam mesh"] == " × ".join(map(str, exact["cells"]))
        times = f"{exact['difference_over_noise']:.2f} times their noise"
        assert found["difference of random rays"].endswith(f" %, {times}")
        low, high = check["relative_l2_interval"]
        assert found["error with ray noise"].endswith(f"({100 * low:.3f} % to {100 * high:.3f} %)")
        assert found["rays"].replace(",", "") == str(check["rays"])
        light = exact["ledger"]
        for name, key in (
            ("on the screen", "on_screen"),
            ("missed the screen", "off_screen"),
            ("reflected on entry", "fresnel_entrance"),
            ("reflected on exit", "fresnel_exit"),
            ("totally reflected", "total_reflection"),
        ):
            assert number(found[name]) == pytest.approx(light[key], abs=1e-5), name
        assert found["Position"] == "0, 0, 5 cm"
        assert found["limit of the thickness"] == "at least 0.05 cm: met"
        assert number(found["thinnest"]) > 0.05
        assert (found["tilt up to"], found["lenses"]) == ("1°", "3")
        assert number(found["worst"]) >= number(found["mean"]) > 0


class TestPdf:
    def test_pdf_opens_and_has_all_text(self, reports, wavy):
        pypdf = pytest.importorskip("pypdf")
        reader = pypdf.PdfReader(reports / "out.pdf")
        assert reader.metadata.title == wavy.stem
        text = " ".join(" ".join(page.extract_text() for page in reader.pages).split())
        page = Page((reports / "out.html").read_text())
        for heading in page.headings:
            assert heading in text
        for name, value in page.rows.items():
            assert all(line in text for line in textwrap.wrap(name, 28))  # letters of a column
            assert value.split()[0] in text
        assert all(round(side.width) == 595 for side in (p.mediabox for p in reader.pages))


@pytest.mark.usefixtures("no_3d")
def test_a_report_that_fails_leaves_the_old_one(freeform, lens, tmp_path, monkeypatch):
    old = tmp_path / "out.html"
    old.write_text("old")

    def full(*_):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("workbench.report.write.to_png", full)
    status, _, stderr = freeform("report", lens, old, *RAYS)
    assert status == 2
    assert "No space left on device" in stderr
    assert old.read_text() == "old"
    assert [path.name for path in tmp_path.glob("*.tmp")] == []
