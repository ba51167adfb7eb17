// SPDX-License-Identifier: Apache-2.0
// Paints decals (core::Decal): the share of the pixel's footprint that each trapezoid, or each of its stripes, covers. GLSL 1.30.

in vec2 roadPlan;
uniform sampler2D roadDecals;

vec4 roadDecalTexel(int row, int texel)
{
    return texelFetch(roadDecals, ivec2((row & 255) * 4 + texel, row >> 8), 0);
}

// planX, planY: how roadPlan changes from pixel to pixel.
float roadDecalCover(int row, vec2 planX, vec2 planY)
{
    vec4 place = roadDecalTexel(row, 0);  // start, direction
    vec4 shape = roadDecalTexel(row, 1);  // length, half of both widths, shift
    vec2 from = roadPlan - place.xy, along = place.zw, left = vec2(-place.w, place.z);
    float u = dot(from, along);
    float lean = shape.w / shape.x;
    vec2 across = left - lean * along;
    float v = dot(from, across);
    vec2 filters = max(vec2(abs(dot(planX, along)) + abs(dot(planY, along)),
                            abs(dot(planX, across)) + abs(dot(planY, across))), vec2(1e-4));
    float half_ = mix(shape.y, shape.z, clamp(u / shape.x, 0.0, 1.0));
    float cover = roadLineCover(u - 0.5 * shape.x, 0.5 * shape.x, filters.x) * roadLineCover(v, half_, filters.y);
    vec4 stripes = roadDecalTexel(row, 2);  // dash, period, phase
    if (stripes.x > 0.0)
    {
        float s = u + stripes.z;
        cover *= (roadDashesUpTo(s + 0.5 * filters.x, stripes.x, stripes.y) -
                  roadDashesUpTo(s - 0.5 * filters.x, stripes.x, stripes.y)) / filters.x;
    }
    return cover;
}

vec3 roadDecalsOf(vec3 colour, int row, vec2 planX, vec2 planY)
{
    if (row == 0) return colour;
    int count = int(roadDecalTexel(row, 0).z);
    // Pieces that meet add up, so that no seam is seen between them.
    vec4 paint = vec4(0.0);
    for (int i = 1; i <= count; ++i)
    {
        float cover = roadDecalCover(row + i, planX, planY);
        if (cover > 0.0) paint += cover * vec4(roadDecalTexel(row + i, 3).rgb, 1.0);
    }
    if (paint.a <= 0.0) return colour;
    float grain = texture(roadGrain, roadGround * 0.5).r;
    return mix(colour, paint.rgb / paint.a, min(paint.a, 1.0) * (0.80 + 0.20 * grain));
}
