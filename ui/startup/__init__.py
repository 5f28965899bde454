"""Start of the program: display, slow libraries, unexpected errors."""
