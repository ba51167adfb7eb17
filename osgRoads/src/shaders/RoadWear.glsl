// SPDX-License-Identifier: Apache-2.0
// What years and wheels do to asphalt and gravel, by the lane's own coordinates: patches with sealed edges, cracks across, oil between the
// wheels, the black of tyres that braked. Each is covered by its share of the footprint, so it fades into its mean. After RoadMarks. GLSL 1.30.
// PICTURE_LOW leaves it out.

// Two tracks that wheels have polished, 0 ... 1. `place`: share of the lane's width.
float roadTracksAt(float place, float sharp) { return max(1.0 - abs(abs(place - 0.5) - 0.24) * sharp, 0.0); }

// A random number of a cell along this lane.
float roadRandom(float cell, float salt)
{
    vec2 seed = vec2(mod(cell, 512.0), salt + float(roadMarkRows.x & 255)); // nothing that is interpolated
    return fract(sin(dot(seed, vec2(12.9898, 78.233))) * 43758.5453);
}

// The share of the footprint within `from` ... `from` + `lengthM` along the lane.
float roadAlongCover(float from, float lengthM, vec2 filters)
{
    return roadLineCover(roadAt.x - from - 0.5 * lengthM, 0.5 * lengthM, filters.x);
}

// Returns by how much asphalt is brighter. `waver`: noise of some metres.
float roadWearOfAsphalt(float waver, vec2 filters)
{
#ifdef PICTURE_LOW
    return 1.0;
#else
    float across = roadAt.y / max(roadAt.z, 0.1);
    float light = 1.0 - 0.10 * max(1.0 - 5.0 * abs(across - 0.5), 0.0); // oil
    float cell = floor(roadAt.x / 7.0), first = 7.0 * cell + 1.0;
    // Cracks lie across, and waver; some are sealed with tar.
    float at = first + 5.0 * roadRandom(cell, 1.0) + 0.7 * waver;
    float tar = step(roadRandom(cell, 2.0), 0.25);
    light *= 1.0 - step(roadRandom(cell, 3.0), 0.45) * (0.35 + 0.3 * tar) * roadLineCover(roadAt.x - at, 0.008 + 0.02 * tar, filters.x);
    // Patches where the road was opened.
    cell = floor(roadAt.x / 31.0);
    float longM = 1.0 + 4.0 * roadRandom(cell, 4.0), wideM = 0.6 + 0.9 * roadRandom(cell, 5.0);
    float middle = mix(wideM, roadAt.z - wideM, roadRandom(cell, 6.0));
    float start = 31.0 * cell + 24.0 * roadRandom(cell, 7.0), there = step(roadRandom(cell, 8.0), 0.35);
    vec2 inner = vec2(roadAlongCover(start, longM, filters), roadLineCover(roadAt.y - middle, 0.5 * wideM, filters.y));
    vec2 outer = vec2(roadAlongCover(start - 0.04, longM + 0.08, filters), roadLineCover(roadAt.y - middle, 0.5 * wideM + 0.04, filters.y));
    float patch_ = inner.x * inner.y, seam = outer.x * outer.y - patch_;
    light *= 1.0 - there * (0.20 * patch_ + 0.45 * seam);
    // Tyres that braked: both tracks, darker towards their end.
    cell = floor(roadAt.x / 47.0);
    longM = 5.0 + 13.0 * roadRandom(cell, 9.0);
    start = 47.0 * cell + 25.0 * roadRandom(cell, 10.0);
    float wheel = abs(abs(roadAt.y - 0.5 * roadAt.z) - 0.74);
    float skid = step(roadRandom(cell, 11.0), 0.3) * roadAlongCover(start, longM, filters) * roadLineCover(wheel, 0.1, filters.y);
    return light * (1.0 - skid * mix(0.12, 0.45, clamp((roadAt.x - start) / longM, 0.0, 1.0)));
#endif
}

// The stones of the surface: noise of 4 mm, filtered along the footprint at a grazing angle.
vec3 roadStones()
{
    vec2 at = roadGround * 0.5;
#if defined(PICTURE_LOW) || defined(PICTURE_MEDIUM)
    return texture(roadGrain, at).rgb - 0.5;
#else
    const float kSamples = 4.0;
    vec2 x = dFdx(at), y = dFdy(at);
    bool isWide = dot(x, x) > dot(y, y);
    vec2 part = (isWide ? x : y) / kSamples, shorter = isWide ? y : x;
    vec3 sum = vec3(0.0);
    for (float i = 0.5; i < kSamples; ++i)
        sum += textureGrad(roadGrain, at + (i - 0.5 * kSamples) * part, part, shorter).rgb;
    return sum / kSamples - 0.5;
#endif
}
