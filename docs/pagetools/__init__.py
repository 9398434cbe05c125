"""Directives and transforms of these pages: public names, thumbnails, pictures for dark pages."""

from . import dark_pictures, public_names, thumbnails


def setup(app):
    for part in (dark_pictures, public_names, thumbnails):
        part.setup(app)
