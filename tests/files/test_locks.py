"""Locks of files, and fingerprints of their content."""

import os
import subprocess
import sys

import pytest

from workbench.errors import Refused
from workbench.files.atomic import locked
from workbench.files.session import Session, write_session
from workbench.reading import fingerprint
from workbench.targets import load_target


def test_a_change_that_keeps_size_and_time_is_noticed(tmp_path):
    path = tmp_path / "file"
    path.write_bytes(b"light")
    before, times = fingerprint(path), path.stat()
    path.write_bytes(b"night")
    os.utime(path, ns=(times.st_atime_ns, times.st_mtime_ns))
    assert fingerprint(path) != before


def test_writing_a_session_gives_its_fingerprint(make_scene, tmp_path):
    scene = make_scene()
    path = tmp_path / "a.freeform"
    assert write_session(Session(scene, load_target(scene, tmp_path)), path) == fingerprint(path)


HOLD = (
    "import sys, time; from pathlib import Path; from workbench.files.atomic import locked\n"
    "with locked(Path(sys.argv[1]), 'busy'): print(flush=True); time.sleep(60)"
)


@pytest.fixture
def path(tmp_path):
    return tmp_path / ".lock"


def test_a_lock_is_held_by_one_at_a_time_and_leaves_nothing(path):
    refused = pytest.raises(Refused, match=rf"^{path.parent}: is taken$")
    with locked(path, "is taken"), refused, locked(path, "is taken"):
        pytest.fail("held twice")
    with locked(path, "is taken"):
        pass
    assert not path.exists()


def test_the_lock_of_a_killed_process_is_free(path):
    with subprocess.Popen(
        [sys.executable, "-c", HOLD, path], stdout=subprocess.PIPE, text=True
    ) as process:
        process.stdout.readline()
        with pytest.raises(Refused, match="is taken"), locked(path, "is taken"):
            pytest.fail("held twice")
        process.kill()
        process.wait()
        assert path.exists()
        with locked(path, "is taken"):
            pass
    assert not path.exists()
