from .assemblies import draw_assembly as draw_assembly
from .forces import (
    draw_compare as draw_compare,
    draw_methods as draw_methods,
    draw_polar as draw_polar,
    draw_resist as draw_resist,
    draw_slice as draw_slice,
)
from .grasp import draw_grasp as draw_grasp
from .lab.page import resist_page as resist_page
from .proof import draw_proof as draw_proof, proof_page as proof_page
from .views import (
    DRAWINGS as DRAWINGS,
    OF_ASSEMBLIES as OF_ASSEMBLIES,
    write_drawing as write_drawing,
)
