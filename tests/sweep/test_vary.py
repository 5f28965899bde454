import pytest

from workbench.errors import Refused
from workbench.sweep.points import Variation, shown


@pytest.mark.parametrize(
    "text, values",
    [
        ("run.seed=3", (3,)),
        ("run.seed=0..4", (0, 1, 2, 3, 4)),
        ("run.seed=-2..0,7", (-2, -1, 0, 7)),
        ("run.seed=1,1,0..2", (1, 0, 2)),
        ("source.flux=4.5,5,1e1", (4.5, 5, 10.0)),
        ("lens.back.control_points=32x32,64x48", ((32, 32), (64, 48))),
        ("source.position=0x0x-5", ((0, 0, -5),)),
        ("run.method=auto,paper", ("auto", "paper")),
        ("images[0].target.invert=true,false", (True, False)),
        ("images[0].target.image=../a.png", ("../a.png",)),
        ("lens.material=PMMA,1.5", ("PMMA", 1.5)),
    ],
)
def test_values(text, values):
    found = Variation.parse(text).values
    assert found == values
    assert list(map(type, found)) == list(map(type, values))


@pytest.mark.parametrize(
    "text, reason",
    [
        ("run.seed", "usage: --vary 'run.seed'; field=values is needed"),
        ("=1", "usage: --vary '=1'; field=values is needed"),
        ("run..seed=1", "usage: --vary 'run..seed=1'; field=values is needed"),
        ("[0]=1", "usage: --vary '[0]=1'; field=values is needed"),
        ("run.seed=", "run.seed: a value is empty"),
        ("run.seed=1,,2", "run.seed: a value is empty"),
        ("run.seed=4..0", "run.seed: 4..0; 1 to 10000 whole numbers upwards"),
        ("run.seed=0..10000", "run.seed: 0..10000; 1 to 10000 whole numbers"),
        ("source.flux=0.5..1", "source.flux: 0.5..1; from a to b goes with whole numbers only"),
    ],
)
def test_refusals(text, reason):
    with pytest.raises(Refused) as refused:
        Variation.parse(text)
    assert str(refused.value).startswith(reason)


def test_values_as_they_are_typed():
    assert [shown(v) for v in ((64, 48), 1.5, True, "auto", 3)] == [
        "64x48",
        "1.5",
        "true",
        "auto",
        "3",
    ]
