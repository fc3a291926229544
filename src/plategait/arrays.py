"""What numbers are kept in."""

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
"""Numbers in double precision."""
Flags = NDArray[np.bool_]
"""Yes or no."""
Picture = NDArray[np.uint8]
"""Pixels, of one channel or three."""
