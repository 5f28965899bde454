import errno
import os
import shutil
import stat
import tempfile
from pathlib import Path

import pytest

from workbench.errors import Refused
from workbench.files import atomic
from workbench.files.atomic import check_writable, replacing


def write(path, content):
    with replacing(path) as file:
        file.write(content)


@pytest.fixture
def nobodys_folder():
    """A folder of an unprivileged user, whom the test runs as: root may write everywhere."""
    folder = Path(tempfile.mkdtemp())
    user = 65534 if os.geteuid() == 0 else os.geteuid()
    os.chown(folder, user, -1)
    before = os.geteuid()
    os.seteuid(user)
    try:
        yield folder
    finally:
        os.seteuid(before)
        folder.chmod(0o700)
        shutil.rmtree(folder)


def test_a_new_file_gets_the_content_and_ordinary_permissions(tmp_path):
    path = tmp_path / "new"
    umask = os.umask(0o027)
    try:
        write(path, b"content")
    finally:
        os.umask(umask)
    assert path.read_bytes() == b"content"
    assert stat.S_IMODE(path.stat().st_mode) == 0o640
    assert os.listdir(tmp_path) == ["new"]


def test_a_link_stays_a_link(tmp_path):
    (tmp_path / "folder").mkdir()
    real, link = tmp_path / "folder" / "real", tmp_path / "link"
    real.write_bytes(b"old")
    link.symlink_to(real)
    write(link, b"new")
    assert link.is_symlink()
    assert real.read_bytes() == b"new"


@pytest.mark.parametrize("failure", [KeyboardInterrupt, ValueError("a mistake"), SystemExit])
def test_an_exception_in_the_block_leaves_the_old_file_alone(tmp_path, failure):
    path = tmp_path / "file"
    path.write_bytes(b"old")
    with pytest.raises(BaseException) as caught, replacing(path) as file:
        file.write(b"new")
        raise failure
    assert not isinstance(caught.value, Refused)
    assert path.read_bytes() == b"old"
    assert os.listdir(tmp_path) == ["file"]


@pytest.mark.parametrize("step", ["fsync", "chmod", "replace"])
def test_a_disk_that_fails_at_any_step_leaves_the_old_file_alone(tmp_path, monkeypatch, step):
    path = tmp_path / "file"
    path.write_bytes(b"old")

    def fail(*_):
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(atomic.os, step, fail)
    with pytest.raises(Refused, match=r"file: cannot be written: No space left on device$"):
        write(path, b"new")
    assert path.read_bytes() == b"old"
    assert os.listdir(tmp_path) == ["file"]


@pytest.mark.parametrize("attempt", [check_writable, lambda path: write(path, b"")])
class TestRefused:
    def test_read_only_folder(self, nobodys_folder, attempt):
        nobodys_folder.chmod(0o500)
        with pytest.raises(Refused, match="cannot be written: Permission denied"):
            attempt(nobodys_folder / "file")
        assert os.listdir(nobodys_folder) == []


class TestLeftBehind:
    """What a process that was killed leaves goes with the next that writes the same file."""

    @pytest.fixture
    def target(self, tmp_path):
        return tmp_path / "file"

    @pytest.fixture
    def left(self, target):
        """The file that was being written as the process was killed."""
        with replacing(target) as file:
            left = atomic.Path(file.name)
        target.rename(left)
        left.write_bytes(b"half")
        return left

    def test_a_leftover_is_removed_by_the_next_write(self, left, target):
        write(target, b"whole")
        assert os.listdir(target.parent) == ["file"]
        assert target.read_bytes() == b"whole"

    def test_a_file_that_is_being_written_is_no_leftover(self, target):
        with replacing(target) as slow:
            slow.write(b"slow")
            write(target, b"fast")
            assert target.read_bytes() == b"fast"
        assert target.read_bytes() == b"slow"
        assert os.listdir(target.parent) == ["file"]
