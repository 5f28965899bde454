"""Unexpected errors: one sentence for the user, and a log file with program, system and traceback.

The file is in the user's state folder. Beyond a size it is renamed, and the older file is removed.
"""

import os
import platform
import traceback
from datetime import datetime
from pathlib import Path

import platformdirs

import workbench

# Characters of one error, and bytes of the file.
_LONGEST = 1 << 16
_LARGEST = 1 << 18


def unexpected(error: BaseException) -> str:
    """Log an error and return it in words: ``unexpected KeyError: 'x' (details are in …)``."""
    text = f"unexpected {type(error).__name__}: {error}".rstrip(": ")
    try:
        _append(file(), f"{datetime.now().astimezone():%Y-%m-%d %H:%M:%S %z}\n{details(error)}\n")
    except OSError as failure:
        return f"{text} (details could not be written to {file()}: {failure.strerror or failure})"
    return f"{text} (details are in {file()})"


def details(error: BaseException) -> str:
    """Return program, system and traceback."""
    about = (
        f"Freeform Lens Workbench {workbench.__version__}, Python {platform.python_version()}, "
        f"{platform.platform()}"
    )
    trace = "".join(traceback.format_exception(error))
    return f"{about}\n{trace[-_LONGEST:]}"


def file() -> Path:
    """Return the log file."""
    return Path(platformdirs.user_state_dir("freeform-workbench", appauthor=False)) / "errors.log"


def _append(path: Path, text: str) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    if path.exists() and path.stat().st_size > _LARGEST:
        os.replace(path, path.with_suffix(".old.log"))
    with open(path, "a", encoding="utf-8", errors="backslashreplace") as log:
        log.write(text)
