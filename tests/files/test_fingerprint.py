"""Fingerprints of files: equal content alone has an equal one."""

import os

from workbench.files.fingerprint import fingerprint
from workbench.files.session import Session, write_session
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
