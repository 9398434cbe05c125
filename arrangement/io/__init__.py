"""Files: arrangements as documents, meshes, schemas, and writing whole or not at all."""
