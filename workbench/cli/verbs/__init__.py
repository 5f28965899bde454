"""What can be typed after ``freeform``: a file for each verb, with its arguments and examples.

Commands are imported when they run, so that help and refusals come at once. What an argument means
is said here, and not again with the function that it is for.
"""
