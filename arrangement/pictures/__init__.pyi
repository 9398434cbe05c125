from .cells import cells_page as cells_page, draw_cells as draw_cells
from .charts import (
    draw_gnomonic as draw_gnomonic,
    draw_stereographic as draw_stereographic,
)
from .counts import draw_counts as draw_counts
from .dual import draw_dual as draw_dual
from .globe import draw_sphere as draw_sphere
from .graph import draw_graph as draw_graph, draw_poset as draw_poset
from .lab.arrangement_page import arrangement_page as arrangement_page
from .lattice import draw_lattice as draw_lattice
from .lines import draw_lines as draw_lines
from .planes import (
    DrawnFacet as DrawnFacet,
    draw_planes as draw_planes,
    draw_section as draw_section,
)
from .segments import draw_segments as draw_segments
from .views import (
    DRAWINGS as DRAWINGS,
    DrawnRegion as DrawnRegion,
    compose as compose,
    save_figure as save_figure,
    write_drawing as write_drawing,
)
