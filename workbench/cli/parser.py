"""Argument parser with one-line errors, checks of files, kinds of values, and shared arguments."""

import argparse
import math
import re
import shutil
import textwrap
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple, NoReturn

from workbench.analysis.tolerance_fields import ABOUT, PAIRS, Tolerances
from workbench.analysis.tracing import MOST_RAYS
from workbench.errors import Refused
from workbench.option_groups import OptionGroup

_MOST_DISTANCES = 1000
_MOST_STOPS = 20.0
_LARGEST_EXACT = 2.0**53  # above it, float64 skips integers
Command = Callable[[argparse.Namespace], None]
_WIDEST, _INDENT = 96, 26

_ROLES = {"image": "target image", "heights": "file of control heights"}
"""What files that a scene names are called, by the names of their fields."""


class Input(NamedTuple):
    """A file that a command reads, with those it refers to, and its name in messages."""

    path: Path
    role: str


class Output(NamedTuple):
    """A file that a command writes; ``may_replace`` says whether it may replace an input."""

    path: Path
    may_replace: Callable[[Path], bool]


def check_distinct(inputs: Sequence[Input], outputs: Sequence[Output]) -> None:
    """Raise Refused if a command would overwrite an input or write a file twice.

    Links, and names that differ in case only, count as the file that they name.
    """
    if not outputs:
        return
    from workbench.files.references import is_one_file, named_twice  # slow import

    for path, role in inputs:
        for output in outputs:
            if is_one_file(output.path, path) and not output.may_replace(path):
                raise Refused(str(output.path), f"is {role} itself; another file is needed")
    if twice := named_twice(output.path for output in outputs):
        raise Refused(str(twice), "is named twice; each file is written once")
    # A missing file cannot be one that an input refers to.
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
    except Refused:  # the command reads the same file and reports it
        return ()


def positive(text: str) -> float:
    """Parse a number greater than 0; may be infinite."""
    with suppress(ValueError):
        if (number := float(text)) > 0:
            return number
    raise argparse.ArgumentTypeError(f"{text!r}; a number greater than 0 is needed")


def length(text: str) -> float:
    """Parse a finite number greater than 0."""
    number = positive(text)
    if math.isinf(number):
        raise argparse.ArgumentTypeError(f"{text!r}; a finite number is needed")
    return number


def stops(text: str) -> float:
    """Parse an exposure in powers of two."""
    with suppress(ValueError):
        if abs(number := float(text)) <= _MOST_STOPS:
            return number
    most = _MOST_STOPS
    raise argparse.ArgumentTypeError(f"{text!r}; a number from {-most:g} to {most:g} is needed")


def count(text: str) -> int:
    """Parse an integer greater than 0; also 1e6 and 16e6."""
    with suppress(ValueError):
        if (number := int(text)) > 0:
            return number
    with suppress(ValueError):
        if (written := float(text)).is_integer() and 0 < written <= _LARGEST_EXACT:
            return int(written)
    raise argparse.ArgumentTypeError(f"{text!r}; a whole number greater than 0 is needed")


def rays(text: str) -> int:
    """Parse a number of rays of a check."""
    number = count(text)
    if number > MOST_RAYS:
        raise argparse.ArgumentTypeError(f"{text!r} are too many; at most {MOST_RAYS}")
    return number


def distances(text: str) -> tuple[float, ...]:
    """Parse equal steps: ``first:last:number``."""
    with suppress(ValueError):
        first, last, number = text.split(":")
        low, high, steps = float(first), float(last), int(number)
        if math.isfinite(high - low) and high > low and 2 <= steps <= _MOST_DISTANCES:
            return tuple(low + (high - low) * step / (steps - 1) for step in range(steps))
    raise argparse.ArgumentTypeError(
        f"{text!r}; first:last:number is needed, as in 4:6:9, with 2 to {_MOST_DISTANCES} of them"
    )


def place(text: str) -> tuple[float, float]:
    """Parse a place in a picture: ``column,row``."""
    with suppress(ValueError):
        x, y = map(float, text.split(","))
        return x, y
    raise argparse.ArgumentTypeError(f"{text!r}; column,row is needed, as in 210,95")


class _Written(NamedTuple):
    dest: str
    files: Callable[[Path], Sequence[Path]]
    may_replace: Callable[[Path], bool]


class Parser(argparse.ArgumentParser):
    """Parser with one-line errors and no abbreviations.

    Each file is declared as input or output, so that no command overwrites its inputs.
    """

    def __init__(self, **settings: Any) -> None:
        super().__init__(**settings, allow_abbrev=False, formatter_class=_Help)
        self._read: list[tuple[str, str]] = []  # arguments and the names of their files in messages
        self._written: list[_Written] = []

    def add_argument(self, *names: str, **settings: Any) -> argparse.Action:
        """Add an argument that is no file."""
        if settings.get("type") is Path:
            raise TypeError(f"{names[0]}: files are added as inputs or outputs")
        return super().add_argument(*names, **settings)

    def add_input(self, *names: str, role: str, **settings: Any) -> None:
        """Add a file that is read; ``role`` is its name in messages."""
        action = super().add_argument(*names, type=Path, **settings)
        self._read.append((action.dest, role))

    def add_output(
        self,
        *names: str,
        files: Callable[[Path], Sequence[Path]] = lambda path: (path,),
        may_replace: Callable[[Path], bool] = lambda path: False,
        **settings: Any,
    ) -> None:
        """Add a file that is written, or a folder.

        ``files`` gives the written files for what was typed, by default that itself;
        ``may_replace`` says which input it may replace, by default none.
        """
        action = super().add_argument(*names, type=Path, **settings)
        self._written.append(_Written(action.dest, files, may_replace))

    def check_files(self, options: argparse.Namespace) -> None:
        """Raise Refused if a file is input and output, or output twice."""
        inputs = [Input(path, role) for dest, role in self._read for path in _paths(options, dest)]
        outputs = [
            Output(path, may_replace)
            for dest, files, may_replace in self._written
            for typed in _paths(options, dest)
            for path in files(typed)
        ]
        check_distinct(inputs, outputs)

    def error(self, message: str) -> NoReturn:
        """Raise Refused."""
        raise Refused("usage", f"{message}; {self.prog} --help explains its arguments")


