"""Arrays by the names of their faces."""

import pickle

import numpy as np
import pytest

from workbench.geometry.faces import FaceArrays


def test_arrays_of_faces_are_read_only():
    given = np.zeros((4, 5))
    arrays = FaceArrays({"exit": given})
    given[0, 0] = 1
    assert arrays["exit"][0, 0] == 0
    with pytest.raises(ValueError, match="read-only"):
        arrays["exit"][0, 0] = 1
    with pytest.raises(TypeError):
        arrays["exit"] = given


def test_equal_are_those_of_the_same_faces_and_values():
    one = FaceArrays({"exit": np.zeros((4, 5)), "entrance": np.ones((3, 3))})
    same = FaceArrays({"entrance": np.ones((3, 3)), "exit": np.zeros((4, 5))})
    assert one == same and hash(one) == hash(same)
    assert one != FaceArrays({"exit": np.zeros((4, 5))})
    assert one != FaceArrays({**one, "entrance": np.zeros((3, 3))})
    assert one != FaceArrays({**one, "exit": np.zeros((5, 4))})
    assert one != {"exit": np.zeros((4, 5))}
    assert not FaceArrays({})


def test_other_processes_get_the_same_arrays():
    arrays = FaceArrays({"exit": np.arange(20.0).reshape(4, 5)})
    again = pickle.loads(pickle.dumps(arrays))
    assert again == arrays and not again["exit"].flags.writeable
