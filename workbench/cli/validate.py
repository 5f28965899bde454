"""``freeform validate``."""

import json
from collections.abc import Sequence
from contextlib import closing
from pathlib import Path
from typing import Any

from workbench.analysis.by_cells import ByCells
from workbench.analysis.cross_check import CrossCheck, cross_check
from workbench.analysis.focus import Focus, focus_series, with_screen_at
from workbench.analysis.light_limit import light_limits
from workbench.analysis.making.as_made import checking
from workbench.analysis.making.robust import ExpectedError, expected_error
from workbench.analysis.metrics import relative_l2
from workbench.analysis.validation_figures import MadeStep, Validation
from workbench.arrays import Array
from workbench.cli.output import PartProgress
from workbench.design.session import result_of, verified_error
from workbench.errors import RunFailed
from workbench.extended.bound import Bound
from workbench.files.atomic import check_writable, replacing
from workbench.files.session import read_session
from workbench.progress import finished
from workbench.scene import AnyReceiver, Scene
from workbench.scene.losses import kind_and_element
from workbench.scene.making.uncertainty import Uncertainty


def validate(
    path: Path,
    rays: int,
    screen_z: float | None,
    with_mitsuba: bool,
    distances: Sequence[float],
    plot: Path | None,
    as_json: bool,
) -> None:
    """Check the lens of a session by beam mesh and by random rays, and print the result.

    Raise Refused if the session has no lens, a screen may touch the lens, or is moved although
    there are several images, the plot cannot be written, or Mitsuba is not installed; RunFailed if
    no light reaches the screen, or, after printing, if the two checks contradict each other.
    """
    session = read_session(path)
    result = result_of(session, str(path))
    if screen_z is not None:
        session.scene.check_one_image("--screen-z")
    scene = session.scene if screen_z is None else with_screen_at(session.scene, screen_z)
    task = scene, session.target, result.state.heights, rays
    if plot is not None:
        check_writable(plot)
    with closing(PartProgress("through focus")) as progress:
        series = list(focus_series(*task[:3], distances, rays, progress.show))
    compared = None
    if with_mitsuba:
        with closing(PartProgress("with Mitsuba")) as progress:
            compared = cross_check(*task, progress=progress.show)
    with closing(PartProgress("check")) as progress:
        found = finished(checking(*task), progress.show)
    expected = None
    if scene.uncertainty != Uncertainty():
        expected = expected_error(*task[:3])
    # The optimiser's image is on the receiver of the scene.
    elsewhere = scene.receiver != session.scene.receiver
    own = None if elsewhere else result.state.irradiance
    # The blur of a source through several elements is not known.
    bound = Bound(scene, session.target) if not scene.is_train else None
    limits = light_limits(scene)
    most = ", ".join(f"{limit.percent} %" for limit in limits)
    others = [light.irradiance for light in result.state.further]
    if as_json:
        figures = _figures(found, [own, *others], scene)
        if bound and bound.certified:
            figures["relative_l2_bound"] = bound.relative_l2
        figures["light_limits"] = [limit.to_data() for limit in limits]
        further = {
            "expected": expected and expected.to_data(),
            "cross_check": compared and compared.to_data(),
            "through_focus": [each.to_data() for each in series],
        }
        print(json.dumps(figures | {name: each for name, each in further.items() if each}))
    else:
        _print_images(found, [own, *others], scene)
        if bound and bound.certified:
            print(f"{'bound':<18}{bound.relative_l2:.5f}  (no lens of this size can be below)")
        print(f"{'light, at most':<18}{most}  (with any lens)")
        _print_made(found.steps)
        _print_expected(expected)
        if compared:
            _print_compared(compared)
        if series:
            _print_series(series)
    if plot is not None:
        from workbench.pictures.error_curves import write_focus  # slow import

        with replacing(plot) as file:
            write_focus(file, scene, session.target, series)
    if found.contradiction:
        raise RunFailed(found.contradiction)


_WHERE_LIT = "(least over mean where the target is lit)"


def _figures(found: Validation, lights: Sequence[Array | None], scene: Scene) -> dict[str, Any]:
    figures = found.to_data()
    each = figures, *figures.get("further_images", ())
    for data, image, own, place in zip(each, found.images, lights, scene.receivers, strict=True):
        data["optimiser_difference"] = None if own is None else relative_l2(image.irradiance, own)
        data["optimiser_remark"] = None if own is None else image.beside_run(own, place)
        if image.by_cells and own is not None:
            apart = relative_l2(image.by_cells.irradiance, own)
            data["deterministic"]["optimiser_difference"] = apart
    return figures


def _print_images(found: Validation, lights: Sequence[Array | None], scene: Scene) -> None:
    images = zip(found.images, lights, scene.receivers, strict=True)
    for number, (image, light, receiver) in enumerate(images, start=1):
        if found.further:
            print(f"{chr(10) * (number > 1)}Image {number}")
        print_image(image, light, receiver)


