// SPDX-License-Identifier: Apache-2.0
// Samples the grain image at four periods at once: detail that is finer than the data. Per period: slopes x and y,
// fine speckle, broad patches; each between -0.5 and 0.5.

struct Grain
{
    vec4 metres2; // the period is about 2 m
    vec4 metres28;
    vec4 metres324;
    vec4 metres4700;
};

const float kGrainLevels = 9.0; // the image has 2^9 texels a side (GrainImage.cpp)

// Filters the grain anisotropically: up to four samples along the footprint's length, as many as it is longer than wide, each
// at the mip level of its part. A level for the whole length would blur ground seen at a grazing angle. A software renderer's
// own anisotropic filter costs hundreds of times as much. Where the part is half a period wide one sample tells the mean: a
// software renderer, which runs both sides of a branch, does end a loop early, and far ground needs half the time.
vec4 grazingGrain(vec2 at, vec2 alongX, vec2 alongY)
{
#ifdef PICTURE_LOW
    const float kMostSamples = 1.0;
#elif defined(PICTURE_MEDIUM)
    const float kMostSamples = 2.0;
#else
    const float kMostSamples = 4.0;
#endif
    float x2 = dot(alongX, alongX);
    float y2 = dot(alongY, alongY);
    float length2 = max(max(x2, y2), 1e-20);
    float cross2 = abs(alongX.x * alongY.y - alongX.y * alongY.x);
    float span = max(cross2 * inversesqrt(length2), sqrt(length2) / kMostSamples); // periods
    float level = log2(span) + kGrainLevels;
    float samples = level > kGrainLevels - 1.0 ? 1.0 : clamp(ceil(sqrt(length2) / span - 0.1), 1.0, kMostSamples);
    vec2 stride = (x2 > y2 ? alongX : alongY) / samples;
    vec2 place = at - stride * (0.5 * samples - 0.5);
    vec4 sum = vec4(0.0);
    for (float i = 0.0; i < samples; ++i)
    {
        sum += textureLod(terrainGrain, place, level);
        place += stride;
    }
    return sum / samples - 0.5;
}

vec4 grazingGrain(vec2 at) { return grazingGrain(at, dFdx(at), dFdy(at)); }

// The first three periods divide 4096 m, the period of the eye's wrapped position. Integer matrices rotate the layers against
// each other, so that each layer still wraps and their repetitions do not align. The broadest layer follows the grid.
Grain grainAt(vec2 place)
{
    Grain g;
    g.metres2 = grazingGrain(place * (1.0 / 2.0));
    g.metres28 = grazingGrain(vec2(2.0 * place.x + place.y, 2.0 * place.y - place.x) * (1.0 / 64.0));
    g.metres4700 = texture(terrainGrain, grid * terrainBroad) - 0.5;
    // Bent by the broad layer, the rows of clumps of this one are not seen from above.
    vec2 bent = place + 50.0 * g.metres4700.zw;
    g.metres324 = texture(terrainGrain, vec2(3.0 * bent.x - bent.y, 3.0 * bent.y + bent.x) * (1.0 / 1024.0)) - 0.5;
    return g;
}

// A place, or a way, on level ground or on the upright plane along `along`.
vec2 onGround(vec3 place, vec3 along, bool isUpright) { return isUpright ? vec2(dot(place, along), place.z) : place.xy; }

// Replaces the two finest layers where the ground is so steep that they would be stretched, by those on the upright plane, of four, that faces
// it most. `tilt`: x and y of the normal; `steep`: one less its z. What is drawn may be steeper than that, as the step beside a road. Returns the share of
// them, and the direction of the plane: by 11/16 a diagonal one still wraps with the eye.
float cliffGrain(inout Grain g, vec3 place, vec2 tilt, float steep, out vec3 along)
{
#ifndef PICTURE_LOW
    vec3 drawn = cross(dFdx(place), dFdy(place));
    drawn = drawn * (sign(drawn.z) / max(length(drawn), 1e-9));
    if (1.0 - drawn.z > steep + 0.1)
    {
        tilt = drawn.xy;
        steep = 1.0 - drawn.z;
    }
#endif
    vec2 size = abs(tilt);
    along = size.x > size.y ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0);
    if (min(size.x, size.y) > 0.414 * max(size.x, size.y)) along = vec3(0.6875, tilt.x * tilt.y > 0.0 ? -0.6875 : 0.6875, 0.0);
    float share = smoothstep(0.30, 0.45, steep);
    vec2 on = onGround(place, along, true);
    vec2 alongX = onGround(dFdx(place), along, true), alongY = onGround(dFdy(place), along, true);
    // No branch: software drawing leaves out a loop that no pixel of a group enters.
    for (int i = share > 0.0 ? 0 : 1; i < 1; ++i)
    {
        mat2 turned = mat2(2.0, -1.0, 1.0, 2.0) * (1.0 / 64.0);
        g.metres2 = mix(g.metres2, grazingGrain(on * 0.5, alongX * 0.5, alongY * 0.5), share);
        g.metres28 = mix(g.metres28, grazingGrain(turned * on, turned * alongX, turned * alongY), share);
    }
    return share;
}

// Returns the slope of the bumps. `bumpiness`: one weight per layer; `wood`: share of treetops, some metres wide and high.
vec2 bumps(Grain g, vec4 bumpiness, float roughness, float wood)
{
    vec2 b = g.metres2.xy * bumpiness.x + g.metres28.xy * (bumpiness.y + 0.5 * wood);
    b += g.metres324.xy * bumpiness.z + g.metres4700.xy * bumpiness.w;
    return b * roughness;
}
