from .grasp.grasp import draw_grasp as draw_grasp
from .grasp.proof import draw_proof as draw_proof
from .pages.page import resist_page as resist_page
from .pages.proof_page import proof_page as proof_page
from .views import DRAWINGS as DRAWINGS, write_drawing as write_drawing
from .wrenches.compare import draw_compare as draw_compare
from .wrenches.methods import draw_methods as draw_methods
from .wrenches.polar import draw_polar as draw_polar
from .wrenches.resist import draw_resist as draw_resist
from .wrenches.slices import draw_slice as draw_slice
