"""What happens once, when the program starts: display, slow libraries, unexpected errors."""
