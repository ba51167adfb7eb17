// SPDX-License-Identifier: Apache-2.0
// Reads the mip-mapped maps of the features' shares.

uniform sampler2D featureFarCrops; // shares of each crop
uniform sampler2D featureFarBeds;  // shares of river, asphalt, gravel, runway
uniform float featureFarTexelM;

Paint paintOfMaps(vec2 place, Footprint f)
{
    vec2 at = featureMapPlace(place, featureGrid, featureCellM), scale = featureMapScale(featureGrid, featureCellM);
    vec4 beds = textureGrad(featureFarBeds, at, f.x * scale, f.y * scale);
    return Paint(textureGrad(featureFarCrops, at, f.x * scale, f.y * scale), beds, marksOfBeds(beds), vec2(0.12, 1.0));
}
