"""A module for each question that the source leaves open: its function `answer` takes runs and gives an answer."""
