"""What a file that a scene names holds, carried along with the scene."""

from dataclasses import dataclass


@dataclass(frozen=True, eq=False)
class Content:
    """What a file holds, and beside which scene; it is no setting: scenes do not differ by it.

    Attributes
    ----------
    data : bytes, optional
        All of the file; none where it is read anew whenever it is needed.
    unit : str
        Unit of the scene's lengths; the file has one of its own.
    """

    data: bytes | None = None
    unit: str = "mm"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Content)

    def __hash__(self) -> int:
        return 0
