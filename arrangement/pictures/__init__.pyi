from .diagrams.counts import draw_counts as draw_counts
from .diagrams.lattice import draw_lattice as draw_lattice
from .diagrams.lines import draw_lines as draw_lines
from .duals.dual import draw_dual as draw_dual
from .duals.graph import draw_graph as draw_graph
from .duals.poset import draw_poset as draw_poset
from .lab.arrangement_page import arrangement_page as arrangement_page
from .space.cells import cells_page as cells_page, draw_cells as draw_cells
from .space.planes import draw_planes as draw_planes, draw_section as draw_section
from .space.planes_sheet import DrawnFacet as DrawnFacet
from .sphere.gnomonic import draw_gnomonic as draw_gnomonic
from .sphere.sphere import draw_sphere as draw_sphere
from .sphere.stereographic import draw_stereographic as draw_stereographic
from .views import (
    DRAWINGS as DRAWINGS,
    DrawnRegion as DrawnRegion,
    compose as compose,
    save_figure as save_figure,
    write_drawing as write_drawing,
)
