# SPDX-License-Identifier: Apache-2.0
# Prints a model to try programs with, as Wavefront .obj: a ring with nine waves, 2 304 triangles, closed, 8.6 by 8.6 by 2.2 m.
#     awk -f data/models/ring.awk >ring.obj
BEGIN {
    around = 48; across = 24; turn = 8 * atan2(1, 1)
    for (i = 0; i < around; ++i)
        for (j = 0; j < across; ++j) {
            a = turn * i / around; b = turn * j / across
            thick = 1 + 0.1 * sin(9 * a)
            radius = 3.2 + thick * cos(b)
            printf "v %.6f %.6f %.6f\n", radius * cos(a), radius * sin(a), thick * sin(b)
        }
    for (i = 0; i < around; ++i)
        for (j = 0; j < across; ++j) {
            next_i = (i + 1) % around; next_j = (j + 1) % across
            p = i * across + j + 1; q = next_i * across + j + 1
            r = next_i * across + next_j + 1; s = i * across + next_j + 1
            printf "f %d %d %d\nf %d %d %d\n", p, q, r, p, r, s
        }
}
