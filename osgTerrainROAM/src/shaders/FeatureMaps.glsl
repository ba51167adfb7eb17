// SPDX-License-Identifier: Apache-2.0
// Reads the mip-mapped maps of the features' shares. Runways are computed: filtered by a map they would be lost from where a pilot looks for them.

uniform sampler2D featureFarCrops; // shares of each crop
uniform sampler2D featureFarBeds;  // shares of river, asphalt, gravel, runway
uniform float featureFarTexelM;

// Runways: their ends in metres from the first cell, and half their widths.
uniform int featureRunwayCount;
uniform vec4 featureRunways[16];
uniform float featureRunwayHalfM[16];

// The share of a footprint on runways. `at`: metres from the first cell. Exact across and along a runway where the footprint lies so.
float runwayShare(vec2 at, Footprint f)
{
    float share = 0.0;
    for (int i = 0; i < featureRunwayCount; ++i)
    {
        vec2 way = featureRunways[i].zw - featureRunways[i].xy;
        float lengthM = length(way);
        vec2 along = way / lengthM, left = vec2(-along.y, along.x), away = at - featureRunways[i].xy;
        float width = max(abs(dot(f.x, left)) + abs(dot(f.y, left)), 1e-3);
        float reach = max(abs(dot(f.x, along)) + abs(dot(f.y, along)), 1e-3);
        share = max(share, covered(dot(away, left), width, -featureRunwayHalfM[i], featureRunwayHalfM[i]) *
                               covered(dot(away, along), reach, 0.0, lengthM));
    }
    return share;
}

// `f`: the whole footprint, its longer side first; the maps are read over a quarter of that.
Paint paintOfMaps(vec2 place, Footprint f)
{
    vec2 at = featureMapPlace(place, featureGrid, featureCellM), scale = featureMapScale(featureGrid, featureCellM);
    vec2 part = 0.25 * f.x * scale, shorter = f.y * scale;
    vec4 beds = textureGrad(featureFarBeds, at, part, shorter);
    if (featureRunwayCount > 0) beds.w = runwayShare(at / scale, f);
    vec4 crops = textureGrad(featureFarCrops, at, part, shorter);
    float soil = dot(crops, kMeanSoil) / max(dot(crops, vec4(1.0)), 1e-3);
    return Paint(crops, beds, marksOfBeds(beds), vec2(soil, 1.0), vec2(0.0));
}
