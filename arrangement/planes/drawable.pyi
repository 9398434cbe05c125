# Made by `python -m tests.draw_stubs` from the views.
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any, Literal, overload

from arrangement.drawing.colours import DrawnRegion
from arrangement.drawing.path_artist import Drawing, Room
from arrangement.pictures.planes import DrawnFacet

class DrawableArrangement:
    @overload
    def draw(
        self,
        view: Literal["sphere"],
        *,
        camera: Sequence[object] | None = ...,
        azimuth: float = ...,
        colour: str | Sequence[str] | Callable[[DrawnRegion], str] | None = ...,
        labels: str | Mapping[Any, str] | Iterable[Any] | None = ...,
        axes: str | bool | None = ...,
        sides: bool = ...,
        width: float = ...,
        coordinates: str | None = ...,
        ax: Room | None = ...,
    ) -> Drawing: ...
    @overload
    def draw(
        self,
        view: Literal["planes"],
        *,
        body: str = ...,
        centre: Sequence[object] | None = ...,
        radius: object | None = ...,
        camera: Sequence[object] | None = ...,
        azimuth: float = ...,
        lift: Iterable[str] = ...,
        colour: str | Callable[[DrawnFacet], str] = ...,
        labels: str | Mapping[Any, str] | Iterable[Any] | None = ...,
        axes: str | bool | None = ...,
        sides: bool = ...,
        width: float = ...,
        coordinates: str | None = ...,
        ax: Room | None = ...,
    ) -> Drawing: ...
    @overload
    def draw(
        self,
        view: Literal["cells"],
        *,
        body: str = ...,
        centre: Sequence[object] | None = ...,
        radius: object | None = ...,
        explode: float = ...,
        camera: Sequence[object] | None = ...,
        azimuth: float = ...,
        labels: str | Mapping[Any, str] | Iterable[Any] | None = ...,
        coordinates: str | None = ...,
        width: float = ...,
        ax: Room | None = ...,
    ) -> Drawing: ...
    @overload
    def draw(
        self,
        view: Literal["lines"],
        *,
        projective: bool = ...,
        faces: str = ...,
        labels: str | Mapping[Any, str] | Iterable[Any] | None = ...,
        colour: str | Sequence[str] | Callable[[DrawnRegion], str] | None = ...,
        sides: bool = ...,
        width: float = ...,
        coordinates: str | None = ...,
        window: Iterable[Iterable[Any]] = ...,
        inside: Any | None = ...,
        ax: Room | None = ...,
    ) -> Drawing: ...
    @overload
    def draw(
        self,
        view: Literal["stereographic"],
        *,
        camera: Sequence[object] | None = ...,
        colour: str | Sequence[str] | Callable[[DrawnRegion], str] | None = ...,
        labels: str | Mapping[Any, str] | Iterable[Any] | None = ...,
        width: float = ...,
        whole: bool | None = ...,
        coordinates: str | None = ...,
        ax: Room | None = ...,
    ) -> Drawing: ...
    @overload
    def draw(
        self,
        view: Literal["gnomonic"],
        *,
        camera: Sequence[object] | None = ...,
        colour: str | Sequence[str] | Callable[[DrawnRegion], str] | None = ...,
        labels: str | Mapping[Any, str] | Iterable[Any] | None = ...,
        width: float = ...,
        coordinates: str | None = ...,
        ax: Room | None = ...,
    ) -> Drawing: ...
    @overload
    def draw(
        self,
        view: Literal["dual"],
        *,
        camera: Sequence[object] | None = ...,
        azimuth: float = ...,
        colour: str | Sequence[str] | Callable[[DrawnRegion], str] | None = ...,
        labels: str | Mapping[Any, str] | Iterable[Any] | None = ...,
        width: float = ...,
        hull: bool = ...,
        sphere: bool = ...,
        coordinates: str | None = ...,
        ax: Room | None = ...,
    ) -> Drawing: ...
    @overload
    def draw(
        self,
        view: Literal["section"],
        *,
        section: Iterable[Any] | None = ...,
        body: str = ...,
        camera: Sequence[object] | None = ...,
        azimuth: float = ...,
        lift: Iterable[str] = ...,
        colour: str | Callable[[DrawnFacet], str] = ...,
        labels: str | Mapping[Any, str] | Iterable[Any] | None = ...,
        sides: bool = ...,
        width: float = ...,
        coordinates: str | None = ...,
        ax: Room | None = ...,
    ) -> Drawing: ...
    @overload
    def draw(
        self,
        view: Literal["graph"],
        *,
        colour: str | Sequence[str] | Callable[[DrawnRegion], str] | None = ...,
        labels: str | Mapping[Any, str] | Iterable[Any] | None = ...,
        width: float = ...,
        ax: Room | None = ...,
    ) -> Drawing: ...
    @overload
    def draw(
        self,
        view: Literal["poset"],
        *,
        bottom: str | None = ...,
        colour: str | Sequence[str] | Callable[[DrawnRegion], str] | None = ...,
        labels: str | Mapping[Any, str] | Iterable[Any] | None = ...,
        width: float = ...,
        ax: Room | None = ...,
    ) -> Drawing: ...
    @overload
    def draw(
        self,
        view: Literal["lattice"],
        *,
        width: float = ...,
        ax: Room | None = ...,
    ) -> Drawing: ...
    @overload
    def draw(
        self,
        view: str | None = ...,
        *,
        camera: Sequence[object] | None = ...,
        azimuth: float = ...,
        colour: str
        | Sequence[str]
        | Callable[[DrawnRegion], str]
        | Callable[[DrawnFacet], str]
        | None = ...,
        labels: str | Mapping[Any, str] | Iterable[Any] | None = ...,
        axes: str | bool | None = ...,
        sides: bool = ...,
        width: float = ...,
        coordinates: str | None = ...,
        body: str = ...,
        centre: Sequence[object] | None = ...,
        radius: object | None = ...,
        lift: Iterable[str] = ...,
        explode: float = ...,
        projective: bool = ...,
        faces: str = ...,
        window: Iterable[Iterable[Any]] = ...,
        inside: Any | None = ...,
        whole: bool | None = ...,
        hull: bool = ...,
        sphere: bool = ...,
        section: Iterable[Any] | None = ...,
        bottom: str | None = ...,
        ax: Room | None = ...,
    ) -> Drawing: ...
