// SPDX-License-Identifier: Apache-2.0
// Paints features that stand for meshes near the eye: from farFeatureNearestM on, by a map of beds alone. A far pixel covers more ground
// than a road is wide, so the exact lists of the cells would show no more; software drawing paid three times as much for them as for all
// other ground.

uniform sampler2D farFeatureBeds; // shares of river, asphalt, gravel, runway
uniform ivec4 farFeatureGrid;     // first cell, number of cells
uniform float farFeatureCellM;
uniform float farFeatureNearestM;

void addFarFeatures(inout Paint paint, vec2 place, vec2 alongX, vec2 alongY)
{
    bool wide = dot(alongX, alongX) > dot(alongY, alongY);
    vec2 scale = featureMapScale(farFeatureGrid, farFeatureCellM);
    vec2 at = featureMapPlace(place, farFeatureGrid, farFeatureCellM);
#ifdef PICTURE_LOW
    const int kParts = 1;
#else
    const int kParts = 4;
#endif
    vec2 part = scale * (wide ? alongX : alongY) / float(kParts), shorter = scale * (wide ? alongY : alongX);
    bool isPainted = length(fromEye) >= farFeatureNearestM && all(lessThan(abs(at - 0.5), 0.5 + 0.5 * float(kParts) * abs(part)));
    vec4 beds = vec4(0.0);
    // No branch: software drawing leaves out a loop that no pixel of a group enters.
    for (int i = isPainted ? 0 : kParts; i < kParts; ++i)
        beds += textureGrad(farFeatureBeds, at + part * (float(i) - 0.5 * float(kParts - 1)), part, shorter) / float(kParts);
    paint.beds = max(paint.beds, beds);
    // The gravel beside a road's paving, which near by is a part of its mesh: 0.7 m on both sides of some 7 m.
    paint.beds.z = max(paint.beds.z, 0.2 * beds.y * (1.0 - beds.y));
    paint.marks = max(paint.marks, marksOfBeds(beds));
}
