"""Directives and transforms of these pages: public names, thumbnails, pictures for dark pages."""

from . import public_names


def setup(app):
    public_names.setup(app)
    return {"parallel_read_safe": False}
