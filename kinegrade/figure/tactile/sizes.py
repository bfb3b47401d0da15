"""How large the signs of a tactile figure are, in millimetres on paper.

Lines, dots and their distances are those that the guidelines for tactile graphics of the Braille
Authority of North America (2010) ask for, with 3 mm as the least distance; Braille has the
dimensions of DIN 32976 (Mitteldruck, "Marburg Medium").
"""

from __future__ import annotations

from kinegrade.figure.scene import Pen

PAGE_WIDTH, PAGE_HEIGHT, EDGE_OF_PAGE = 210.0, 297.0, 12.0
LEAST = 3.0  # between two lines that do not meet
CLEAR = LEAST + 0.25  # what is aimed at, as curves are judged by chords
GROUND, BODY, OUTLINE, MARK = Pen(3.0), Pen(2.0), Pen(1.2), Pen(1.0)
PIN, DOT = 2.5, 1.6  # radii of the dots of a pin, and of another marked point
# Half the width of a slot, a block or a sleeve: the dot of a pin within keeps clear of the sides
HALF = PIN + CLEAR + OUTLINE.width / 2
BLOCK = 20.0  # length of a block or a sleeve
STAND, HALF_BASE = 10.0, 9.0  # from a fixed pin to the ground, and half of the ground there
RUN_ON = 14.0  # that a free end runs on beyond what is drawn in print
RAIL = 26.0  # of a rail on either side of its block
BETWEEN_RIMS = 6.0  # from the circle of a ring to its outer edge
MOTOR = 7.0  # radius of the housing of a motor
HEAD, HALF_HEAD = 6.0, 2.5  # length of an arrowhead and half its width
DASH, GAP = 7.0, CLEAR + 0.5  # of a pitch circle, from the end of one dash to the next
CELL, CELL_DOT, CELL_RADIUS = 6.0, 2.5, 0.75  # Braille: from cell to cell, to dot
