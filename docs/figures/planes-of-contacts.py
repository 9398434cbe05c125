"""The tangential planes of the three-contact grasp in the space of motions."""

from arrangement import read_arrangement
from arrangement.pictures import write_drawing

write_drawing(read_arrangement("paper-three-contacts"), "planes-of-contacts.svg", "planes")
