"""Files: grasps and certificates, and their schemas."""
