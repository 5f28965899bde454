import errno
import json
import zipfile
from dataclasses import replace

import numpy as np
import pytest
import torch

from workbench.errors import RunFailed
from workbench.files.session import read_session, write_session
from workbench.geometry.faces import FaceArrays


def fail(error):
    def event():
        raise error

    return event


class TestDone:
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

    def test_the_net_that_was_chosen_is_printed_once(self, freeform, scene_file, out):
        data = json.loads(scene_file.read_text())
        data["lens"]["control_points"] = "auto"
        scene_file.write_text(json.dumps(data))
        status, _, progress = freeform("design", scene_file, "-o", out, "--iterations", "1")
        n_u, n_v = read_session(out).scene.optic.net_shape
        assert status == 0
        assert progress.count(f"control points: {n_u} × {n_v}, chosen for this task") == 1

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

    def test_a_scene_without_a_range_stays_without_one(self, freeform, scene_file, scene_data, out):
        del scene_data["lens"]["height_range"]
        scene_file.write_text(json.dumps(scene_data))
        status, _, progress = freeform("design", scene_file, "-o", out)
        assert status == 0 and "of the base" in progress
        with zipfile.ZipFile(out) as session:
            assert "height_range" not in json.loads(session.read("session.json"))["scene"]["lens"]
        assert freeform("design", out, "-o", out)[0] == 0  # it goes on from its lens
        assert read_session(out).scene.optic.height_range is None

    def test_an_svg_can_be_the_target_and_goes_along(self, freeform, scene_file, scene_data, out):
        drawing = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9"><circle r="4"/></svg>'
        (scene_file.parent / "logo.svg").write_text(drawing)
        data = scene_data | {"target": {"image": "logo.svg"}}
        scene_file.write_text(json.dumps(data))
        status, _, progress = freeform("design", scene_file, "-o", out)
        assert status == 0 and "logo.svg" not in progress
        session = read_session(out)
        assert session.picture == drawing.encode()
        assert session.target[0, 0] == pytest.approx(1) and session.target[-1, -1] == 0

    def test_an_image_too_large_to_keep_is_reported(
        self, freeform, scene_file, scene_data, out, monkeypatch
    ):
        monkeypatch.setattr("workbench.design.picture.LARGEST_PICTURE", 100)
        np.save(scene_file.parent / "large.npy", np.eye(8))
        scene_file.write_text(json.dumps(scene_data | {"target": {"image": "large.npy"}}))
        status, _, progress = freeform("design", scene_file, "-o", out)
        assert status == 0 and read_session(out).picture is None
        assert "does not keep" in progress and "large.npy" in progress

    def test_without_json_a_line_for_people(self, freeform, scene_file, out):
        status, stdout, _ = freeform("design", scene_file, "-o", out)
        assert status == 0
        assert stdout.count("\n") == 1
        assert "after 10 iterations" in stdout
        assert stdout.endswith("on the screen; all iterations are done\n")

    def test_locked_control_points_of_a_session_stay(self, freeform, scene_file, out):
        assert freeform("design", scene_file, "-o", out)[0] == 0
        first = read_session(out)
        locked = np.zeros(first.result.state.heights["exit"].shape, bool)
        locked[:6] = True
        write_session(replace(first, locked=FaceArrays({"exit": locked})), out)
        assert freeform("design", out, "-o", out, "--iterations", "2")[0] == 0
        again = read_session(out)
        np.testing.assert_array_equal(again.locked["exit"], locked)
        moved = again.result.state.heights["exit"] != first.result.state.heights["exit"]
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

    def test_a_lens_of_another_task_is_a_start(self, freeform, scene_file, out):
        freeform("design", scene_file, "-o", out)
        designed = read_session(out)
        heights = designed.result.state.heights["exit"]
        screen = designed.scene.receiver.moved_to(designed.scene.receiver.z + 0.5)
        moved = designed.with_scene(designed.scene.with_receiver(screen), designed.target)
        write_session(moved, out)
        assert freeform("design", out, "-o", out, "--iterations", 0)[0] == 0
        found = read_session(out)
        assert found.result.iterations == 0 and found.start is None
        np.testing.assert_allclose(found.result.state.heights["exit"], heights, atol=1e-3)

    def test_a_session_without_a_lens_is_designed_from_the_start(
        self, freeform, scene_file, out, fake_run
    ):
        fake_run({})
        freeform("design", scene_file, "-o", out)
        assert read_session(out).result.iterations == 10

    def test_no_iterations_give_the_undesigned_lens(self, freeform, scene_file, out):
        status, _, _ = freeform("design", scene_file, "-o", out, "--iterations", 0)
        assert status == 0
        assert read_session(out).result.state.heights["exit"] == pytest.approx(0.5, abs=1e-9)

    def test_the_time_limit_ends_a_run_well(self, freeform, scene_file, out, fake_run, monkeypatch):
        seconds = []
        monkeypatch.setattr("time.perf_counter", lambda: float(len(seconds)))
        fake_run({iteration: lambda: seconds.append(1) for iteration in range(1, 11)})
        status, _, progress = freeform("design", scene_file, "-o", out, "--seconds", 3.5)
        assert status == 0
        assert read_session(out).result.iterations == 4
        assert "00:03 left" in progress.splitlines()[0]

    def test_remarks_about_the_picture_are_printed(
        self, freeform, tmp_path, scene_file, scene_data, out
    ):
        from PIL import Image

        Image.new("L", (9000, 8), 200).save(tmp_path / "wide.png")
        scene_data["target"] = {"image": "wide.png"}
        scene_file.write_text(json.dumps(scene_data))
        status, stdout, stderr = freeform("design", scene_file, "-o", out, "--iterations", 0)
        assert status == 0 and "wide.png" not in stdout
        assert "wide.png' has 9000 × 8 pixels and is reduced to 4500 × 4" in stderr

    def test_an_image_of_any_depth_with_alpha_is_taken(self, freeform, tmp_path, out, scene_data):
        from PIL import Image

        ramp = np.linspace(0, 65535, 64).reshape(8, 8)
        Image.fromarray(ramp.astype(np.uint16)).save(tmp_path / "deep.png")
        colours = np.zeros((8, 8, 4), dtype=np.uint8)
        colours[2:6, 2:6] = 200
        Image.fromarray(colours, "RGBA").save(tmp_path / "alpha.png")
        for name in ("deep.png", "alpha.png"):
            scene_data["target"] = {"image": name}
            (tmp_path / "scene.json").write_text(json.dumps(scene_data))
            status, _, _ = freeform("design", tmp_path / "scene.json", "-o", out, "--iterations", 1)
            assert status == 0
            assert read_session(out).scene.target.image == str(tmp_path / name)


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

    @pytest.mark.skipif(torch.cuda.is_available(), reason="there is a GPU")
    def test_a_gpu_that_is_not_there(self, freeform, scene_file, scene_data, out):
        scene_data["run"]["device"] = "cuda"
        scene_file.write_text(json.dumps(scene_data))
        status, stdout, stderr = freeform("design", scene_file, "-o", out)
        assert (status, stdout) == (2, "")
        assert stderr.startswith("freeform: run.device: 'cuda' needs")
        assert stderr.count("\n") == 1
        assert not out.exists()


