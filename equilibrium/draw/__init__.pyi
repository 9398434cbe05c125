from .compare import draw_compare as draw_compare
from .grasp import draw_grasp as draw_grasp
from .methods import draw_methods as draw_methods
from .page import resist_page as resist_page
from .polar import draw_polar as draw_polar
from .proof import draw_proof as draw_proof
from .proof_page import proof_page as proof_page
from .resist import draw_resist as draw_resist
from .slices import draw_slice as draw_slice
from .views import DRAWINGS as DRAWINGS, write_drawing as write_drawing
