"""The vector equations that the joints and drivers state, for velocities and accelerations alike.

The motion of each point is written as a chain of terms from the ground outwards, `v_B = v_A + v_BA`
or `v_a = v_e + v_r`, each term a vector times one unknown rate (`terms`). A joint that closes a
loop equates two chains (`relation`). The same relations hold for accelerations, with the part of
each term that the velocities decide: centripetal and Coriolis.

A `Reading` (`reading`, of the parts of a term `term_reading`) says what is taken of the terms by a
student who makes a mistake, goes on from a value of their own, or rounds.

`build_frames` is called by `motion`; `plan` decides in which order the relations determine the
rates.
"""