def print_image(found: Validation, own: Array | None, receiver: AnyReceiver) -> None:
    """Print the check of an image, and its difference to the optimiser's ``own``."""
    if found.by_cells:
        _print_cells(found.by_cells, own, receiver.place)
    if found.left_out:
        print(f"Without a deterministic figure: {found.left_out}")
    _print(found, None if own is None else relative_l2(found.irradiance, own))
    if own is not None and (remark := found.beside_run(own, receiver)):
        print(f"Note: {remark}")


def _print_cells(found: ByCells, own: Array | None, place: str) -> None:
    difference = None if own is None else relative_l2(found.irradiance, own)
    for name, value in (
        ("verified error", _error(found, "relative L2, ")),
        ("by", "; ".join(filter(None, (found.way, found.less_exact)))),
        ("loss", f"{found.loss:.4g}" if found.relative_l2_corrected > 0 else "-"),
        ("optimiser's image", _or_dash(difference, ".5f", "  (relative L2 difference to it)")),
        (place, f"{found.efficiency:.5f}"),
    ):
        print(f"{name:<18}{value}")
    print("\nSecond opinion: random rays")
    times = _or_dash(found.difference_over_noise, ".2f", " times their noise")
    print(
        f"{'off the cells':<18}{found.difference:.5f}  ({times}; without it "
        f"{_interval(found.unscattered.interval)})"
    )


def _print(found: Validation, difference: float | None) -> None:
    quality = found.quality
    lines = {
        "relative L2": f"{found.relative_l2:.5f}  (noise {found.noise:.1g}, "
        f"95 % {_interval(found.relative_l2_interval)})",
        "without ray noise": _error(found, "95 % "),
        "loss": f"{found.loss:.4g}",
        "PSNR": _or_dash(quality.psnr, ".2f", " dB"),
        "SSIM": f"{quality.ssim:.5f}",
        "correlation": _or_dash(quality.correlation, ".5f"),
        **({} if found.lit_area else {"uniformity": f"{quality.uniformity:.5f}  {_WHERE_LIT}"}),
        "contrast": _or_dash(quality.contrast, ".5f"),
        "optimiser's image": _or_dash(difference, ".5f", "  (relative L2 difference to it)"),
        **(found.shading.figures if found.shading else {}),
        "rays": str(found.rays),
        **{
            _called(part): f"{flux:.5f}"
            for part, flux in (found.by_cells or found).account.to_data().items()
        },
    }
    for name, value in lines.items():
        print(f"{name:<18}{value}" if len(name) < 18 else f"{name}: {value}")
    for light in found.areas:  # regions may share a name
        print(f"{light.name}: {light.words}")


def _called(part: str) -> str:
    """What a part of the account is called in the table."""
    kind, element = kind_and_element(part)
    words = kind.replace("_", " ")
    return f"{words} ({element})" if element else words


def _error(found: ByCells | Validation, of_what: str) -> str:
    interval = _interval(found.relative_l2_corrected_interval)
    return f"{verified_error(found, '{:.5f}'.format)}  ({of_what}{interval})"


def _print_compared(found: CrossCheck) -> None:
    print(f"\nMitsuba 3, with {found.rays} rays for it and for the check")
    for name, value in (
        ("difference", f"{found.difference:.5f}  ({found.noise:.5f} by ray noise alone)"),
        (
            "without ray noise",
            f"{found.difference_corrected:.5f}  "
            f"(95 % {_interval(found.difference_corrected_interval)})",
        ),
    ):
        print(f"{name:<18}{value}")
    print(f"{'':18}{'check':10}Mitsuba")
    for name, ours, theirs in (
        ("relative L2", found.ours.relative_l2, found.mitsuba.relative_l2),
        (
            "without ray noise",
            found.ours.relative_l2_corrected,
            found.mitsuba.relative_l2_corrected,
        ),
        ("efficiency", found.ours.efficiency, found.mitsuba.efficiency),
    ):
        print(f"{name:<18}{ours:<10.5f}{theirs:.5f}")
    if found.left_out:
        print(f"{'left out of both':<18}{', '.join(found.left_out)}")


def _print_expected(found: ExpectedError | None) -> None:
    if found is not None:
        print(
            f"\n{'mean error':<18}{found.mean:.5f}  (over {found.cases} set-ups, as a run sees "
            f"them; exact {found.exact:.5f}, worst {found.worst:.5f})"
        )


def _print_made(steps: Sequence[MadeStep]) -> None:
    if steps:
        print("\nError as designed, and after each process")
    for step in steps:
        share = f"{step.change:+.5f}; " if step.title else ""
        title = step.title or "as designed"
        print(f"{title:<18}{step.error:.5f}  ({share}95 % {_interval(step.interval)})")


def _print_series(series: Sequence[Focus]) -> None:
    print(f"\n{'screen at z':<18}{'relative L2':<14}efficiency")
    for each in series:
        print(f"{each.z:<18.6g}{each.relative_l2:<14.5f}{each.efficiency:.5f}")


def _interval(ends: tuple[float, float]) -> str:
    return f"{ends[0]:.5f} to {ends[1]:.5f}"


def _or_dash(value: float | None, form: str, tail: str = "") -> str:
    return "-" if value is None else f"{value:{form}}{tail}"
