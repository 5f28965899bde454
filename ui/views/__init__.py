"""Views of the design: each shows the latest frame, and draws nothing that nobody sees."""
