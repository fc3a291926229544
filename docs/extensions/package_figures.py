"""Pictures of the gallery that the package draws: figures of its own, which pyplot knows nothing of."""

from __future__ import annotations

from typing import Any
from weakref import WeakSet

import matplotlib.pyplot as plt
from matplotlib.figure import Figure
from sphinx_gallery.scrapers import figure_rst

_taken: WeakSet[Figure] = WeakSet()


def package_figures(block: Any, block_vars: dict[str, Any], gallery_conf: dict[str, Any]) -> str:
    """Save what a block of an example has drawn and pyplot does not hold; the text that shows it."""
    known = {plt.figure(number) for number in plt.get_fignums()}
    paths = []
    for value in block_vars["example_globals"].values():
        if isinstance(value, Figure) and value not in known and value not in _taken and not _by_pyplot(value):
            path = next(block_vars["image_path_iterator"])
            value.savefig(path, dpi=150)
            _taken.add(value)
            paths.append(path)
    return figure_rst(paths, gallery_conf["src_dir"])


def _by_pyplot(figure: Figure) -> bool:
    """Whether pyplot made it, whose figures are taken by the gallery itself, and then closed."""
    return hasattr(figure, "number")
