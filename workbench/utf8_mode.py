"""Names of files in UTF-8, whatever the locale: scenes and sessions name files in any language."""

import os
import sys

_UTF_8 = "utf-8"


def restart_in_utf8_mode() -> None:
    """Start this program anew in Python's UTF-8 mode, where the locale has no names in UTF-8.

    What the terminal understands stays as it is. Does nothing where names are in UTF-8 already, as
    on most systems.
    """
    if os.name != "posix" or sys.getfilesystemencoding() == _UTF_8:
        return
    terminal = getattr(sys.stdout or sys.stderr, "encoding", None) or "ascii"
    environment = {
        "PYTHONIOENCODING": f"{terminal}:backslashreplace",
        **os.environ,
        "PYTHONUTF8": "1",
    }
    os.execve(sys.executable, [sys.executable, *sys.orig_argv[1:]], environment)
