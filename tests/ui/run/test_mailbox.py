from ui.run.mailbox import Mailbox


def test_holds_the_latest_value_alone():
    mailbox = Mailbox()
    mailbox.put("first")
    mailbox.put("second")
    assert mailbox.take() == "second"
    assert mailbox.take() is None


def test_is_empty_once_taken():
    mailbox = Mailbox()
    assert mailbox.empty
    mailbox.put("value")
    assert not mailbox.empty
    mailbox.take()
    assert mailbox.empty
