// SPDX-License-Identifier: Apache-2.0
// Reads the maps of the ground beyond the data (OuterAxis.h): outerMaps() replaces normal and land of the border, over the
// first texels beyond it.

uniform sampler2D outerNormals;
uniform sampler2D outerLand;
uniform vec2 outerInside; // texels per grid unit within the data
uniform vec2 outerCurve;  // texels beyond the data over which a texel grows e-fold
uniform float outerFirst, outerTexels;
uniform vec2 outerLast; // the last sample of the data

void outerMaps(inout vec2 tilt, inout vec4 land)
{
    vec2 border = clamp(grid, vec2(0.0), outerLast);
    vec2 beyond = (grid - border) * outerInside;
    vec2 at = border * outerInside + sign(beyond) * outerCurve * log(1.0 + abs(beyond) / outerCurve);
    at = (at + outerFirst) / outerTexels;
    float share = smoothstep(0.0, 3.0, max(abs(beyond.x), abs(beyond.y)));
    tilt = mix(tilt, texture(outerNormals, at).rg * 2.0 - 1.0, share);
    land = mix(land, texture(outerLand, at), share);
}
