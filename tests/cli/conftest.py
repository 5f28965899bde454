import json
import logging
import math

import numpy as np
import pytest

from tests.accounts import account_of, result_of
from workbench.cli import main
from workbench.design.lens_state import LensState
from workbench.design.snapshot import Snapshot
from workbench.files.session import Session, write_session
from workbench.geometry.faces import FaceArrays


@pytest.fixture(autouse=True)
def signals(usual_signals):
    """Commands are ended by signals here, also where tests run in the background."""


@pytest.fixture
def scene_file(tmp_path, scene_data):
    path = tmp_path / "scene.json"
    path.write_text(json.dumps(scene_data))
    return path


@pytest.fixture
def out(tmp_path):
    return tmp_path / "lens.freeform"


@pytest.fixture
def lens(make_scene, tmp_path):
    """A session with a flat lens."""
    path = tmp_path / "lens.freeform"
    result = result_of(np.full((12, 10), 0.5))
    write_session(Session(make_scene(), np.ones((32, 32)), result), path)
    return path


@pytest.fixture
def freeform(capsys, monkeypatch):
    """Runs a command; gives exit status, standard output and error.

    Slow machines get no lines of progress that quick ones do not, nor ones of compiling.
    """
    monkeypatch.setattr("workbench.cli.output._LINES", math.inf)
    monkeypatch.setattr(logging.getLogger("workbench.compiled"), "disabled", True)

    def run(*arguments):
        status = main([str(argument) for argument in arguments])
        return status, *capsys.readouterr()

    return run


@pytest.fixture
def fake_run(monkeypatch, rng):
    """Puts a run in place: a second each iteration, loss 1/(i+1), before it ``events[i]()``."""

    def put(events, seconds=float):
        def run(scene, target, start=None, locked=None):
            n_x, n_y = scene.receiver.pixels
            for i in range(scene.run.iterations + 1):
                if i in events:
                    events[i]()
                yield Snapshot(
                    LensState(
                        loss=1 / (i + 1),
                        heights=FaceArrays({"lens.back": rng.random(scene.optic.net_shape)}),
                        irradiance=rng.random((n_y, n_x)),
                        account=account_of(1.0, 0.9, 0.0, 0.0, 0.0, 0.0, 0.04, 0.06),
                    ),
                    iteration=i,
                    iterations=scene.run.iterations,
                    seconds=seconds(i),
                    merit=1 / (i + 1),
                    best=True,
                )
            return "all iterations are done"

        monkeypatch.setattr("workbench.design.run.run", run)

    return put
