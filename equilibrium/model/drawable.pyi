# Made by `python -m tests.draw_stubs` from the views.
from collections.abc import Iterable, Sequence
from typing import Any, Literal, overload

from arrangement.drawing.path_artist import Drawing, Room

class DrawableGrasp:
    @overload
    def draw(
        self,
        view: Literal["grasp"],
        *,
        wrench: Iterable[Any] | None = ...,
        outline: Iterable[Iterable[Any]] | None = ...,
        equilibrium: int = ...,
        camera: Sequence[object] | None = ...,
        azimuth: float = ...,
        max_displacement: object | None = ...,
        width: float = ...,
        ax: Room | None = ...,
    ) -> Drawing: ...
    @overload
    def draw(
        self,
        view: Literal["resist"],
        *,
        wrench: Iterable[Any] | None = ...,
        extent: object | None = ...,
        width: float = ...,
        ax: Room | None = ...,
    ) -> Drawing: ...
    @overload
    def draw(
        self,
        view: Literal["slice"],
        *,
        wrench: Iterable[Any] | None = ...,
        preload: object | None = ...,
        extent: object | None = ...,
        slice: Iterable[str] = ...,
        rays: int = ...,
        width: float = ...,
        ax: Room | None = ...,
    ) -> Drawing: ...
    @overload
    def draw(
        self,
        view: Literal["polar"],
        *,
        rays: int = ...,
        tolerance: object | None = ...,
        extent: object | None = ...,
        width: float = ...,
        ax: Room | None = ...,
    ) -> Drawing: ...
    @overload
    def draw(
        self,
        view: Literal["compare"],
        *,
        wrench: Iterable[Any] | None = ...,
        methods: Iterable[str] | None = ...,
        extent: object | None = ...,
        width: float = ...,
        ax: Room | None = ...,
    ) -> Drawing: ...
    @overload
    def draw(
        self,
        view: Literal["methods"],
        *,
        wrenches: Iterable[Iterable[Any]],
        width: float = ...,
        ax: Room | None = ...,
    ) -> Drawing: ...
    @overload
    def draw(
        self,
        view: Literal["proof"],
        *,
        wrench: Iterable[Any],
        rotation: object | None = ...,
        width: float = ...,
        ax: Room | None = ...,
    ) -> Drawing: ...
    @overload
    def draw(
        self,
        view: Literal["wrench-set"],
        *,
        wrench: Iterable[Any] | None = ...,
        extent: object | None = ...,
        camera: Sequence[object] | None = ...,
        azimuth: float = ...,
        width: float = ...,
        ax: Room | None = ...,
    ) -> Drawing: ...
    @overload
    def draw(
        self,
        view: str | None = ...,
        *,
        wrench: Iterable[Any] | None = ...,
        outline: Iterable[Iterable[Any]] | None = ...,
        equilibrium: int = ...,
        camera: Sequence[object] | None = ...,
        azimuth: float = ...,
        max_displacement: object | None = ...,
        width: float = ...,
        extent: object | None = ...,
        preload: object | None = ...,
        slice: Iterable[str] = ...,
        rays: int = ...,
        tolerance: object | None = ...,
        methods: Iterable[str] | None = ...,
        wrenches: Iterable[Iterable[Any]] = ...,
        rotation: object | None = ...,
        ax: Room | None = ...,
    ) -> Drawing: ...
