"""A parser that refuses in one line, and help that fits on one screen."""

import argparse
import re
import shutil
import textwrap
from collections.abc import Callable, Sequence
from typing import Any, NoReturn

from workbench.errors import Refused

Command = Callable[[argparse.Namespace], None]

_WIDEST, _INDENT = 96, 26


class Parser(argparse.ArgumentParser):
    """Refuses in one line, without the usage, and takes no abbreviations."""

    def __init__(self, **settings: Any) -> None:
        super().__init__(**settings, allow_abbrev=False, formatter_class=_Help)

    def error(self, message: str) -> NoReturn:
        """Refuse."""
        raise Refused("usage", f"{message}; {self.prog} --help tells more")


class _Help(argparse.RawDescriptionHelpFormatter):
    """Keeps lines as they are, as long as they fit."""

    def __init__(self, prog: str) -> None:
        width = min(shutil.get_terminal_size().columns, _WIDEST)
        super().__init__(prog, max_help_position=_INDENT, width=width)

    def _fill_text(self, text: str, width: int, indent: str) -> str:
        lines = [
            textwrap.fill(line, width, subsequent_indent=" " * _hang(line))
            for line in text.splitlines()
        ]
        return "\n".join(indent + line for line in lines)


def _hang(line: str) -> int:
    """Where a line goes on below itself: behind a name in a list, a bit inwards in an example."""
    if named := re.match(r"  \S+ {2,}", line):
        return named.end()
    return 6 if line.startswith(" ") else 0


def add_verb(
    commands: Any, name: str, description: str, examples: Sequence[str], command: Command
) -> Parser:
    """Add a verb.

    Parameters
    ----------
    commands
        What ``add_subparsers`` has given.
    name : str
        The verb.
    description : str
        What it does in some sentences.
    examples : sequence of str
        Lines that can be typed; without the program's name.
    command : callable
        Runs it, with the namespace.

    Returns
    -------
    Parser
        To add arguments to.
    """
    parser: Parser = commands.add_parser(
        name,
        description=description,
        epilog="\n".join(["examples:", *(f"  freeform {line}" for line in examples)]),
    )
    parser.set_defaults(command=command)
    return parser
