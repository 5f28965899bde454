"""``freeform tolerances``."""

import json
import sys
from pathlib import Path

from workbench.analysis.tolerance_fields import ABOUT, Tolerances
from workbench.analysis.tolerances import Distribution, Perturbed, perturbed
from workbench.cli.interruption import EndedBySignal, number_of
from workbench.design.session import result_of
from workbench.errors import Refused
from workbench.files.atomic import check_writable, replacing
from workbench.files.session import read_session


def tolerances(
    path: Path, within: Tolerances, samples: int, rays: int, plot: Path | None, as_json: bool
) -> None:
    """Perturb the lens of a session at random and print the distribution of its error.

    Raise Refused if the session has no lens, a tolerance is not possible or the plot cannot be
    written; RunFailed if no light of the nominal lens reaches the receiver; KeyboardInterrupt after
    Ctrl-C, with the finished lenses printed.
    """
    if not within.any:
        names = [f"--{name.replace('_', '-')}" for name in ABOUT]
        raise Refused("usage", f"nothing is off; give {', '.join(names[:-1])} or {names[-1]}")
    session = read_session(path)
    result = result_of(session, str(path))
    if plot is not None:
        check_writable(plot)
    found: list[Perturbed] = []
    stop = None
    try:
        for each in perturbed(
            session.scene, session.target, result.state.heights, within, samples, rays
        ):
            found.append(each)
            _print_progress(len(found) - 1, samples)
    except KeyboardInterrupt as error:
        stop = error
    _clear_line()
    if len(found) > 1:
        nominal, *others = found
        _report(nominal, others, as_json)
        if plot is not None:
            _write(plot, nominal, others)
    if stop:
        traced = max(len(found) - 1, 0)
        raise EndedBySignal(
            number_of(stop), f"interrupted; {traced} of {samples} lenses were traced"
        )


def _report(nominal: Perturbed, others: list[Perturbed], as_json: bool) -> None:
    spread = Distribution.of(nominal, others)
    if as_json:
        samples = [each.to_data() for each in others]
        print(json.dumps(spread.to_data() | {"samples": samples}))
        return
    print("relative L2 without ray noise")
    for name, error in (
        ("as designed", spread.nominal),
        ("mean", spread.mean),
        *((f"{part} % of lenses", error) for part, error in spread.percentiles.items()),
        ("worst", spread.worst),
    ):
        print(f"{name:<18}{error:.5f}")
    print(f"{'lenses':<18}{len(others)}")


def _write(plot: Path, nominal: Perturbed, others: list[Perturbed]) -> None:
    from workbench.pictures.error_curves import write_errors  # slow import

    with replacing(plot) as file:
        write_errors(file, nominal.relative_l2, [each.relative_l2 for each in others])


def _print_progress(done: int, samples: int) -> None:
    if sys.stderr.isatty():
        print(f"\r\x1b[K{done}/{samples} lenses", end="", file=sys.stderr, flush=True)


def _clear_line() -> None:
    if sys.stderr.isatty():
        print("\r\x1b[K", end="", file=sys.stderr, flush=True)
