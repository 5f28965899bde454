"""The files that were open last."""

from pathlib import Path

from PySide6.QtCore import QSettings

_KEY = "recent_files"
_MOST = 10


class RecentFiles:
    """A list of paths in the settings, the latest first.

    Parameters
    ----------
    settings : QSettings
        Where the list outlives the window.
    """

    def __init__(self, settings: QSettings) -> None:
        self._settings = settings

    def paths(self) -> list[Path]:
        """At most ten files; some may be gone by now."""
        stored = self._settings.value(_KEY)
        if isinstance(stored, str):  # a list of one, as an ini file tells it
            return [Path(stored)]
        named = stored if isinstance(stored, list) else []
        return [Path(path) for path in named if isinstance(path, str)]

    def add(self, path: Path) -> None:
        """Put a file first."""
        path = path.absolute()
        self._store([path, *(other for other in self.paths() if other != path)])

    def remove(self, path: Path) -> None:
        """Forget a file."""
        self._store([other for other in self.paths() if other != path])

    def _store(self, paths: list[Path]) -> None:
        self._settings.setValue(_KEY, [str(path) for path in paths[:_MOST]])
