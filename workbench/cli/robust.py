"""``freeform robust``."""

import json
from collections.abc import Sequence
from contextlib import closing
from pathlib import Path

from workbench.analysis.making.robust import Compromise, compromising
from workbench.cli.output import PartProgress
from workbench.files.atomic import check_writable, make_folder, replacing
from workbench.files.session import open_design, write_session
from workbench.progress import finished


def robust(
    path: Path,
    shares: Sequence[float],
    iterations: int | None,
    folder: Path | None,
    plot: Path | None,
    as_json: bool,
) -> None:
    """Design lenses for parts of the uncertainty of a scene, and print their errors.

    Raise Refused if nothing is uncertain, the scene cannot be run, or a file cannot be written.
    """
    session = open_design(path)
    if plot is not None:
        check_writable(plot)
    if folder is not None:
        make_folder(folder)
    with closing(PartProgress("robust")) as progress:
        found = finished(compromising(session, shares, iterations), progress.show)
    if folder is not None:
        for each in found:
            write_session(each.session, folder / f"{path.stem}-{100 * each.share:g}.freeform")
    if plot is not None:
        from workbench.pictures.error_curves import write_compromises  # slow import

        with replacing(plot) as file:
            write_compromises(file, found)
    if as_json:
        print(json.dumps({"designs": [each.to_data() for each in found]}))
    else:
        _print(found)


def _print(found: Sequence[Compromise]) -> None:
    print(f"Relative L2 errors over {found[0].error.cases} set-ups, as a run sees them")
    print(f"{'uncertainty known':<20}{'exact':<10}{'mean':<10}worst")
    for each in found:
        error, share = each.error, f"{100 * each.share:g} %"
        print(f"{share:<20}{error.exact:<10.5f}{error.mean:<10.5f}{error.worst:.5f}")
