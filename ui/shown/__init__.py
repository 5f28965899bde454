"""What is shown: frames of a run or a preview, and the history of frames to look back at."""
