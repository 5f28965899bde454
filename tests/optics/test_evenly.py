"""Places that stand for a source of some size."""

import numpy as np
import pytest

from workbench.optics.sources.evenly import spread


@pytest.mark.parametrize("outline", ["rectangle", "ellipse"])
@pytest.mark.parametrize("aspect", [1e-6, 1.0, 1e6])
def test_places_of_slim_sources_are_finite_and_have_all_light(outline, aspect):
    found = spread(512, outline, aspect)
    assert np.abs([found.x, found.y]).max() < 1
    assert found.share.min() >= 0
    assert found.share.sum() == pytest.approx(1)