def _paths(options: argparse.Namespace, dest: str) -> Iterator[Path]:
    typed = getattr(options, dest)
    if typed is not None:
        yield from typed if isinstance(typed, list) else [typed]


class _Help(argparse.RawDescriptionHelpFormatter):
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
    if named := re.match(r"  \S+ {2,}", line):
        return named.end()
    return 6 if line.startswith(" ") else 0


def add_verb(
    commands: Any, name: str, description: str, examples: Sequence[str], command: Command
) -> Parser:
    """Add a command with its description and examples, and return its parser."""
    parser: Parser = commands.add_parser(
        name,
        description=description,
        epilog="\n".join(["examples:", *(f"  freeform {line}" for line in examples)]),
    )
    parser.set_defaults(command=partial(_run_command, parser, command))
    return parser


def _run_command(parser: Parser, command: Command, options: argparse.Namespace) -> None:
    parser.check_files(options)
    command(options)


def add_session(parser: Parser) -> None:
    """Add the session with the lens."""
    parser.add_input("session", role="the session", metavar="SESSION", help="session with a lens")


def add_plot(parser: Parser, does: str) -> None:
    """Add a picture to draw."""
    parser.add_output("--plot", metavar="FILE.png", help=does)


def add_json(parser: argparse.ArgumentParser) -> None:
    """Add the option for JSON."""
    parser.add_argument("--json", action="store_true", help="print the figures as one JSON object")


def add_other(parser: argparse.ArgumentParser) -> None:
    """Add the option for Mitsuba."""
    parser.add_argument(
        "--with",
        dest="other",
        choices=["mitsuba"],
        help="have Mitsuba 3 trace the lens too (optional extra)",
    )


def add_options(
    parser: argparse.ArgumentParser, group: type[OptionGroup], hidden: bool = False
) -> None:
    """Add an argument for each option of a group; the group itself checks the values.

    ``hidden`` arguments are not in the help; see `add_hidden_options`.
    """
    listed, usual = parser.add_argument_group(None if hidden else group.called), group()
    for name, about in group.about():
        flag = f"--{name.replace('_', '-')}"
        tip = about.tip.rstrip(".").replace("Empty: ", "Default: ")
        tip = tip[0].lower() + tip[1:]
        if about.kind is bool:
            shown = argparse.SUPPRESS if hidden else tip
            listed.add_argument(flag, action="store_true", help=shown)
            continue
        value = getattr(usual, name)
        choices = f"; {', '.join(about.choices)}" if about.choices else ""
        default = "" if value is None else f" [{value if about.choices else format(value, 'g')}]"
        text = f"{tip}{choices}{default}".replace("%", "%%")
        listed.add_argument(
            flag,
            metavar=about.unit.upper() or ("NAME" if about.choices else "N"),
            type=about.kind,
            choices=list(about.choices) or None,
            help=argparse.SUPPRESS if hidden else text,
        )


def add_hidden_options(
    parser: argparse.ArgumentParser, groups: Sequence[type[OptionGroup]], flag: str
) -> None:
    """Add the options of several groups, and a flag that lists them and ends the command."""
    for group in groups:
        add_options(parser, group, hidden=True)
    names = ", ".join(group.called for group in groups)
    parser.add_argument(
        flag, action=_ListOptions, groups=groups, help=f"list the options of {names}, and exit"
    )


class _ListOptions(argparse.Action):
    def __init__(self, groups: Sequence[type[OptionGroup]], **settings: Any) -> None:
        super().__init__(nargs=0, default=argparse.SUPPRESS, **settings)
        self._groups = groups

    def __call__(self, parser: argparse.ArgumentParser, *_: Any) -> NoReturn:
        listed = Parser(prog=parser.prog, usage=argparse.SUPPRESS, add_help=False)
        for group in self._groups:
            add_options(listed, group)
        print(listed.format_help(), end="")
        parser.exit()


def add_tolerance_sizes(parser: argparse.ArgumentParser) -> None:
    """Add an argument for each tolerance."""
    for name, about in ABOUT.items():
        metavar = about.unit.upper() or "N"
        pair = name in PAIRS
        parser.add_argument(
            f"--{name.replace('_', '-')}",
            metavar=("RMS", "SCALE") if pair else metavar,
            type=float,
            nargs=2 if pair else None,
            default=(0.0, 1.0) if pair else 0.0,
            help=about.tip[0].lower() + about.tip_of("lens or mirror")[1:],
        )


def tolerances_of(options: argparse.Namespace) -> Tolerances:
    """Return the tolerances of parsed arguments."""
    return Tolerances.of(vars(options))
