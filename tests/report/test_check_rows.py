"""What a report says of the check of a lens."""

import numpy as np
import pytest

from tests.analysis.lenses import net_of
from tests.lamps import PLATE, led
from workbench.analysis.validation import validate
from workbench.cli.validate import print_image
from workbench.report.figures import check_rows
from workbench.scene import Screen


@pytest.fixture
def checked(make_scene, tmp_path):
    """A flat plate before 4,000 rays of a file, on an image that their number makes rough."""
    scene = make_scene({**PLATE, "source": led(tmp_path, 4000), "screen.half_width": [1.0, 1.0]})
    heights = {"exit": net_of(scene, lambda x, y: np.full_like(x + y, 0.5))}
    even = validate(scene, np.ones((40, 40)), heights, 4000, accuracy=1e-3)
    return validate(scene, even.by_cells.irradiance, heights, 4000, accuracy=1e-3)


def test_an_error_that_few_rays_cannot_tell_from_none_is_below_its_upper_end(checked):
    found, rows = checked, dict(check_rows(checked, 0.0))
    assert found.by_cells.relative_l2_corrected_interval[0] == 0
    high = found.by_cells.relative_l2_corrected_interval[1]
    assert rows["verified error"] == f"< {100 * high:.3f} %"
    assert rows["without ray noise"].startswith("< ")
    assert "off" not in rows["cells"]
    assert rows["error by independent images"].startswith("4,000 rays, 95 % confidence; off by up")


def test_so_says_the_command(checked, capsys):
    print_image(checked, None, Screen(position=(0.0, 0.0, 5), half_width=(1, 1), pixels=(40, 40)))
    lines = capsys.readouterr().out.splitlines()
    high = checked.by_cells.relative_l2_corrected_interval[1]
    assert lines[0] == f"verified error    < {high:.5f}  (relative L2, 0.00000 to {high:.5f})"
    assert lines[2].split() == ["loss", "-"]
    assert any(line.startswith("without ray noise <") for line in lines)
