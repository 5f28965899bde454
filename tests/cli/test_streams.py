"""Standard output and error that are closed, broken or full: work is done, one line reports it."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

FREEFORM = Path(sys.executable).with_name("freeform")
BROKEN = "| true"  # which reads nothing and is gone before the program has begun
ONE_BYTE = "| head -c 1 > /dev/null"


def shell(command, folder="."):
    """Runs a command in which "$1" is the program, with buffers as outside of tests."""
    return subprocess.run(
        ["bash", "-c", f"set -o pipefail; {command}", "bash", FREEFORM],
        capture_output=True,
        text=True,
        env={**os.environ, "PYTHONUNBUFFERED": ""},
        cwd=folder,
    )


@pytest.mark.parametrize("command", ['"$1" design --help', '"$1" --version'])
def test_a_full_disk_behind_the_output_is_one_line(command):
    done = shell(f"{command} > /dev/full")
    assert done.returncode == 1
    assert done.stderr.startswith("freeform: standard output cannot be written: ")
    assert done.stderr.count("\n") == 1


@pytest.mark.parametrize(
    ("command", "reader"),
    [('"$1" design --help', BROKEN), ('"$1" --version', BROKEN), ('"$1" --help', ONE_BYTE)],
)
def test_a_reader_that_leaves_is_no_failure(command, reader):
    done = shell(f"{command} {reader}")
    assert (done.returncode, done.stderr) == (0, "")


def test_closed_streams_do_not_keep_files_from_being_written(freeform, lens, tmp_path):
    assert freeform("export", lens, tmp_path / "c.stl", tmp_path / "d.obj")[0] == 0
    for closed in ("2>&-", "<&- >&- 2>&-"):
        done = shell(f'"$1" export {lens} a.stl b.obj {closed}', tmp_path)
        assert (closed, done.returncode, done.stderr) == (closed, 0, "")
        assert len(done.stdout.splitlines()) == (0 if " >&-" in f" {closed}" else 2)
        for name, other in (("a.stl", "c.stl"), ("b.obj", "d.obj")):
            written = tmp_path / name  # nothing was printed into it
            assert written.read_bytes() == (tmp_path / other).read_bytes()
            written.unlink()


@pytest.mark.skipif(os.name != "posix", reason="elsewhere names of files are in UTF-8")
def test_a_locale_without_utf_8_finds_files_and_gets_plain_characters(lens, tmp_path):
    (tmp_path / "Maß.freeform").write_bytes(lens.read_bytes())
    locale = {"LC_ALL": "C", "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0"}
    done = subprocess.run(
        [FREEFORM, "export", "Maß.freeform", "Öl.stl", "--chord-error", "1e-3"],
        capture_output=True,
        env={name: value for name, value in os.environ.items() if name != "PYTHONIOENCODING"}
        | locale,
        cwd=tmp_path,
    )
    assert (done.returncode, done.stderr) == (0, b"")
    assert done.stdout.startswith(rb"\xd6l.stl: STL mesh, chord error ") and b"e-" in done.stdout
    assert (tmp_path / "Öl.stl").exists()
