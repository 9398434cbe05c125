from .cells import cells_page as cells_page, draw_cells as draw_cells
from .colours import DrawnRegion as DrawnRegion
from .counts import draw_counts as draw_counts
from .dual import draw_dual as draw_dual
from .gnomonic import draw_gnomonic as draw_gnomonic
from .graph import draw_graph as draw_graph
from .lattice import draw_lattice as draw_lattice
from .lines import draw_lines as draw_lines
from .output import save_figure as save_figure
from .page import arrangement_page as arrangement_page
from .planes import draw_planes as draw_planes
from .planesheet import DrawnFacet as DrawnFacet
from .sphere import draw_sphere as draw_sphere
from .stereographic import draw_stereographic as draw_stereographic
from .views import DRAWINGS as DRAWINGS, write_drawing as write_drawing
