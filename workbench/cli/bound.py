"""``freeform bound``: a file of its own, since `validate` takes seconds to import."""

import json
import sys
from pathlib import Path

from workbench.analysis.light_limit import light_limits
from workbench.extended.bound import Bound
from workbench.files.session import open_design
from workbench.process import keep_freed_memory


def bound(path: Path, as_json: bool) -> None:
    """Print the bounds of error and light for a scene; raise Refused if it cannot be read."""
    keep_freed_memory()  # a search makes the same arrays over and over
    session = open_design(path)
    for remark in session.picture_remarks:
        print(remark, file=sys.stderr)
    scene = session.scene
    found, limits = Bound(scene, session.target), light_limits(scene)
    if as_json:
        light = [limit.to_data() for limit in limits]
        print(json.dumps(found.to_data() | {"light_limits": light}))
        return
    for number, (limit, receiver) in enumerate(zip(limits, scene.receivers, strict=True), start=1):
        print(f"Image {number}: " * (len(limits) > 1) + limit.sentence(scene, receiver))
    for sentence in found.sentences:
        print(sentence)
    print("\nAssumptions")
    for assumption in found.assumptions:
        print(f"  {assumption}")
