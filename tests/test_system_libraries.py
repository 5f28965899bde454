import importlib.util
import os
import re
import sys
from pathlib import Path

import pytest

from workbench import system_libraries

on_linux = pytest.mark.skipif(sys.platform != "linux", reason="Linux leaves them to the system")

# Part of the smallest Debian, of Qt's own packages, or of a package that is asked for anyway.
GIVEN = {
    "libc.so.6",
    "libm.so.6",
    "libgcc_s.so.1",
    "libstdc++.so.6",
    "libz.so.1",
    "libzstd.so.1",
    "libicudata.so.73",
    "libicui18n.so.73",
    "libicuuc.so.73",
    "libgthread-2.0.so.0",
}


@on_linux
def test_a_library_that_does_not_load_is_missing_with_its_package():
    asked = [("libc.so.6", "libc6"), ("libnowhere.so.7", "libnowhere7")]
    assert system_libraries.missing(asked) == [("libnowhere.so.7", "libnowhere7")]


@pytest.mark.parametrize(("user", "command"), [(0, "apt-get"), (1000, "sudo apt-get")])
def test_the_advice_is_one_line_with_names_and_command(monkeypatch, user, command):
    monkeypatch.setattr(os, "geteuid", lambda: user)
    line = system_libraries.advice([("libGL.so.1", "libgl1"), ("xauth", "xauth")])
    assert line == (
        "This machine lacks libGL.so.1, xauth; on Debian or Ubuntu type: "
        f"{command} install libgl1 xauth"
    )


@on_linux
def test_every_library_that_qt_is_linked_to_is_asked_for():
    qt = Path(importlib.util.find_spec("PySide6").origin).parent / "Qt"
    linked = set()
    for binary in [
        *(qt / "lib" / f"libQt6{part}.so.6" for part in ("Core", "Gui", "Widgets", "DBus", "Svg")),
        qt / "lib/libQt6XcbQpa.so.6",
        *qt.glob("plugins/xcbglintegrations/*.so"),
    ]:
        names = re.findall(rb"lib[\w+-]+(?:-[\d.]+)?\.so\.\d+", binary.read_bytes())
        linked.update(name.decode() for name in names if not name.startswith(b"libQt6"))
    asked = {library for library, _ in system_libraries.WINDOW}
    assert {"libGL.so.1", "libxcb-cursor.so.0"} <= linked
    assert linked - asked <= GIVEN
