"""What an ask's `quantity` may say: velocities, accelerations, their relative parts, poles, lengths
and angles.

    magnitude(velocity(B))                     speed of B
    x(acceleration(B))                         component
    along(relative_velocity(A, AB, OC), A - O) A of AB seen from OC, positive from O towards A
    omega(AB), alpha(AB), omega(II, OA)        absolute, and relative to another body
    normal_acceleration(A, O, I)               part of A relative to O, both on body I, towards O
    angle(velocity(A), velocity(B))            from the first to the second, counter-clockwise

A point's body is named where the point belongs to several that are not pinned there: `velocity(A,
cam)`. `motion_functions` has a row for each function of the motion, `measures` for each of vectors
and circles; `functions` puts them together.
"""
