"""Commands on scenes (design, bound, sweep, benchmark): arguments and examples.

Commands are imported when they run, so that help and refusals are quick. The meaning of an argument
is documented here and not again with the function that it is for.
"""

import argparse
import math
import time
from contextlib import suppress
from pathlib import Path
from typing import Any

from workbench.analysis.benchmark.names import (
    BENCHMARKS,
    DEFAULT,
    WITH_CURVES,
    WITH_PICTURES,
    Settings,
)
from workbench.cli.parser import add_json, add_plot, add_verb, count, positive, rays


def add_design(commands: Any) -> None:
    """Add ``freeform design``."""
    parser = add_verb(
        commands,
        "design",
        "Design a lens. Ctrl-C keeps the best lens so far.",
        [
            "design flame.json -o flame.freeform",
            "design flame.freeform -o finer.freeform --seconds 60",
            "design flame.json -o flame.freeform --video flame.gif",
            "design face.json -o face.freeform --set images[0].target.black=0.1",
        ],
        _run_design,
    )
    parser.add_input(
        "scene",
        role="the scene",
        metavar="SCENE",
        help="scene file, or session; one with a lens goes on from it",
    )
    parser.add_output(
        "-o",
        dest="output",
        may_replace=_may_replace,
        metavar="OUT.freeform",
        required=True,
        help="session to write",
    )
    parser.add_argument(
        "--iterations", metavar="N", type=int, help="upper limit, in place of the scene's"
    )
    parser.add_argument(
        "--seconds", metavar="S", type=positive, default=math.inf, help="stop after this time"
    )
    parser.add_argument(
        "--set",
        metavar="FIELD=VALUE",
        action="append",
        default=[],
        help="value of a field in place of the scene's, by its path as in --vary of a sweep: "
        "a number, AxB for several, true, false or text; may be given several times",
    )
    parser.add_argument(
        "--made-by",
        metavar="PRESET",
        nargs="+",
        default=[],
        help="processes of manufacture in place of the scene's, such as mill-3mm polish",
    )
    parser.add_output(
        "--video",
        metavar="FILE",
        help="write the image of each iteration as an animated .gif, .webp or .apng",
    )
    add_json(parser)


# A session may be replaced by a lens that continues its own.
def _may_replace(path: Path) -> bool:
    from workbench.files.session import is_session

    return is_session(path)


def _run_design(options: argparse.Namespace) -> None:
    begun = time.perf_counter()  # the imports below take seconds
    from workbench.cli.design import design
    from workbench.sweep.points import parse_setting

    deadline = begun + options.seconds
    changes = dict(map(parse_setting, options.set))
    scene, output, video = options.scene, options.output, options.video
    made_by, as_json = options.made_by, options.json
    design(scene, changes, made_by, output, options.iterations, deadline, as_json, video)


def add_bound(commands: Any) -> None:
    """Add ``freeform bound``."""
    parser = add_verb(
        commands,
        "bound",
        "Compute the least relative L2 error that any lens of a scene can reach, as the size of "
        "its source blurs the image, and how much of the light can be used. Nothing is designed.",
        ["bound sun.json", "bound flame.freeform --json"],
        _run_bound,
    )
    parser.add_input("scene", role="the scene", metavar="SCENE", help="scene file, or session")
    add_json(parser)


def _run_bound(options: argparse.Namespace) -> None:
    from workbench.cli.bound import bound

    bound(options.scene, options.json)


def add_robust(commands: Any) -> None:
    """Add ``freeform robust``."""
    parser = add_verb(
        commands,
        "robust",
        "Design a lens for each part of the scene's uncertainty, and show what the exact set-up "
        "loses and the mean over all set-ups gains.",
        [
            "robust street.json --plot compromise.png",
            "robust street.json --shares 0 0.5 1 --iterations 50 -o designs/",
        ],
        _run_robust,
    )
    parser.add_input(
        "scene", role="the scene", metavar="SCENE", help="scene file, or session to start from"
    )
    parser.add_argument(
        "--shares",
        metavar="PART",
        nargs="+",
        type=_share,
        help="parts of the standard deviations that designs know; 0 is the exact set-up "
        "[0 0.25 0.5 1]",
    )
    parser.add_argument(
        "--iterations", metavar="N", type=int, help="upper limit of each, in place of the scene's"
    )
    parser.add_output("-o", dest="folder", metavar="FOLDER", help="where the sessions go")
    add_plot(parser, "draw the mean error against that in the exact set-up")
    add_json(parser)


def _share(text: str) -> float:
    with suppress(ValueError):
        if 0 <= (number := float(text)) <= 1:
            return number
    raise argparse.ArgumentTypeError(f"{text!r}; a number from 0 to 1 is needed")


