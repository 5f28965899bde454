"""Views of the design: each shows the latest frame and draws only while visible."""
