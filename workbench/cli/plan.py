"""``freeform plan``."""

import json
from contextlib import closing
from dataclasses import replace
from pathlib import Path

from workbench.analysis.making.plan import ShopPlan, planning
from workbench.analysis.making.plan_options import PlanOptions
from workbench.cli.output import PartProgress
from workbench.cutters import cutter_name
from workbench.design.run import Evaluator
from workbench.design.session import Session, result_of
from workbench.files.atomic import check_writable
from workbench.files.session import read_session, write_session
from workbench.powers import written
from workbench.progress import finished


def plan(path: Path, options: PlanOptions, output: Path | None, as_json: bool) -> None:
    """Print plans for the lens of a session, the cheapest first, and write it as made by that.

    Raise Refused if the session has no lens, no plan reaches the wanted error, or the output cannot
    be written.
    """
    session = read_session(path)
    heights = result_of(session, str(path)).state.heights
    if output is not None:
        check_writable(output)
    with closing(PartProgress("plan")) as progress:
        steps = planning(session.scene, session.target, heights, options)
        found = finished(steps, progress.show)
    if as_json:
        data = {"unit": session.scene.unit, "designed": found.designed, "wanted": found.wanted}
        print(json.dumps(data | {"plans": [each.to_data() for each in found.plans]}))
    else:
        unit = session.scene.unit
        print(f"error as designed {100 * found.designed:.2f} %, wanted {100 * found.wanted:.2f} %")
        radius = found.plans[0].milling.ball_radius
        name = cutter_name(radius, unit)
        standard = f"standard cutter of {name}" if name else "no standard cutter"
        print(f"ball radius       {written(radius, unit)} ({standard})")
        print(f"\n{'step-over':<14}{'scallop':<14}{'polish over':<14}{'error as made':<16}minutes")
        for each in found.plans:
            _print(each, unit)
        print("\nThe error of the first plan is verified by random rays; the others are estimates.")
    if output is not None:
        write_session(_made_so(session, found.plans[0]), output)


def _print(plan: ShopPlan, unit: str) -> None:
    polish = "-" if plan.polishing is None else written(plan.polishing.width, unit)
    print(
        f"{written(plan.milling.step_over, unit):<14}{written(plan.milling.scallop, unit, 2):<14}"
        f"{polish:<14}{f'{100 * plan.error:.2f} %':<16}{plan.minutes:.0f} "
        f"({plan.milling_minutes:.0f} + {plan.polishing_minutes:.0f})"
    )


def _made_so(session: Session, plan: ShopPlan) -> Session:
    """The session whose lens is made by a plan, with its light as made."""
    result = result_of(session)
    scene = session.scene.altered(processes=plan.processes)
    seen = Evaluator(scene, session.target, result.state.heights).snapshot(result.state.heights)
    return replace(session, scene=scene, result=replace(result, state=seen.state))
