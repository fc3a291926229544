"""Pictures of a run, drawn without a display: a film, and a strip of snapshots.

All is in metres in the world frame until the camera projects it to pixels.
"""

from plategait.render.film import film, filmstrip

__all__ = ["film", "filmstrip"]
