"""Makes the target images, the example scenes and the JSON Schema of scenes in this folder.

Run ``python -m resources.make_resources`` after a change to a built-in shape or to the scene, and
commit what changed. The icons are drawn by hand.
"""

import json
import sys
from pathlib import Path

import numpy as np
from PIL import Image

import resources
from workbench.scene import BallTarget, FlameTarget, Scene, Screen, TopHatTarget
from workbench.targets.shapes import draw

SHAPES = {"tophat": TopHatTarget(), "flame": FlameTarget(), "ball": BallTarget()}
SIZES = (256, 512)


def make(folder: Path) -> None:
    """Write everything that is generated below ``folder``."""
    targets, examples = folder / "targets", folder / "examples"
    targets.mkdir(exist_ok=True)
    examples.mkdir(exist_ok=True)
    for name in SHAPES:
        for size in SIZES:
            target_image(name, size).save(targets / f"{name}-{size}.png", optimize=True)
    for name in resources.EXAMPLES:
        (examples / f"{name}.json").write_text(example(name).to_json(), encoding="utf-8")
    (folder / "scene.schema.json").write_text(schema(), encoding="utf-8")


def target_image(name: str, size: int) -> Image.Image:
    """Draw a built-in shape as a square 8-bit grey image of ``size`` pixels a side."""
    screen = Screen(z=1.0, half_width=(1.0, 1.0), pixels=(size, size))
    light = draw(SHAPES[name], screen, 1.0)
    return Image.fromarray(np.rint(255 * light).astype(np.uint8))


def example(name: str) -> Scene:
    """Build an example scene; a name that ends in -512 has twice the resolution throughout."""
    shape, _, size = name.partition("-")
    size = size or "256"
    fineness = int(size) // 256
    pixels, rays, control_points = 256 * fineness, 512 * fineness, 64 * fineness
    return Scene.from_data(
        {
            "unit": "cm",
            "lens": {
                "half_width": [1.0, 1.0],
                "entrance_z": 0.0,
                "refractive_index": 1.5,
                "degree": [3, 3],
                "control_points": [control_points, control_points],
                "base": {"shape": "flat", "height": 0.5},
                "height_range": [-0.3, 0.3],
                "min_thickness": 0.05,
            },
            "source": {"kind": "collimated", "rays": [rays, rays]},
            "screen": {"z": 5.0, "half_width": [1.0, 1.0], "pixels": [pixels, pixels]},
            "filter": {"kind": "gaussian", "size": [3, 3], "alpha": 1.0},
            "target": {"image": f"../targets/{shape}-{size}.png"},
            "run": {"method": "auto", "iterations": 300, "seed": 0},
        }
    )


def schema() -> str:
    """JSON Schema of the scene file, for editors."""
    described = {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        **Scene.model_json_schema(),
    }
    return json.dumps(described, indent=2, ensure_ascii=False) + "\n"


if __name__ == "__main__":
    make(resources.path())
    sys.stdout.write(f"written below {resources.path()}\n")
