// SPDX-License-Identifier: Apache-2.0
// Reads the mip-mapped maps of the features' shares. Runways are computed: filtered by a map they would be lost from where a pilot looks for them.

uniform sampler2D featureFarCrops; // shares of each crop
uniform sampler2D featureFarBeds;  // shares of river, asphalt, gravel, runway; where runways are computed, shade of fields
uniform float featureFarTexelM;

// Runways: their ends in metres from the first cell, and half their widths.
uniform int featureRunwayCount; // -1: they are too many, and in the map
uniform vec4 featureRunways[16];
uniform float featureRunwayHalfM[16];

// How far from its end a runway's aiming point begins.
float aimingPointM(float lengthM) { return lengthM < 1200.0 ? 250.0 : lengthM < 2400.0 ? 300.0 : 400.0; }

// The white share of a footprint `size` (along, across) at `at` (along from one end, aside from the middle line) on a runway: what
// RunwayStrokes.cpp paints, but for designators; bars and dashes by their mean.
float runwayWhite(vec2 at, vec2 size, float lengthM, float halfM)
{
    float line = halfM < 15.0 ? 0.45 : 0.9, middle = halfM < 15.0 ? 0.3 : 0.9;
    float whole = covered(at.x, size.x, 0.0, lengthM);
    float white = whole * coveredTwice(at.y, size.y, halfM - line, halfM);
    white += 0.6 * covered(at.x, size.x, 69.0, lengthM - 69.0) * covered(at.y, size.y, -0.5 * middle, 0.5 * middle);
    float bars = covered(at.x, size.x, 6.0, 36.0) + covered(at.x, size.x, lengthM - 36.0, lengthM - 6.0);
    white += 0.5 * bars * coveredTwice(at.y, size.y, 0.9, halfM - 2.7);
    float from = aimingPointM(lengthM), to = from + (lengthM < 1200.0 ? 30.0 : 45.0);
    float inner = 0.5 * min(0.6 * halfM, 18.0), wide = lengthM < 1200.0 ? 4.0 : 6.0;
    float aims = covered(at.x, size.x, from, to) + covered(at.x, size.x, lengthM - to, lengthM - from);
    return white + (lengthM > 800.0 ? aims * coveredTwice(at.y, size.y, inner, inner + wide) : 0.0);
}

// The mean of the rubber that RunwayStrokes.cpp paints.
float runwayRubber(vec2 at, vec2 size, float lengthM)
{
    if (lengthM <= 800.0) return 0.0;
    float from = aimingPointM(lengthM) - 60.0, to = from + 200.0;
    float along = covered(at.x, size.x, from, to) + covered(at.x, size.x, lengthM - to, lengthM - from);
    return 0.3 * along * covered(at.y, size.y, -4.0, 4.0);
}

// The shares of a footprint on runways, of their marks, and of rubber on them. `at`: metres from the first cell. Exact across and along a runway where the
// footprint lies so.
vec3 runwayShares(vec2 at, Footprint f)
{
    vec3 shares = vec3(0.0);
    for (int i = 0; i < featureRunwayCount; ++i)
    {
        vec2 way = featureRunways[i].zw - featureRunways[i].xy;
        float lengthM = length(way), halfM = featureRunwayHalfM[i];
        vec2 along = way / lengthM, left = vec2(-along.y, along.x), away = at - featureRunways[i].xy;
        vec2 place = vec2(dot(away, along), dot(away, left));
        vec2 size = max(vec2(abs(dot(f.x, along)) + abs(dot(f.y, along)), abs(dot(f.x, left)) + abs(dot(f.y, left))), vec2(1e-3));
        float share = covered(place.y, size.y, -halfM, halfM) * covered(place.x, size.x, 0.0, lengthM);
        shares.x = max(shares.x, share);
        // No branch: software drawing leaves out a loop that no pixel of a group enters.
        for (int j = share > 0.0 && lengthM >= 200.0 && halfM >= 4.0 ? 0 : 1; j < 1; ++j)
        {
            shares.y = max(shares.y, runwayWhite(place, size, lengthM, halfM));
            shares.z = max(shares.z, runwayRubber(place, size, lengthM));
        }
    }
    return shares;
}

// `f`: the whole footprint, its longer side first; the maps are read over a quarter of that.
Paint paintOfMaps(vec2 place, Footprint f)
{
    vec2 at = featureMapPlace(place, featureGrid, featureCellM), scale = featureMapScale(featureGrid, featureCellM);
    vec2 part = 0.25 * f.x * scale, shorter = f.y * scale;
    vec4 beds = textureGrad(featureFarBeds, at, part, shorter);
    vec4 crops = textureGrad(featureFarCrops, at, part, shorter);
    float share = max(dot(crops, vec4(1.0)), 1e-3), shade = 0.5;
    vec4 marks = marksOfBeds(beds);
    float rubber = 0.0;
    if (featureRunwayCount >= 0)
    {
        shade = min(beds.w / share, 1.0);
        vec3 runway = runwayShares(at / scale, f);
        beds.w = runway.x;
        marks = marksOfBeds(vec4(beds.xyz, 0.0));
        marks.xw += vec2(runway.y, 0.02 * runway.x);
        rubber = runway.z;
    }
    return Paint(crops, beds, marks, vec2(dot(crops, kMeanSoil) / share, 0.75 + 0.5 * shade), vec2(0.0), vec2(0.0, rubber));
}
