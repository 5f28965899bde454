"""Dialects of G-code: the words that controls differ in.

Texts hold the fields ``program``, ``tool``, ``seconds`` and ``tolerance``; a line of a text is a
line of the program.
"""

from dataclasses import dataclass


@dataclass(frozen=True)
class Dialect:
    """Words of a control."""

    name: str  # for users
    decimals: int  # of coordinates in mm
    begin: str = ""  # before everything
    modes: str = "G21 G90 G17 G94 G54"
    exact: str = "G61"  # path mode of finishing
    blended: str = "G61"  # path mode of roughing: ``tolerance`` from the path, where it has one
    first_tool: str = ""  # before the first pass
    next_tool: str = (
        "(change the cutter and set the zero of Z again)\nM0"  # before a pass with another cutter
    )
    lengths: str = ""  # after a change of the cutter, with the first travel in z
    dwell: str = "G4 P{seconds:g}"
    end: str = "M30"
    numbers: int = 0  # step of the N words; none by default
    capitals: bool = False  # whether comments are in capitals


DIALECTS = {
    "grbl": Dialect("GRBL", decimals=5),
    "linuxcnc": Dialect(
        "LinuxCNC",
        decimals=5,
        modes="G21 G90 G17 G94 G54 G40 G49 G80",
        blended="G64 P{tolerance}",
        first_tool="T{tool} M6",
        next_tool="T{tool} M6",
        lengths="G43",
    ),
    "fanuc": Dialect(
        "Fanuc-like",
        decimals=3,  # least increment of IS-B
        begin="%\nO{program:04d}",
        modes="G21 G90 G17 G94 G54 G40 G49 G80",
        exact="G64",  # G61 stops at the end of each move
        blended="G64",
        first_tool="T{tool} M6",
        next_tool="T{tool} M6",
        lengths="G43 H{tool}",
        dwell="G4 X{seconds:.3f}",
        end="M30\n%",
        numbers=10,
        capitals=True,
    ),
}
"""Dialects by name."""
