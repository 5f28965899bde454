"""Report of a session on a few pages, for readers without the program."""
