"""Directives and transforms: help of commands, public names, thumbnails, dark pictures."""

from . import command_help, dark_pictures, module_names, thumbnails


def setup(app):
    for part in (command_help, dark_pictures, module_names, thumbnails):
        part.setup(app)
