"""``freeform design``."""

import json
import math
import sys
import time
from collections.abc import Mapping, Sequence
from contextlib import closing
from dataclasses import replace
from pathlib import Path
from typing import Any

from workbench.cli.checkpoints import CheckpointWriter
from workbench.cli.interruption import EndedBySignal, Interruption
from workbench.cli.output import Progress
from workbench.design.design_run import DesignRun
from workbench.design.session import Session
from workbench.design.snapshot import Result, Snapshot
from workbench.design.task import why_light_is_not_kept, why_not_kept, with_task
from workbench.files.atomic import check_writable, replacing
from workbench.files.figures import Figures
from workbench.files.session import is_session, open_design
from workbench.process import keep_freed_memory
from workbench.progress import given_up_when, interrupted_when
from workbench.scene.making.presets import preset_processes
from workbench.scene.paths import with_values

# From this many pixels on freed memory is returned: a run of 4096 × 4096 takes 3.1 GB, not 5.2.
_MANY = 1 << 22


def design(
    path: Path,
    changes: Mapping[str, Any],
    made_by: Sequence[str],
    output: Path,
    iterations: int | None,
    deadline: float,
    as_json: bool,
    video: Path | None = None,
) -> None:
    """Run a design until a deadline of `time.perf_counter`, and write it however the run ends.

    ``changes`` are values of fields, by path, in place of those of the scene, and ``made_by`` names
    presets in place of its processes. ``video``: file of an
    animated picture of the run.

    Raise Refused if the scene cannot be run or the output not be written (the lens is then kept
    elsewhere), RunFailed if the run cannot go on (the best lens is written), EndedBySignal after a
    signal (the best lens is written).
    """
    session = open_design(path)
    if made_by:
        changes = {**changes, "processes": preset_processes(made_by, session.scene.unit)}
    if changes:
        session = with_task(session, with_values(session.scene, changes), path.parent)
    if _pixels(session) < _MANY:  # gaps of larger arrays would not be reused
        keep_freed_memory()
    if not is_session(path):
        for why in filter(None, map(why_not_kept, session.scene.single, session.pictures)):
            print(why, file=sys.stderr)
    for remark in session.picture_remarks:
        print(remark, file=sys.stderr)
    if not is_session(path) and (why := why_light_is_not_kept(session.scene)):
        print(why, file=sys.stderr)
    run = DesignRun(session, iterations)
    session = run.session
    check_writable(output)
    film = _VideoWriter(session, video)
    checkpoints = CheckpointWriter(output, lambda result: replace(session, result=result))
    _print_abandoned(checkpoints, path)
    with Interruption() as interruption:
        try:
            with (
                interrupted_when(lambda: interruption.asked > 0 or _is_over(deadline)),
                # At least the starting lens is written in any case.
                given_up_when(lambda: _is_over(deadline) and run.history.result() is not None),
                closing(Progress(session.scene, deadline)) as progress,
                closing(iter(run)) as snapshots,
            ):
                for snapshot in snapshots:
                    progress.show(snapshot)
                    film.add(snapshot, run.history.losses().size)
                    checkpoints.write_if_due(run.history)
                    if interruption.asked or _is_over(deadline):
                        break
        finally:
            interruption.settle()
            result = run.history.result()
            if result is not None:
                checkpoints.finish(result)
                film.finish()
    if result is not None:
        _print(result, session.scene.receiver.place, as_json)
        if _is_over(deadline) and not result.iterations:
            print("Not designed yet: give --seconds more time", file=sys.stderr)
        _print_hint(session, result)
        if not as_json and not interruption.asked and not _is_over(deadline):
            _print_bound(session, result)
    if interruption.asked:
        raise EndedBySignal(interruption.asked, f"interrupted; {_what_is_written(result, output)}")


class _VideoWriter:
    """Gathers the images of a run, and writes its video at the end; does nothing without a path."""

    def __init__(self, session: Session, path: Path | None) -> None:
        self._path, self._video = path, None
        if path is not None:
            from workbench.pictures.video import Video, check_video  # slow import

            check_video(path)
            check_writable(path)
            self._video = Video(session.scene, session.target, _caption)

    def add(self, snapshot: Snapshot, iteration: int) -> None:
        if self._video is not None:
            self._video.add(snapshot.state.irradiance, iteration)

    def finish(self) -> None:
        if self._video is not None and self._path is not None:
            with replacing(self._path) as file:
                self._video.write(file, self._path.suffix.lower())


def _caption(iteration: int, error: float) -> str:
    return f"iteration {iteration}, error {100 * error:.2f} %"


def _is_over(deadline: float) -> bool:
    return time.perf_counter() >= deadline


def _print_hint(session: Session, result: Result) -> None:
    from workbench.design.checks import coarse_net  # slow import, not needed for a refusal

    if result.state.shortfall is not None:
        print(result.state.shortfall.at_field(session.scene), file=sys.stderr)
    elif advice := result.state.account.advice(session.scene):
        print(advice, file=sys.stderr)
    elif coarse := coarse_net(session.scene, session.target, result):
        print(coarse.sentence, file=sys.stderr)


def _print_bound(session: Session, result: Result) -> None:
    # Slow imports, not needed for a refusal.
    from workbench.design.loss import relative_error
    from workbench.extended.bound import Bound, percent

    bound = Bound(session.scene, session.target)
    if bound.certified:
        error = relative_error(result.state, session.target)
        print(f"error {percent(error)} as the run sees it; {bound.short}")
    elif result.state.account.advice(session.scene) is None:
        return
    from workbench.analysis.light_limit import light_limits

    for limit, receiver in zip(light_limits(session.scene), session.scene.receivers, strict=True):
        print(limit.sentence(session.scene, receiver))


def _what_is_written(result: Result | None, output: Path) -> str:
    if result is None:
        return "there was no lens yet, and nothing is written"
    lens = "the best lens so far" if result.iterations else "the lens before its first iteration"
    return f"{lens} is in {output}"


def _print_abandoned(checkpoints: CheckpointWriter, path: Path) -> None:
    found = checkpoints.find_abandoned()
    if found is not None and not found.samefile(path):
        print(
            f"{found} is what a run left that was cut off; given as SCENE, it is gone on from",
            file=sys.stderr,
            flush=True,
        )


def _print(result: Result, place: str, as_json: bool) -> None:
    figures = Figures.of(result)
    if as_json:
        left_out = {"stage_starts", "stages_left"}
        if figures.further_images is None:
            left_out.add("further_images")
        print(json.dumps(figures.model_dump(exclude=left_out)))
    else:
        print(
            f"loss {figures.loss:.4g} after {figures.iterations} iterations in "
            f"{figures.seconds:.1f} s; {figures.efficiency:.1%} of the light {place}; "
            f"{result.ended}"
        )


def _pixels(session: Session) -> int:
    return max(math.prod(receiver.pixels) for receiver in session.scene.receivers)
