"""Two figures as books print them: a Shi arrangement, and one of the simplicial catalogue."""

from arrangement.library.families import shi, simplicial
from arrangement.pictures import write_drawing

for suffix in ("svg", "tex"):
    write_drawing(shi(3), f"as-printed-shi.{suffix}", "lines", width=110)
    write_drawing(
        simplicial(13, 2), f"as-printed-catalogue.{suffix}", "gnomonic", width=110,
        camera=(0, 0, 1), coordinates="given", labels="none",
    )  # fmt: skip
