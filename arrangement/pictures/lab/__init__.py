"""Interactive pages: what all of them share.

The modules in ``templates`` are plain scripts, put one after another into a page. What each needs
of the page that uses it stands at its head.
"""
