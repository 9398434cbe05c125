"""Directives and transforms: command help, public names, synonyms, thumbnails, dark pictures."""

from . import command_help, dark_pictures, module_names, synonyms, thumbnails


def setup(app):
    for part in (command_help, dark_pictures, module_names, synonyms, thumbnails):
        part.setup(app)
