"""Messages about edits and runs that offer what to do next."""
