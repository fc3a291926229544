"""The atlas of what an object does on a machine: for each velocity a motion, and a few of them as primitives."""
