from .output import VIEWS as VIEWS, write_drawing as write_drawing
from .sphere import DrawnRegion as DrawnRegion, draw_sphere as draw_sphere
