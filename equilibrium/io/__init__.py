"""Files: grasps and certificates, and their schemas."""

from .files import read_certificate, read_grasp, verify, write_certificate

__all__ = ["read_certificate", "read_grasp", "verify", "write_certificate"]
