"""The motion that does best: what is sought, what may vary, and the search that finds it."""
