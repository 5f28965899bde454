"""No verb writes over what it reads: files are declared as read or written, and compared here."""

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import NamedTuple

from workbench.errors import Refused

_ROLES = {"image": "target image", "heights": "file of control heights"}
"""What files that a scene names are called, by the names of their fields."""


class Input(NamedTuple):
    """A file that a command reads.

    Attributes
    ----------
    path : Path
        The file. Those that it refers to are read as well.
    role : str
        What refusals call it: "the session".
    """

    path: Path
    role: str


class Output(NamedTuple):
    """A file that a command writes.

    Attributes
    ----------
    path : Path
        The file.
    may_replace : callable
        Whether it may take the place of an input.
    """

    path: Path
    may_replace: Callable[[Path], bool]


def check_distinct(inputs: Sequence[Input], outputs: Sequence[Output]) -> None:
    """Find out beforehand whether a command would write over what it reads, or twice.

    Links count as the file that they mean, and so do names in another case where they mean one.

    Raises
    ------
    Refused
        If it would.
    """
    if not outputs:
        return
    from workbench.files.references import is_one_file, named_twice  # late: numpy, pydantic

    for path, role in inputs:
        for output in outputs:
            if is_one_file(output.path, path) and not output.may_replace(path):
                raise Refused(str(output.path), f"is {role} itself; another file is needed")
    if twice := named_twice(output.path for output in outputs):
        raise Refused(str(twice), "is named twice; each file is written once")
    # What is not there yet cannot be such a file either, and then none has to be looked for.
    replaced = [output.path for output in outputs if output.path.exists()]
    for path in [path for path, _ in inputs if replaced]:
        for field, file in _files(path):
            for output_path in replaced:
                if is_one_file(output_path, file):
                    role = _ROLES.get(field.rpartition(".")[2], "file of light")
                    raise Refused(
                        str(output_path), f"is the {role} of {path}; another file is needed"
                    )


def _files(path: Path) -> tuple[tuple[str, Path], ...]:
    from workbench.files.references import files_of

    try:
        return files_of(path)
    except Refused:  # by the command itself, which reads the same file
        return ()
