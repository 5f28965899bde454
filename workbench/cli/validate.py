"""``freeform validate``."""

import json
from pathlib import Path

from workbench.analysis.validation import validate as trace_anew
from workbench.cli.designed import read_designed


def validate(path: Path, rays: int, as_json: bool) -> None:
    """Trace the lens of a session anew and print what that shows.

    Parameters
    ----------
    path : Path
        Session with a lens.
    rays : int
        Rays to trace at least.
    as_json : bool
        Whether figures are printed as JSON.

    Raises
    ------
    Refused
        If the session cannot be read or holds no lens.
    RunFailed
        If no light reaches the screen.
    """
    session, result = read_designed(path)
    found = trace_anew(session.scene, session.target, result.control_points, rays)
    ledger = found.ledger.to_data()
    if as_json:
        figures = {
            "loss": found.loss,
            "relative_l2": found.relative_l2,
            "efficiency": found.efficiency,
            "ledger": ledger,
            "rays": found.rays,
            "noise": found.noise,
        }
        print(json.dumps(figures))
        return
    print(f"relative L2       {found.relative_l2:.5f}  (noise {found.noise:.1g})")
    print(f"loss              {found.loss:.4g}")
    print(f"rays              {found.rays}")
    for name, value in ledger.items():
        print(f"{name.replace('_', ' '):<18}{value:.5f}")
