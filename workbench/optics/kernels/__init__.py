"""Fused kernels for the CPU: the twins of the torch reference that do a whole trace in one pass.

Numba keeps compiled kernels on disk and compiles one anew when its own file changes. But kernels
contain those of other files that they call, so a folder is used that is named after all of them.
"""

import hashlib
from pathlib import Path

import numba

_room = Path(__file__).parent
_sources = b"".join(file.read_bytes() for file in sorted(_room.glob("*.py")))
_folder = Path(numba.config.CACHE_DIR or _room / "__pycache__")  # type: ignore[attr-defined]
# Where this cannot be written to, numba falls back on a folder of the user's.
_named = _folder / f"kernels-{hashlib.sha256(_sources).hexdigest()[:16]}"
numba.config.CACHE_DIR = str(_named)  # type: ignore[attr-defined]
