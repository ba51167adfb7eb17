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
vec4 grazingGrain(vec2 at)
{
#ifdef PICTURE_LOW
    const float kMostSamples = 1.0;
#elif defined(PICTURE_MEDIUM)
    const float kMostSamples = 2.0;
#else
    const float kMostSamples = 4.0;
#endif
    vec2 alongX = dFdx(at);
    vec2 alongY = dFdy(at);
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

// Returns the slope of the bumps. `bumpiness`: one weight per layer; `wood`: share of treetops, some metres wide and high.
vec2 bumps(Grain g, vec4 bumpiness, float roughness, float wood)
{
    vec2 b = g.metres2.xy * bumpiness.x + g.metres28.xy * (bumpiness.y + 0.5 * wood);
    b += g.metres324.xy * bumpiness.z + g.metres4700.xy * bumpiness.w;
    return b * roughness;
}
