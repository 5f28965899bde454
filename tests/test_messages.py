import json
import pickle

from workbench.messages import Message


def test_a_message_is_text_that_keeps_its_values_in_other_processes():
    said = Message("{part:.1%} of the {optic} {{here}}", part=0.5, optic="lens")
    for message in (said, pickle.loads(pickle.dumps(said))):
        assert message == "50.0% of the lens {here}"
        assert message.words == "{part:.1%} of the {optic} {{here}}"
        assert message.values == {"part": 0.5, "optic": "lens"}
    assert json.dumps([said]) == '["50.0% of the lens {here}"]'
