"""Messages about edits and runs, with buttons for the next step."""
