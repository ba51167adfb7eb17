// SPDX-License-Identifier: Apache-2.0
// Paints the marks along the borders of a strip: the share of the pixel's footprint that each line covers. GLSL 1.30.

in vec3 roadFromEye;
in vec3 roadNormalWorld;
in vec3 roadAt;
in vec3 roadPresence;
in float roadWear;
in vec2 roadGround;
flat in int roadKind;
flat in ivec3 roadMarkRows;

uniform sampler2D roadMarks;
#ifndef roadGrain // a program that has a grain of its own names it
uniform sampler2D roadGrain;
#endif
uniform vec4 roadLift;

// The share of a filter around x that lies within halfWidth of 0.
float roadLineCover(float x, float halfWidth, float filterWidth)
{
    float half_ = 0.5 * filterWidth;
    return max(0.0, min(x + half_, halfWidth) - max(x - half_, -halfWidth)) / filterWidth;
}

// The length of the dashes of a pattern between 0 and x.
float roadDashesUpTo(float x, float dash, float period)
{
    float whole = floor(x / period);
    return whole * dash + min(x - whole * period, dash);
}

// x: to the left of the border; filters: along s and across, metres.
vec3 roadLine(vec3 colour, int texel, int line, float x, float presence, vec2 filters)
{
    vec4 shape = texelFetch(roadMarks, ivec2(texel, line), 0);       // offset, width, dash, period
    if (shape.y <= 0.0) return colour;
    float cover = roadLineCover(x - shape.x, 0.5 * shape.y, filters.y);
    if (cover <= 0.0) return colour;
    vec4 paint = texelFetch(roadMarks, ivec2(texel + 1, line), 0);   // phase, colour
    if (shape.z > 0.0)
    {
        float s = roadAt.x + paint.x;
        cover *= (roadDashesUpTo(s + 0.5 * filters.x, shape.z, shape.w) -
                  roadDashesUpTo(s - 0.5 * filters.x, shape.z, shape.w)) / filters.x;
    }
    // Paint is worn where stones stick out.
    float grain = texture(roadGrain, roadGround * 0.5).r;
    return mix(colour, paint.yzw, cover * presence * (0.80 + 0.20 * grain));
}

vec3 roadMarksOfRow(vec3 colour, int row, float x, float presence, vec2 filters)
{
    if (row == 0 || presence <= 0.0) return colour;
    int texel = (row & 255) * 4;
    int line = row >> 8;
    colour = roadLine(colour, texel, line, x, presence, filters);
    return roadLine(colour, texel + 2, line, x, presence, filters);
}

// The width of the pixel's footprint along s and across.
vec2 roadFilters()
{
    vec2 wide = abs(dFdx(roadAt.xy)) + abs(dFdy(roadAt.xy));
    return max(wide, vec2(1e-4));
}
