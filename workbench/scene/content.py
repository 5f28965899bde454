"""What a file that a scene names holds, carried along with the scene."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Content:
    """What a file holds, and beside which scene.

    Attributes
    ----------
    data : bytes, optional
        All of the file; none where it is read anew whenever it is needed.
    unit : str
        Unit of the scene's lengths; the file has one of its own.
    """

    data: bytes | None = None
    unit: str = "mm"
