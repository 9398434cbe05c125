"""Lists of all faces: one engine for any dimension, two fast ones, and the published steps."""
