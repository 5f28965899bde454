import io
from pathlib import Path

from PIL import Image

from workbench.design.run import run
from workbench.design.snapshot import History
from workbench.files.session import Session
from workbench.pictures import PICTURES
from workbench.targets import load_target


def test_each_picture_shows_something(make_scene):
    scene = make_scene({"run.iterations": 2})
    target = load_target(scene, Path.cwd())
    history = History()
    for snapshot in run(scene, target):
        history.add(snapshot)
    session = Session(scene, target, history.result())
    assert list(PICTURES) == ["irradiance.png", "lens.png", "loss.png"]
    for write in PICTURES.values():
        png = io.BytesIO()
        write(session, png)
        with Image.open(png, formats=["PNG"]) as picture:
            low, high = picture.convert("L").getextrema()
            assert low < 60 and high > 200
