import errno
import json
from dataclasses import replace

import numpy as np
import pytest
from PIL import Image

from workbench.errors import RunFailed
from workbench.files.session import read_session, write_session
from workbench.geometry.faces import FaceArrays


def fail(error):
    def event():
        raise error

    return event


class TestDone:
    def test_a_video_has_an_image_of_each_iteration(self, freeform, scene_file, out, tmp_path):
        path = tmp_path / "run.webp"
        status, _, _ = freeform("design", scene_file, "-o", out, "--video", path)
        assert status == 0
        with Image.open(path) as found:
            assert found.n_frames == 11
        status, _, reason = freeform("design", scene_file, "-o", out, "--video", "run.mp4")
        assert status == 2 and "run.mp4: has no known ending; use one of .gif" in reason

    def test_the_lens_is_written_and_its_figures_are_printed(self, freeform, scene_file, out):
        status, stdout, progress = freeform("design", scene_file, "-o", out, "--json")
        assert status == 0
        figures = json.loads(stdout.splitlines()[-1])
        assert sorted(figures) == [
            "efficiency",
            "ended",
            "ending",
            "iterations",
            "ledger",
            "loss",
            "seconds",
            "shortfall",
        ]
        assert figures["shortfall"] is None
        assert figures["ending"] == {"words": "all iterations are done", "values": {}}
        result = read_session(out).result
        assert figures["ended"] == result.ended == "all iterations are done"
        assert figures["loss"] == result.state.loss
        assert figures["iterations"] == result.iterations == 10
        assert figures["seconds"] == result.seconds
        assert figures["efficiency"] == result.state.account.efficiency
        assert figures["ledger"] == result.state.account.to_data()
        assert result.state.loss < result.losses[0]
        assert progress.splitlines()[0].startswith("0/10  loss ")
        assert (
            progress.count("collimated light: entrance refraction and intersection left out") == 1
        )
        assert progress.splitlines()[-1].startswith("10/10  loss ")

    def test_fields_are_set_in_place_of_those_of_the_scene(self, freeform, scene_file, out):
        given = "--set", "run.iterations=3", "--set", "images[0].receiver.pixels=24x16"
        assert freeform("design", scene_file, "-o", out, *given)[0] == 0
        session = read_session(out)
        assert session.result.iterations == 3 and session.target.shape == (16, 24)
        # A session is read, changed and continued in the same way.
        again = out.with_name("again.freeform")
        given = "--set", "images[0].target.builtin=ring"
        assert freeform("design", out, "-o", again, *given)[0] == 0
        assert read_session(again).scene.target.called == "Ring"

    @pytest.mark.parametrize(
        ("given", "why"),
        [
            ("images[0].target.radius", "field=value is needed"),
            ("images[0].target.radius=2", "radius"),
            ("run.seed=1..3", "one value is needed"),
        ],
    )
    def test_a_field_that_cannot_be_set_is_refused(self, freeform, scene_file, out, given, why):
        status, _, error = freeform("design", scene_file, "-o", out, "--set", given)
        assert status == 2 and why in error and not out.exists()

    def test_a_too_small_height_range_is_reported_in_a_line_and_in_the_figures(
        self, freeform, scene_file, scene_data, out
    ):
        scene_data["lens"]["height_range"] = [-0.01, 0.01]
        scene_file.write_text(json.dumps(scene_data))
        status, stdout, progress = freeform("design", scene_file, "-o", out, "--json")
        assert status == 0
        assert "; ±0.01 cm is allowed: widen the height range" in progress.splitlines()[-1]
        shortfall = json.loads(stdout.splitlines()[-1])["shortfall"]
        assert shortfall["cause"] == "height_range" and shortfall["allowed"] == [-0.01, 0.01]
        assert shortfall["needed"][1] > 0.05 and shortfall["share"] > 0.02
        kept = read_session(out).result.state.shortfall
        assert (kept.cause, kept.share) == ("height_range", shortfall["share"])

    def test_locked_control_points_of_a_session_stay(self, freeform, scene_file, out):
        assert freeform("design", scene_file, "-o", out)[0] == 0
        first = read_session(out)
        locked = np.zeros(first.result.state.heights["lens.back"].shape, bool)
        locked[:6] = True
        write_session(replace(first, locked=FaceArrays({"lens.back": locked})), out)
        assert freeform("design", out, "-o", out, "--iterations", "2")[0] == 0
        again = read_session(out)
        np.testing.assert_array_equal(again.locked["lens.back"], locked)
        moved = again.result.state.heights["lens.back"] != first.result.state.heights["lens.back"]
        assert not moved[locked].any()
        assert moved[~locked].any()

    def test_a_session_is_continued(self, freeform, scene_file, out):
        freeform("design", scene_file, "-o", out)
        first = read_session(out).result
        status, stdout, _ = freeform("design", out, "-o", out, "--iterations", 5, "--json")
        assert status == 0
        second = read_session(out).result
        assert json.loads(stdout)["iterations"] == second.iterations == 15
        assert np.array_equal(second.losses[:10], first.losses)
        assert second.state.loss <= first.state.loss * 1.01
        assert second.seconds > first.seconds

    def test_the_time_limit_ends_a_run_well(self, freeform, scene_file, out, fake_run, monkeypatch):
        seconds = []
        monkeypatch.setattr("time.perf_counter", lambda: float(len(seconds)))
        fake_run({iteration: lambda: seconds.append(1) for iteration in range(1, 11)})
        status, _, progress = freeform("design", scene_file, "-o", out, "--seconds", 3.5)
        assert status == 0
        assert read_session(out).result.iterations == 4
        assert "00:03 left" in progress.splitlines()[0]


class TestFailed:
    def test_a_run_that_cannot_go_on_leaves_its_best_lens(
        self, freeform, scene_file, out, fake_run
    ):
        fake_run({6: fail(RunFailed("stopped at iteration 6: no light"))})
        status, stdout, stderr = freeform("design", scene_file, "-o", out)
        assert status == 1
        assert stdout == ""
        assert stderr.splitlines()[-1] == "freeform: stopped at iteration 6: no light"
        assert read_session(out).result.iterations == 5

    @pytest.mark.parametrize(
        "error", [KeyError("a\nmistake"), MemoryError(), BrokenPipeError(errno.EPIPE, "Broken")]
    )
    def test_a_defect_is_one_line_and_loses_nothing(
        self, freeform, scene_file, out, fake_run, error
    ):
        fake_run({6: fail(error)})
        status, _, stderr = freeform("design", scene_file, "-o", out)
        assert status == 1
        assert stderr.splitlines()[-2].startswith("5/10")
        assert stderr.splitlines()[-1].startswith("freeform: ")
        assert read_session(out).result.iterations == 5
