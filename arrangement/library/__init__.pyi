from . import census as census, families as families
