import io
from pathlib import Path

import pytest
from PIL import Image

from workbench.design.run import run
from workbench.design.snapshot import History
from workbench.files.session import Session
from workbench.pictures import PICTURES
from workbench.targets import load_target


@pytest.fixture
def session(make_scene):
    scene = make_scene({"run.iterations": 2})
    target = load_target(scene, Path.cwd())
    history = History()
    for snapshot in run(scene, target):
        history.add(snapshot)
    return Session(scene, target, history.result())


def test_each_picture_shows_something(session):
    assert list(PICTURES) == ["irradiance.png", "lens.png", "loss.png"]
    for write in PICTURES.values():
        png = io.BytesIO()
        write(session, png)
        with Image.open(png, formats=["PNG"]) as picture:
            low, high = picture.convert("L").getextrema()
            assert low < 60 and high > 200
