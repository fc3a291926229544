"""Whether the words of a picture can be read: none of them lies over data, or over other words."""

from __future__ import annotations

from matplotlib.figure import Figure


def assert_legible(figure: Figure) -> None:
    """No words of a figure lie over a point that is drawn in it, nor over other words, nor outside it.

    Marks that are words themselves are told by their gid.
    """
    figure.draw_without_rendering()
    legends = [*figure.legends, *(axes.get_legend() for axes in figure.axes if axes.get_legend())]
    boxes = [legend.get_window_extent() for legend in legends]
    texts = [text for axes in figure.axes for text in axes.texts if text.get_text() and not text.get_gid()]
    texts += [title for axes in figure.axes for title in (axes._left_title, axes.title) if title.get_text()]  # type: ignore[attr-defined]
    texts += [figure._suptitle] if figure.get_suptitle() else []  # type: ignore[attr-defined]
    boxes += [text.get_window_extent() for text in texts]
    for axes in figure.axes:
        for line in axes.get_lines():
            places = line.get_transform().transform(line.get_xydata())
            if line.get_clip_on():
                inner = axes.get_window_extent()
                places = places[[inner.contains(*place) for place in places]]
            for box in boxes:
                inside = (places > (box.x0, box.y0)).all(axis=1) & (places < (box.x1, box.y1)).all(axis=1)
                assert not inside.any(), f"{line.get_label()} lies under words"
    assert not [1 for i, box in enumerate(boxes) for other in boxes[:i] if box.overlaps(other)]
    page = figure.bbox
    for box in boxes:
        assert box.x0 >= -1, f"words leave the picture at {box}"
        assert box.x1 <= page.x1 + 1, "words leave the picture"
