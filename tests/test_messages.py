import json
import pickle

from workbench.messages import Message


def test_a_message_is_text_that_keeps_its_values_in_other_processes():
    stated = Message("{part:.1%} of the {optic} {{here}}", part=0.5, optic="lens")
    for message in (stated, pickle.loads(pickle.dumps(stated))):
        assert message == "50.0% of the lens {here}"
        assert message.words == "{part:.1%} of the {optic} {{here}}"
        assert message.values == {"part": 0.5, "optic": "lens"}
    assert json.dumps([stated]) == '["50.0% of the lens {here}"]'
