// SPDX-License-Identifier: Apache-2.0
// Colours the sky by direction: atmosphere, sun and, at night, stars.

in vec3 direction;

float hashOf(vec3 cell)
{
    return fract(sin(dot(cell, vec3(127.1, 311.7, 74.7))) * 43758.5453);
}

// Draws at most one star in each cell of a grid around the unit sphere, about one and a half pixels wide. A star near or
// beyond the walls of its cell is left out: the neighbouring cell would not draw its other half.
vec3 stars(vec3 towards, float pixelAngle)
{
    const float kCells = 40.0;
    vec3 cell = floor(towards * kCells);
    if (hashOf(cell) < 0.35) return vec3(0.0);
    vec3 jitter = vec3(hashOf(cell + 1.0), hashOf(cell + 2.0), hashOf(cell + 3.0));
    vec3 place = normalize(cell + jitter);
    vec3 inCell = place * kCells - cell;
    if (any(lessThan(inCell, vec3(0.1))) || any(greaterThan(inCell, vec3(0.9)))) return vec3(0.0);
    float away = length(towards - place) / pixelAngle;
    float magnitude = hashOf(cell + 4.0);
    return vec3(0.9, 0.95, 1.0) * (0.6 * magnitude * magnitude * magnitude * exp(-away * away));
}

void main()
{
    vec3 towards = normalize(direction);
    vec3 colour = skyColour(towards) + sunDisc(towards);
    float night = smoothstep(-0.10, -0.25, sunDirection().z);
    if (night > 0.0 && towards.z > 0.0)
        colour += night * smoothstep(0.0, 0.25, towards.z) * stars(towards, max(0.7 * length(fwidth(towards)), 1e-6));
    gl_FragColor = vec4(displayColour(colour), 1.0);
}
