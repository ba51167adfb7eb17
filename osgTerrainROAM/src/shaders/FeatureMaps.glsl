// SPDX-License-Identifier: Apache-2.0
// Reads the mip-mapped maps of the features' shares.

uniform sampler2D featureFarCrops; // shares of each crop; not there with FarFeatures
uniform sampler2D featureFarBeds;  // shares of river, asphalt, gravel, runway
uniform float featureFarTexelM;

// A position in the maps, 0 to 1. `place`: the wrapped position, metres.
vec2 featureMapPlace(vec2 place)
{
    vec2 cell = place / featureCellM + vec2(terrainEyeWraps.xy * int(4096.0 / featureCellM) - featureGrid.xy);
    return cell / vec2(featureGrid.zw);
}

// The scale from metres to the maps.
vec2 featureMapScale() { return 1.0 / (featureCellM * vec2(featureGrid.zw)); }

// A part of a road's asphalt is white paint.
Paint paintOfShares(vec4 crops, vec4 beds)
{
    return Paint(crops, beds, vec4(0.03 * beds.y + 0.07 * beds.w, 0.05 * beds.y, 0.25, 0.02 * beds.w), vec2(0.12, 1.0));
}

Paint paintOfMaps(vec2 place, Footprint f)
{
    vec2 at = featureMapPlace(place), scale = featureMapScale();
    return paintOfShares(textureGrad(featureFarCrops, at, f.x * scale, f.y * scale),
                         textureGrad(featureFarBeds, at, f.x * scale, f.y * scale));
}
