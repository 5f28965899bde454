"""What can be typed after ``freeform``: a file for each verb, with its arguments and examples.

Commands are imported when they run, so that help and refusals come at once.
"""