def _run_robust(options: argparse.Namespace) -> None:
    from workbench.cli.robust import robust
    from workbench.scene.making.uncertainty import SHARES

    robust(
        options.scene,
        options.shares or SHARES,
        options.iterations,
        options.folder,
        options.plot,
        options.json,
    )


def add_sweep(commands: Any) -> None:
    """Add ``freeform sweep``."""
    parser = add_verb(
        commands,
        "sweep",
        "Design a lens for each scene and each combination of values, check each, and write all "
        "sessions and a table (CSV and JSON). What is finished is not done again when the same "
        "command is typed once more. Ctrl-C keeps what is finished.\n\n"
        "values:\n"
        "  1,2.5,3      numbers\n"
        "  0..4         whole numbers, both ends included\n"
        "  64x48,128    pairs; 128 alone is 128x128\n"
        "  auto,paper   text",
        [
            "sweep flame.json --vary lens.back.control_points=64,128 --vary run.seed=0..4",
            "sweep flame.json ball.json -o both/ --jobs 2",
            "sweep flame.json --vary source.position[2]=-5,-8 --dask tcp://host:8786",
        ],
        _run_sweep,
    )
    parser.add_input(
        "scenes",
        role="a scene of the sweep",
        metavar="SCENE",
        nargs="+",
        help="scene file, or session; designed anew",
    )
    parser.add_argument(
        "--vary",
        metavar="FIELD=VALUES",
        action="append",
        default=[],
        help="values of a field of the scene, by its path: run.seed, or of an element by its name, "
        "lens.thickness, and of its front or back face, lens.back.degree; may be given several "
        "times",
    )
    parser.add_output(
        "-o",
        dest="output",
        files=_sweep_files,
        metavar="FOLDER",
        default=Path("sweep"),
        help="where sessions and table go; default %(default)s",
    )
    parser.add_argument(
        "--jobs", metavar="N", type=count, help="lenses at the same time; default one for each core"
    )
    parser.add_argument(
        "--dask", metavar="ADDRESS", help="work on a dask.distributed cluster instead"
    )
    parser.add_argument(
        "--validate-rays",
        metavar="N",
        type=rays,
        default=4_000_000,
        help="of the check of each lens, at least; default %(default)s",
    )
    add_json(parser)


def _sweep_files(folder: Path) -> list[Path]:
    from workbench.sweep.sweep import TABLES

    return [folder / name for name in TABLES]


def _run_sweep(options: argparse.Namespace) -> None:
    from workbench.cli.sweep import sweep

    sweep(
        options.scenes,
        options.vary,
        options.output,
        options.jobs,
        options.dask,
        options.validate_rays,
        options.json,
    )


def add_benchmark(commands: Any) -> None:
    """Add ``freeform benchmark``."""
    names = "\n".join(f"  {name:<11}{does}" for name, does in BENCHMARKS.items())
    parser = add_verb(
        commands,
        "benchmark",
        f"Measure run time against error. Ctrl-C keeps what is finished.\n\nbenchmarks:\n{names}",
        [
            "benchmark",
            "benchmark pictures --pixels 512 --only camera hello",
            "benchmark frontier --output new/ --against old/frontier.json",
            "benchmark frontier --output both/ --result new.json --against old.json",
        ],
        _run_benchmark,
    )
    parser.add_argument(
        "names", metavar="NAME", nargs="*", help=f"what to measure; default {DEFAULT}"
    )
    parser.add_output(
        "--output",
        metavar="FOLDER",
        default=Path("benchmark"),
        files=lambda folder: [folder / f"{name}.json" for name in WITH_CURVES],
        help="where tables and pictures go; default %(default)s",
    )
    parser.add_argument(
        "--iterations", metavar="N", type=count, help="of every design, in place of its own"
    )
    parser.add_argument(
        "--pixels",
        metavar="N",
        type=int,
        choices=(256, 512, 1024),
        help=f"pixels a side of {WITH_PICTURES}: 256, 512 or 1024; default 256",
    )
    parser.add_argument(
        "--only",
        metavar="PICTURE",
        nargs="+",
        default=(),
        help=f"some of {WITH_PICTURES}, such as camera hello",
    )
    parser.add_input(
        "--against",
        role="the earlier result",
        metavar="FILE.json",
        help=f"earlier result, drawn beside the new one; for {', '.join(WITH_CURVES)}",
    )
    parser.add_input(
        "--result",
        role="the result",
        metavar="FILE.json",
        help="finished result, whose picture is drawn again; nothing is measured",
    )
    add_json(parser)


def _run_benchmark(options: argparse.Namespace) -> None:
    from workbench.cli.benchmark import benchmark, draw_result

    names = options.names or [DEFAULT]
    if options.result is not None:
        for name in names:
            draw_result(name, options.result, options.output, options.against)
        return
    settings = Settings(options.iterations, options.pixels, tuple(options.only))
    benchmark(names, options.output, settings, options.against, options.json)