class TestProgress:
    def test_lines_come_every_twentieth_of_the_run(self, freeform, scene_file, out, fake_run):
        fake_run({})
        status, _, progress = freeform("design", scene_file, "-o", out, "--iterations", 100)
        assert status == 0
        lines = progress.splitlines()
        assert [int(line.split("/")[0]) for line in lines] == list(range(0, 101, 5))
        assert lines[0] == "0/100  loss 1"
        assert lines[10] == "50/100  loss 0.01961  at most 00:50 left"

    def test_and_every_ten_seconds(self, freeform, scene_file, out, fake_run):
        fake_run({})  # each iteration takes a second
        _, _, progress = freeform("design", scene_file, "-o", out, "--iterations", 1000)
        assert [int(line.split("/")[0]) for line in progress.splitlines()][:3] == [0, 10, 20]

    def test_the_first_lens_and_compiling_are_left_out_of_the_time_left(
        self, freeform, scene_file, out, fake_run
    ):
        fake_run({}, seconds=lambda i: 0.0 if i == 0 else 900.0 + 2.0 * i)
        _, _, progress = freeform("design", scene_file, "-o", out, "--iterations", 10)
        lines = progress.splitlines()
        assert [line for line in lines if "left" in line] == lines[4:11]
        assert [line.split()[-2] for line in lines[4:11]] == [
            f"00:{2 * left:02}" for left in range(6, -1, -1)
        ]

    def test_what_the_task_lacks_is_printed_from_the_start(self, freeform, tmp_path, make_scene):
        scene = make_scene({"lens.height_range": [-0.01, 0.01], "lens.control_points": [24, 24]})
        image = np.zeros((32, 32))
        image[4:14, 4:14] = 1.0
        np.save(tmp_path / "corner.npy", image)
        data = scene.to_data() | {"target": {"image": "corner.npy"}}
        data["run"] = {"method": "auto", "iterations": 3}
        (tmp_path / "scene.json").write_text(json.dumps(data))
        _, _, progress = freeform("design", tmp_path / "scene.json", "-o", tmp_path / "x.freeform")
        said = [line for line in progress.splitlines() if "needs" in line]
        assert len(said) == 2  # at the start and at the end
        assert said[0].startswith("lens.height_range: The lens needs ")
        assert progress.splitlines().index(said[0]) < 5

    def test_a_bar_on_a_terminal(self, freeform, scene_file, out, fake_run, monkeypatch):
        monkeypatch.setattr("sys.stderr.isatty", lambda: True)
        monkeypatch.setenv("COLUMNS", "80")
        fake_run({})
        status, _, progress = freeform("design", scene_file, "-o", out)
        assert status == 0
        last = progress.rstrip("\n").split("\r")[-1]
        assert last.endswith(" 10/10, loss 0.09091  at most 00:00 left")
        assert progress.endswith("\n")
