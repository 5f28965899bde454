"""``freeform bound``: a file of its own, since `validate` takes seconds to import."""

import json
import sys
from pathlib import Path

from workbench.extended.bound import Bound
from workbench.files.session import open_design
from workbench.process import keep_freed_memory


def bound(path: Path, as_json: bool) -> None:
    """Print the lower bound of the error for a scene; raise Refused if it cannot be read."""
    keep_freed_memory()  # a search makes the same arrays over and over
    session = open_design(path)
    for remark in session.picture_remarks:
        print(remark, file=sys.stderr)
    session.scene.check_one_image("the bound")
    found = Bound(session.scene, session.target)
    if as_json:
        print(json.dumps(found.to_data()))
        return
    for sentence in found.sentences:
        print(sentence)
    print("\nAssumptions")
    for assumption in found.assumptions:
        print(f"  {assumption}")
