"""Numbers of faces of central planes against the bounds of the paper, over the number of planes."""

from arrangement.pictures import draw_counts, save_figure

save_figure("counts-against-bounds.svg", draw_counts)
