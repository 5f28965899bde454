"""A design run does not lose its lens: signals, full disks, ends of the process."""

import errno
import os
import signal
import tempfile
import time
from pathlib import Path

import pytest

from workbench.cli import checkpoints
from workbench.files.session import read_session
from workbench.progress import check_interruption

SIGNALS = [signal.SIGINT, signal.SIGTERM, signal.SIGHUP]


def sent(*numbers):
    """An event that sends signals to this process."""

    def send():
        for number in numbers:
            os.kill(os.getpid(), number)

    return send


@pytest.fixture
def often(monkeypatch):
    """Checkpoints after every iteration."""
    monkeypatch.setattr(checkpoints, "_SECONDS", 0.0)
    monkeypatch.setattr(checkpoints, "_PART", float("inf"))


class TestSignals:
    @pytest.mark.parametrize("number", SIGNALS)
    def test_the_best_lens_so_far_is_written(self, freeform, scene_file, out, fake_run, number):
        fake_run({4: sent(number)})
        before = [signal.getsignal(each) for each in SIGNALS]
        status, stdout, stderr = freeform("design", scene_file, "-o", out)
        assert status == 128 + number
        assert [signal.getsignal(each) for each in SIGNALS] == before
        assert "after 4 iterations" in stdout
        assert read_session(out).result.iterations == 4
        last = stderr.splitlines()[-1]
        assert last == f"freeform: interrupted; the best lens so far is in {out}"

    def test_a_second_ctrl_c_does_not_wait_for_the_iteration(
        self, freeform, scene_file, out, fake_run
    ):
        def press_twice():
            sent(signal.SIGINT, signal.SIGINT)()
            raise AssertionError("the iteration went on")

        fake_run({4: press_twice})
        status, _, stderr = freeform("design", scene_file, "-o", out)
        assert status == 130
        assert read_session(out).result.iterations == 3
        assert stderr.splitlines()[-1] == "freeform: interrupted"

    @pytest.mark.parametrize("number", SIGNALS)
    def test_a_signal_that_the_parent_ignores_is_ignored(
        self, freeform, scene_file, out, fake_run, number
    ):
        """As nohup has it ignored."""
        fake_run({4: sent(number)})
        signal.signal(number, signal.SIG_IGN)  # `usual_signals` puts it back
        assert freeform("design", scene_file, "-o", out)[0] == 0
        assert read_session(out).result.iterations == 10

    @pytest.mark.parametrize("ends", [sent(signal.SIGINT), None], ids=["Ctrl-C", "--seconds"])
    def test_long_work_within_an_iteration_ends(self, freeform, scene_file, out, fake_run, ends):
        def work():
            if ends:
                ends()
            for _ in range(3000):
                check_interruption()
                time.sleep(0.01)
            raise AssertionError("the work went on")

        fake_run({1: work})
        limit = () if ends else ("--seconds", 0.05)
        status = freeform("design", scene_file, "-o", out, *limit)[0]
        assert status == (130 if ends else 0)
        assert read_session(out).result.iterations == 0

    def test_nothing_interrupts_the_last_write(
        self, freeform, scene_file, out, fake_run, monkeypatch
    ):
        fake_run({4: sent(signal.SIGINT)})
        write = checkpoints.write_session

        def impatient(session, path):
            sent(signal.SIGINT, signal.SIGINT, signal.SIGTERM)()
            write(session, path)

        monkeypatch.setattr(checkpoints, "write_session", impatient)
        assert freeform("design", scene_file, "-o", out)[0] == 130
        assert read_session(out).result.iterations == 4


def full(*_):
    raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))


class TestRescue:
    @pytest.fixture(autouse=True)
    def elsewhere(self, tmp_path, monkeypatch):
        folder = tmp_path / "elsewhere"
        folder.mkdir()
        monkeypatch.setattr(tempfile, "tempdir", str(folder))
        monkeypatch.setenv("HOME", str(tmp_path / "home"))
        return folder

    def rescued(self, stderr):
        """Last line before its end, and the session that it names."""
        reason, place = stderr.splitlines()[-1].split("; the lens is in ")
        return reason, Path(place)

    def test_a_disk_that_is_full_at_the_end(
        self, freeform, scene_file, out, fake_run, monkeypatch, elsewhere
    ):
        out.write_bytes(b"old")
        fake_run({9: lambda: monkeypatch.setattr("os.fsync", at_first(os.fsync))})
        status, stdout, stderr = freeform("design", scene_file, "-o", out)
        assert (status, stdout) == (2, "")
        reason, place = self.rescued(stderr)
        assert reason == f"freeform: {out}: cannot be written: No space left on device"
        assert elsewhere in place.parents
        assert read_session(place).result.iterations == 10
        assert out.read_bytes() == b"old"
        assert sorted(os.listdir(out.parent)) == ["elsewhere", "lens.freeform", "scene.json"]


def at_first(later):
    """A function that fails as on a full disk when it is called for the first time."""
    functions = iter([full])
    return lambda *arguments: next(functions, later)(*arguments)


@pytest.mark.usefixtures("often")
class TestCheckpoint:
    def test_a_run_that_is_continued_from_a_checkpoint_removes_only_its_own(
        self, freeform, scene_file, out, fake_run
    ):
        left, seen = out.with_name("lens.checkpoint.freeform"), []
        fake_run({4: lambda: seen.append((out.exists(), read_session(left).result.iterations))})
        assert freeform("design", scene_file, "-o", out)[0] == 0
        assert seen == [(False, 3)] and not left.exists()
        fake_run({})
        assert freeform("design", scene_file, "-o", left)[0] == 0
        status, _, stderr = freeform("design", left, "-o", out)
        assert status == 0 and "cut off" not in stderr
        assert read_session(out).result.iterations == 20
        assert left.exists()
