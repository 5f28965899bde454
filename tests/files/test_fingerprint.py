"""Fingerprints of files: equal content alone has an equal one."""

import os

import pytest

from workbench.errors import Refused
from workbench.files.fingerprint import fingerprint
from workbench.files.session import Session, write_session
from workbench.targets import load_target


def test_content_alone_counts(tmp_path):
    one, other = tmp_path / "one", tmp_path / "other"
    one.write_bytes(b"light")
    other.write_bytes(b"light")
    assert fingerprint(one) == fingerprint(other)


def test_a_change_that_keeps_size_and_time_is_noticed(tmp_path):
    path = tmp_path / "file"
    path.write_bytes(b"light")
    before, times = fingerprint(path), path.stat()
    path.write_bytes(b"night")
    os.utime(path, ns=(times.st_atime_ns, times.st_mtime_ns))
    assert fingerprint(path) != before


def test_a_missing_file_has_none(tmp_path):
    assert fingerprint(tmp_path / "none") is None
    (tmp_path / "link").symlink_to(tmp_path / "none")
    assert fingerprint(tmp_path / "link") is None
    (tmp_path / "none").write_bytes(b"")
    assert fingerprint(tmp_path / "link") == fingerprint(tmp_path / "none")
    assert fingerprint(tmp_path / "link") is not None


def test_path_that_is_no_file_is_refused(tmp_path):
    with pytest.raises(Refused, match="is a folder"):
        fingerprint(tmp_path)


def test_writing_a_session_gives_its_fingerprint(make_scene, tmp_path):
    scene = make_scene()
    path = tmp_path / "a.freeform"
    assert write_session(Session(scene, load_target(scene, tmp_path)), path) == fingerprint(path)
