"""Check whether a window can open, before Qt would abort."""

import ctypes
import os
import subprocess
import sys

from workbench import system_libraries

_PLATFORM = "QT_QPA_PLATFORM"
# Starts everywhere: tests use it.
_OFFSCREEN = "offscreen"
_X = "xcb"
# Vulkan alone draws there, and no widget.
_WITHOUT_WIDGETS = "vkkhrdisplay"
_PROBE = (
    "from PySide6.QtGui import QGuiApplication, QRasterWindow;a = QGuiApplication(['probe']); w = "
    "QRasterWindow(); w.resize(8, 8); w.show();a.processEvents()"
)
_PATIENCE_S = 20.0


def why_no_window() -> str | None:
    """Return why no window can open; None if it can."""
    platform = os.environ.get(_PLATFORM, "")
    if sys.platform.startswith("linux"):
        if missing := system_libraries.missing():
            return system_libraries.advice(missing)
        if platform in ("", _X) and (reason := _why_no_x_window()):
            return reason
    if platform in ("", _OFFSCREEN, _X) or (platform != _WITHOUT_WIDGETS and _starts()):
        return None
    return f"no window opens with {_PLATFORM}={platform}; type: {_cure()}"


def _cure() -> str:
    if sys.platform == "win32":
        return f"set {_PLATFORM}= & freeform-workbench"
    return f"env -u {_PLATFORM} freeform-workbench"


def _why_no_x_window() -> str | None:
    if not os.environ.get("DISPLAY"):
        return "no display: DISPLAY is not set; use `freeform` to design without a window"
    if not _display_answers():
        return f"no display: {os.environ['DISPLAY']} does not answer; is an X server running?"
    return None


def _starts() -> bool:
    try:
        command = [sys.executable, "-c", _PROBE]
        done = subprocess.run(command, capture_output=True, timeout=_PATIENCE_S, check=False)
    except (OSError, subprocess.TimeoutExpired):
        return False
    return done.returncode == 0


def _display_answers() -> bool:
    xcb = ctypes.CDLL("libxcb.so.1")
    xcb.xcb_connect.restype = ctypes.c_void_p
    xcb.xcb_connect.argtypes = (ctypes.c_char_p, ctypes.c_void_p)
    xcb.xcb_connection_has_error.argtypes = (ctypes.c_void_p,)
    # Stays open as long as the process: a virtual screen starts anew when its last client leaves,
    # and would turn Qt away in the meantime.
    connection = xcb.xcb_connect(None, None)
    return bool(xcb.xcb_connection_has_error(connection) == 0)
