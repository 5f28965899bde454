"""A parser that refuses in one line, knows which files are read and written, and helps briefly."""

import argparse
import re
import shutil
import textwrap
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple, NoReturn

from workbench.cli.verbs.distinct import Input, Output, check_distinct
from workbench.errors import Refused

Command = Callable[[argparse.Namespace], None]

_WIDEST, _INDENT = 96, 26


class _Written(NamedTuple):
    """An argument that says where something goes, as `Parser.add_output` takes it."""

    dest: str
    files: Callable[[Path], Sequence[Path]]
    may_replace: Callable[[Path], bool]


class Parser(argparse.ArgumentParser):
    """Refuses in one line, without the usage, and takes no abbreviations.

    Each file is either an input or an output, so that no command can write over what it reads.
    """

    def __init__(self, **settings: Any) -> None:
        super().__init__(**settings, allow_abbrev=False, formatter_class=_Help)
        self._read: list[tuple[str, str]] = []  # arguments, and what refusals call their files
        self._written: list[_Written] = []

    def add_argument(self, *names: str, **settings: Any) -> argparse.Action:
        """Add an argument that is no file."""
        if settings.get("type") is Path:
            raise TypeError(f"{names[0]}: files are added as inputs or outputs")
        return super().add_argument(*names, **settings)

    def add_input(self, *names: str, role: str, **settings: Any) -> None:
        """Add a file that is read; refusals call it by its role."""
        action = super().add_argument(*names, type=Path, **settings)
        self._read.append((action.dest, role))

    def add_output(
        self,
        *names: str,
        files: Callable[[Path], Sequence[Path]] = lambda path: (path,),
        may_replace: Callable[[Path], bool] = lambda path: False,
        **settings: Any,
    ) -> None:
        """Add a file that is written, or a folder of such.

        Parameters
        ----------
        names, settings
            As for `add_argument`.
        files : callable
            Which files are written, by what was typed; that itself by default.
        may_replace : callable
            Which input it may be; none by default.
        """
        action = super().add_argument(*names, type=Path, **settings)
        self._written.append(_Written(action.dest, files, may_replace))

    def check_files(self, options: argparse.Namespace) -> None:
        """Refuse a command line that names a file as input and output, or as output twice.

        Raises
        ------
        Refused
            If it does.
        """
        inputs = [Input(path, role) for dest, role in self._read for path in _paths(options, dest)]
        outputs = [
            Output(path, may_replace)
            for dest, files, may_replace in self._written
            for typed in _paths(options, dest)
            for path in files(typed)
        ]
        check_distinct(inputs, outputs)

    def error(self, message: str) -> NoReturn:
        """Refuse."""
        raise Refused("usage", f"{message}; {self.prog} --help tells more")


def _paths(options: argparse.Namespace, dest: str) -> Iterator[Path]:
    """What was typed for an argument: one, several or none."""
    typed = getattr(options, dest)
    if typed is not None:
        yield from typed if isinstance(typed, list) else [typed]


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
    parser.set_defaults(command=partial(_run, parser, command))
    return parser


def _run(parser: Parser, command: Command, options: argparse.Namespace) -> None:
    parser.check_files(options)
    command(options)
