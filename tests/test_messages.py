import json
import pickle

from workbench.messages import Message, Stated


def test_a_message_is_text_that_keeps_its_values_in_other_processes():
    stated = Message("{part:.1%} of the {optic} {{here}}", part=0.5, optic="lens")
    for message in (stated, pickle.loads(pickle.dumps(stated))):
        assert message == "50.0% of the lens {here}"
        assert message.words == "{part:.1%} of the {optic} {{here}}"
        assert message.values == {"part": 0.5, "optic": "lens"}
    assert json.dumps([stated]) == '["50.0% of the lens {here}"]'


def test_a_message_states_numbers_of_its_field_as_a_multiple_and_no_others():
    message = Message("{half:g} about {middle:g}", half=Stated(85.0), middle=20.0)
    assert message == "85 about 20" and message.times(2) == "170 about 20"
