from . import inputs as inputs
from .files import (
    read_certificate as read_certificate,
    read_grasp as read_grasp,
    verify as verify,
)
