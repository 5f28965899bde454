"""Shared libraries that pip does not install, with their Debian packages.

Only the standard library is imported: this runs before anything is installed.
"""

from __future__ import annotations

import ctypes
import os
import shutil
import sys
from collections.abc import Iterable, Sequence

# For drawing without a window.
OFF_SCREEN = (
    # Without this file numba falls back on threads that are not safe in several threads.
    ("libgomp.so.1.0.0", "libgomp1"),
    # VTK loads these when it draws, and crashes if one is missing.
    ("libGL.so.1", "libgl1"),
    ("libEGL.so.1", "libegl1"),
    ("libX11.so.6", "libx11-6"),
    ("libXcursor.so.1", "libxcursor1"),
)

# For the window: Qt's libraries and its X11 plugin are linked to these.
WINDOW = (
    *OFF_SCREEN,
    ("libglib-2.0.so.0", "libglib2.0-0"),
    ("libdbus-1.so.3", "libdbus-1-3"),
    ("libfontconfig.so.1", "libfontconfig1"),
    ("libfreetype.so.6", "libfreetype6"),
    ("libxkbcommon.so.0", "libxkbcommon0"),
    ("libxkbcommon-x11.so.0", "libxkbcommon-x11-0"),
    ("libX11-xcb.so.1", "libx11-xcb1"),
    ("libxcb.so.1", "libxcb1"),
    ("libxcb-cursor.so.0", "libxcb-cursor0"),
    ("libxcb-glx.so.0", "libxcb-glx0"),
    ("libxcb-icccm.so.4", "libxcb-icccm4"),
    ("libxcb-image.so.0", "libxcb-image0"),
    ("libxcb-keysyms.so.1", "libxcb-keysyms1"),
    ("libxcb-randr.so.0", "libxcb-randr0"),
    ("libxcb-render.so.0", "libxcb-render0"),
    ("libxcb-render-util.so.0", "libxcb-render-util0"),
    ("libxcb-shape.so.0", "libxcb-shape0"),
    ("libxcb-shm.so.0", "libxcb-shm0"),
    ("libxcb-sync.so.1", "libxcb-sync1"),
    ("libxcb-util.so.1", "libxcb-util1"),
    ("libxcb-xfixes.so.0", "libxcb-xfixes0"),
    ("libxcb-xkb.so.1", "libxcb-xkb1"),
)

# For Mitsuba 3.
MITSUBA = (("libatomic.so.1", "libatomic1"),)

# For tests of the window without a display.
VIRTUAL_SCREEN = (("xvfb-run", "xvfb"), ("xauth", "xauth"), ("xdotool", "xdotool"))


def keep_shaders_in_memory() -> None:
    """Keep Mesa from caching shaders on disk; call this before it is loaded.

    It writes them through a memory map, so a full disk would kill the process (bus error).
    """
    os.environ.setdefault("MESA_SHADER_CACHE_DISABLE", "true")


def missing(libraries: Iterable[tuple[str, str]] = WINDOW) -> list[tuple[str, str]]:
    """Return the (library, Debian package) pairs that this machine cannot load.

    Only Linux leaves these libraries to the system; elsewhere nothing is missing.
    """
    if sys.platform != "linux":
        return []
    return [(library, package) for library, package in libraries if not _loads(library)]


def missing_programs(programs: Iterable[tuple[str, str]]) -> list[tuple[str, str]]:
    """Return the (program, Debian package) pairs whose program is not on the search path."""
    return [(program, package) for program, package in programs if not shutil.which(program)]


def advice(missing: Sequence[tuple[str, str]]) -> str:
    """Return a line with the missing libraries and the command that installs them."""
    names = ", ".join(name for name, _ in missing)
    packages = " ".join(package for _, package in missing)
    sudo = "" if os.geteuid() == 0 else "sudo "
    return f"This machine lacks {names}; on Debian or Ubuntu type: {sudo}apt-get install {packages}"


def has_display() -> bool:
    """Return whether a window can be shown: on Linux, whether the session names an X display.

    A Wayland session names one too, for programs that, like VTK, draw through X.
    """
    return sys.platform != "linux" or bool(os.environ.get("DISPLAY"))


def _loads(library: str) -> bool:
    try:
        ctypes.CDLL(library)
    except OSError:
        return False
    return True
