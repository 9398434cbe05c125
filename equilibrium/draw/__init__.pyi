from .grasp import draw_grasp as draw_grasp
