"""A scene with all losses of a lens."""

import pytest


@pytest.fixture
def scene(make_scene):
    return make_scene(
        {"lens.reflection": "fresnel", "lens.absorption": 0.2, "screen.half_width": [3, 3]}
        | {"version": 2}
    )
