import json

import pytest

FEW = ("--rays", 20_000)


def test_figures_and_plot(freeform, lens, tmp_path):
    plot = tmp_path / "focus.png"
    focus = ("--through-focus", "3:8:6", "--plot", plot)
    status, stdout, stderr = freeform("validate", lens, *FEW, *focus, "--json")
    assert (status, stderr) == (0, "")
    series = json.loads(stdout)["through_focus"]
    assert [each["z"] for each in series] == [3, 4, 5, 6, 7, 8]
    # Parallel light behind a flat lens is the same everywhere.
    assert [each["efficiency"] for each in series] == pytest.approx([0.96**2] * 6, rel=1e-9)
    assert max(each["relative_l2"] for each in series) < 0.5
    assert plot.read_bytes().startswith(b"\x89PNG")


@pytest.mark.parametrize(
    "arguments, reason",
    [
        (("--through-focus", "4:6"), "usage: argument --through-focus: '4:6'; first:last:number"),
        (("--through-focus", "6:4:3"), "usage: argument --through-focus: '6:4:3'"),
        (("--through-focus", "4:inf:3"), "usage: argument --through-focus: '4:inf:3'"),
        (("--through-focus", "4:6:1"), "usage: argument --through-focus: '4:6:1'"),
        (("--through-focus", "0.6:6:3"), "images[0].receiver.position[2]: 0.6 may touch the lens"),
        (("--plot", "a.png"), "usage: --plot draws images through focus"),
    ],
)
def test_refusals(freeform, lens, arguments, reason):
    status, stdout, stderr = freeform("validate", lens, *arguments)
    assert (status, stdout) == (2, "")
    assert stderr.startswith(f"freeform: {reason}")
