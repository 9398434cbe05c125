"""Three great circles, eight regions: the smallest picture of all."""

from arrangement import read_arrangement
from arrangement.pictures import write_drawing

write_drawing(read_arrangement("three-generic-planes"), "three-generic-planes.svg", "sphere")
