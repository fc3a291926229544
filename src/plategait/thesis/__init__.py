"""Every simulated figure and table of the dissertation, regenerated beside what it printed."""

from plategait.thesis.study import Study, reproduce

__all__ = ["Study", "reproduce"]
