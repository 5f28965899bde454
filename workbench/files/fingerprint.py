"""What a file holds, so that what another program has made of it since is noticed."""

from hashlib import blake2b
from pathlib import Path
from typing import BinaryIO

from workbench.reading import opened

_BLOCK = 1 << 20  # bytes


def fingerprint(path: Path) -> str | None:
    """Digest of the content of a file.

    Times and sizes tell less: a copy may keep both, and a clock may be coarse.

    `path`: file; a symbolic link is followed. Returns None where there is no file. Raises `Refused`
    if there is something that cannot be read.
    """
    if not path.exists():
        return None
    with opened(path) as file:
        return digest(file)


def digest(file: BinaryIO) -> str:
    """Digest of all that follows in an open file, as `fingerprint` gives it."""
    found = blake2b(digest_size=16)
    while block := file.read(_BLOCK):
        found.update(block)
    return found.hexdigest()
