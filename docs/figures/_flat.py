"""Planar drawings of polyhedral graphs, for the figures that need one."""

import networkx as nx
import numpy as np


def flat(graph, ring, turn=np.pi / 4):
    """Tutte's drawing: a face as a regular polygon, all else in the middle of its neighbours.

    Nodes are 0, ..., n - 1; `ring` lists those of the outer face in cyclic order.
    """
    places = np.zeros((len(graph), 2))
    angles = turn + 2 * np.pi * np.arange(len(ring)) / len(ring)
    places[ring] = np.stack([np.cos(angles), np.sin(angles)], axis=1)
    inner = [node for node in graph if node not in ring]
    laplacian = nx.laplacian_matrix(graph, nodelist=range(len(graph))).toarray().astype(float)
    pull = -laplacian[np.ix_(inner, ring)] @ places[ring]
    places[inner] = np.linalg.solve(laplacian[np.ix_(inner, inner)], pull)
    return places
