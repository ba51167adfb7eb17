// SPDX-License-Identifier: Apache-2.0
// Finds the openings of the ground: bool isOpening(vec3 place). `place`: the wrapped position, metres. OpeningCells.h describes
// the texels; OpeningCells::isOpen() is the same for queries.

uniform sampler2D openingTexels;
uniform ivec4 openingGrid; // first cell, columns, rows
uniform float openingCellM;

vec4 openingTexel(int index)
{
    return texelFetch(openingTexels, ivec2(index & 1023, index >> 10), 0);
}

// `at`: east and north of the middle of the cell, and the height.
bool isInPiece(int record, vec3 at)
{
    vec4 from = openingTexel(record), to = openingTexel(record + 1);
    vec4 heights = openingTexel(record + 2), ends = openingTexel(record + 3);
    vec2 way = to.xy - from.xy, away = at.xy - from.xy;
    float length1 = max(length(way), 1e-6), along = dot(away, way) / length1;
    if (along < -ends.x || along > length1 + ends.y) return false;
    vec4 line = mix(from, to, clamp(along / length1, 0.0, 1.0));
    float aside = abs(way.x * away.y - way.y * away.x) / (length1 * line.w);
    float height = at.z - line.z;
    if (aside > 1.0 || height < heights.x) return false;
    return height < (aside < 0.6 ? mix(heights.w, heights.z, aside / 0.6)
                                 : mix(heights.z, heights.y, (aside - 0.6) / 0.4));
}

bool isOpening(vec3 place)
{
    vec2 cell = floor(place.xy / openingCellM);
    ivec2 index = ivec2(cell) + terrainEyeWraps.xy * int(4096.0 / openingCellM) - openingGrid.xy;
    if (any(lessThan(index, ivec2(0))) || any(greaterThanEqual(index, openingGrid.zw))) return false;
    vec4 list = openingTexel(index.y * openingGrid.z + index.x);
    vec3 at = vec3(place.xy - (cell + 0.5) * openingCellM, place.z + 4096.0 * float(terrainEyeWraps.z));
    for (int i = 0; i < int(list.y); ++i)
        if (isInPiece(int(list.x) + 4 * i, at)) return true;
    return false;
}
