// SPDX-License-Identifier: Apache-2.0
// Leaves out the parts of the ground without data: isHole() at `grid`.

uniform sampler2D terrainHoles;

// SurfaceMap.h lists the codes of a cell.
bool isHole()
{
    vec2 cells = vec2(textureSize(terrainHoles, 0));
    vec2 cell = clamp(floor(grid), vec2(0.0), cells - 1.0);
    int code = int(texelFetch(terrainHoles, ivec2(cell), 0).r * 255.0 + 0.5);
    vec2 at = grid - cell;
    if (code == 1) return at.x + at.y < 1.0;
    if (code == 2) return at.x > at.y;
    if (code == 3) return at.x < at.y;
    if (code == 4) return at.x + at.y > 1.0;
    return code == 0;
}
