"""Why a run ended, found again in what a file says."""

import pickle

import pytest

from workbench.design.endings import ENDINGS, FAILED, GAINED, IN_VAIN, SLOW, SMALL, ending
from workbench.said import Said

VALUES = {"error": 0.1, "gain": 5.0, "points": 0.03, "patience": 8, "iterations": 15, "times": 0.4}


@pytest.mark.parametrize("words", ENDINGS)
def test_each_ending_is_found_again_in_its_sentence(words):
    said = Said(words, ended=Said(SMALL, error=0.1), **VALUES)
    found = ending(str(said))
    assert (found, found.words) == (said, words)


def test_values_and_what_stands_before_are_found_again():
    slow = Said(SLOW, gain=0.25, patience=12)
    both = Said(GAINED, ended=slow, iterations=15, times=0.125)
    found = ending(str(Said(IN_VAIN, ended=both)))
    assert found.words == IN_VAIN
    assert found.values["ended"].words == GAINED
    assert found.values["ended"].values["times"] == "0.12"
    assert found.values["ended"].values["ended"].values == {"gain": "0.25", "patience": "12"}
    assert pickle.loads(pickle.dumps(found)) == found


@pytest.mark.parametrize("text", ["", "by hand", "{ended}", "stopped ", str(Said(FAILED, why="x"))])
def test_other_texts_stay_as_they_are(text):
    assert ending(text) == text
    assert not isinstance(ending(text), Said)
