"""A mailbox that holds the latest value and no other."""

from threading import Lock
from typing import Generic, TypeVar

Value = TypeVar("Value")


class Mailbox(Generic[Value]):
    """Hands values from one thread to another; a value that was not taken is replaced."""

    def __init__(self) -> None:
        self._lock = Lock()
        self._value: Value | None = None

    @property
    def empty(self) -> bool:
        """Whether the last value was taken, which is how its reader asks for another."""
        with self._lock:
            return self._value is None

    def put(self, value: Value) -> None:
        """Leave a value in the place of the one before."""
        with self._lock:
            self._value = value

    def take(self) -> Value | None:
        """Take the latest value; None if there is none since the last time."""
        with self._lock:
            value, self._value = self._value, None
            return value
