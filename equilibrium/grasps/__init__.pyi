from . import inputs as inputs
from .files import read_certificate as read_certificate, verify as verify
from .inputs.documents import read_grasp as read_grasp
