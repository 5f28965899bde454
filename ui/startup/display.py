"""Whether a window can open here, found out before Qt would abort."""

import ctypes
import os
import sys

from workbench import system_libraries

# Platforms of Qt that need no display, as tests use them.
_WITHOUT_DISPLAY = ("offscreen", "minimal", "vnc")


def why_no_window() -> str | None:
    """One sentence on what stands in the way of a window; None if nothing does."""
    if not sys.platform.startswith("linux"):
        return None
    if missing := system_libraries.missing():
        return system_libraries.advice(missing)
    if os.environ.get("QT_QPA_PLATFORM", "").startswith(_WITHOUT_DISPLAY):
        return None
    if not os.environ.get("DISPLAY"):
        return "no display: DISPLAY is not set; use `freeform` to design without a window"
    if not _display_answers():
        return f"no display: {os.environ['DISPLAY']} does not answer; is an X server running?"
    return None


def _display_answers() -> bool:
    xcb = ctypes.CDLL("libxcb.so.1")
    xcb.xcb_connect.restype = ctypes.c_void_p
    xcb.xcb_connect.argtypes = (ctypes.c_char_p, ctypes.c_void_p)
    xcb.xcb_connection_has_error.argtypes = (ctypes.c_void_p,)
    # Stays open as long as the process: a virtual screen starts anew when its last client leaves,
    # and would turn Qt away in the meantime.
    connection = xcb.xcb_connect(None, None)
    return bool(xcb.xcb_connection_has_error(connection) == 0)
