import json
import pickle

from workbench.said import Said


def test_a_sentence_is_text_and_remembers_what_it_was_made_of():
    said = Said("The {optic} turns it by {most:.0f}°.", optic="lens", most=48.2)
    assert said == "The lens turns it by 48°."
    assert (said.words, said.values) == (
        "The {optic} turns it by {most:.0f}°.",
        {"optic": "lens", "most": 48.2},
    )
    assert json.dumps([said]) == '["The lens turns it by 48\\u00b0."]'


def test_a_sentence_goes_to_other_processes():
    said = Said("{part:.1%} of {{it}}", part=0.5)
    again = pickle.loads(pickle.dumps(said))
    assert (again, again.words, again.values) == (said, said.words, said.values)
