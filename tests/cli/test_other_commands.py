import json
import math
import os
import signal

import pytest

from workbench.analysis.tracing import MOST_RAYS
from workbench.analysis.tracing.trace import Trace
from workbench.design.run import run
from workbench.design.snapshot import History
from workbench.files.session import Session, write_session
from workbench.scene import CustomIndex
from workbench.targets import load_target


@pytest.fixture
def lens(make_scene, tmp_path):
    """A session with the undesigned lens, which is flat."""
    scene = make_scene({"run.iterations": 0})
    target = load_target(scene, tmp_path)
    history = History()
    for snapshot in run(scene, target):
        history.add(snapshot)
    path = tmp_path / "lens.freeform"
    write_session(Session(scene, target, history.result()), path)
    return path


class TestValidate:
    def test_figures(self, freeform, lens):
        status, stdout, stderr = freeform("validate", lens, "--rays", 100_000, "--json")
        assert (status, stderr) == (0, "")
        figures = json.loads(stdout)
        assert sorted(figures) == [
            "contradiction",
            "contrast",
            "correlation",
            "deterministic",
            "deterministic_left_out",
            "efficiency",
            "ledger",
            "light_limits",
            "lit_area",
            "loss",
            "noise",
            "optimiser_difference",
            "optimiser_remark",
            "psnr",
            "rays",
            "relative_l2",
            "relative_l2_corrected",
            "relative_l2_corrected_interval",
            "relative_l2_interval",
            "shading",
            "ssim",
            "uniformity",
        ]
        assert 100_000 <= figures["rays"] < 110_000
        assert figures["efficiency"] == pytest.approx(0.96**2, rel=1e-6)
        assert figures["light_limits"][0]["most"] == pytest.approx(0.96**2, rel=1e-6)
        assert sum(figures["ledger"].values()) == pytest.approx(2.0, abs=1e-12)
        # A disc of 0.6 of the half-width that is lit a times too weakly, as if by a square.
        disc = math.pi * 0.36 / 4
        assert figures["relative_l2"] == pytest.approx(math.sqrt(1 - disc), rel=0.02)
        assert 0 < figures["noise"] < 0.01
        low, high = figures["relative_l2_corrected_interval"]
        assert low < figures["relative_l2_corrected"] < high
        assert abs(figures["correlation"]) < 0.05  # the image is even
        # The undesigned lens throws its own even square, in the optimiser's image too.
        assert 0 <= figures["optimiser_difference"] < 0.06
        exact = figures["deterministic"]
        assert sorted(exact) == [
            "cells",
            "difference",
            "difference_corrected",
            "difference_corrected_interval",
            "difference_over_noise",
            "efficiency",
            "error_bound",
            "error_bound_wanted",
            "independent_rays",
            "ledger",
            "loss",
            "noise",
            "optimiser_difference",
            "relative_l2",
            "relative_l2_interval",
        ]
        assert exact["relative_l2"] == pytest.approx(math.sqrt(1 - disc), rel=0.01)
        assert exact["efficiency"] == pytest.approx(0.96**2, rel=1e-12)
        assert sum(exact["ledger"].values()) == pytest.approx(2.0, abs=1e-12)
        assert exact["error_bound"] < 1e-12
        assert exact["difference_over_noise"] == pytest.approx(1, abs=0.1)
        assert exact["optimiser_difference"] < 0.06

    def test_ctrl_c_ends_a_check_that_would_take_an_hour(self, freeform, lens, monkeypatch):
        def press(progress, part):
            os.kill(os.getpid(), signal.SIGINT)

        monkeypatch.setattr("workbench.cli.output.PartProgress.show", press)
        status, stdout, stderr = freeform("validate", lens, "--rays", MOST_RAYS)
        assert (status, stdout, stderr) == (130, "", "freeform: interrupted\n")

    def test_two_traces_that_contradict_each_other(self, freeform, lens, monkeypatch):
        """The figures are printed, and the check fails: random rays meet another glass."""

        def in_denser_glass(scene, *others):
            denser = scene.optic.model_copy(update={"material": CustomIndex(index=1.7)})
            return Trace(scene.with_optic(denser), *others)

        monkeypatch.setattr("workbench.analysis.validation.Trace", in_denser_glass)
        status, stdout, stderr = freeform("validate", lens, "--rays", 100_000, "--json")
        assert status == 1
        stated = json.loads(stdout)["contradiction"]
        assert stated.startswith(
            "the check contradicts itself: 92.16 % of the light on the receiver"
        )
        assert stderr.splitlines()[-1] == f"freeform: {stated}"

    @pytest.mark.full
    def test_with_mitsuba(self, freeform, lens, monkeypatch):
        pytest.importorskip("mitsuba")
        monkeypatch.setattr("workbench.analysis.mitsuba_elements._CELLS", 96)
        given = "validate", lens, "--rays", 50_000, "--with", "mitsuba"
        status, stdout, stderr = freeform(*given, "--json")
        assert (status, stderr) == (0, "")
        found = json.loads(stdout)["cross_check"]
        assert found["difference"] == pytest.approx(found["noise"], rel=0.2)
        assert found["mitsuba"]["efficiency"] == pytest.approx(0.96**2, rel=0.01)
        status, stdout, _ = freeform(*given, "--screen-z", 6.0)
        assert status == 0
        assert "\nMitsuba 3, with " in stdout


def test_pictures(freeform, lens, tmp_path):
    folder = tmp_path / "new" / "folder"
    status, stdout, stderr = freeform("pictures", lens, folder)
    assert (status, stdout, stderr) == (0, "", "")
    for name in ("irradiance.png", "lens.png"):
        assert (folder / name).read_bytes().startswith(b"\x89PNG")
