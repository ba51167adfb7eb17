// SPDX-License-Identifier: Apache-2.0
// Reads normal and height of the surface map.

// The footprint of a slope that is seen edge-on is much longer than wide. A mip level for the length would give the mean
// normal of the surroundings, a bright dot in the shade; so the level is that of twice the width.
vec4 surfaceAt(vec2 at)
{
    vec2 alongX = dFdx(at);
    vec2 alongY = dFdy(at);
    float length2 = max(dot(alongX, alongX), dot(alongY, alongY));
    float area = abs(alongX.x * alongY.y - alongX.y * alongY.x);
    return texture(terrainSurface, at, -clamp(log2(length2 / max(area, 1e-20)) - 1.0, 0.0, 6.0));
}
