// SPDX-License-Identifier: Apache-2.0
// Paints features that stand for meshes near the eye: from farFeatureNearestM on, by a map of beds alone. A far pixel covers more ground
// than a road is wide, so the exact lists of the cells would show no more; software drawing paid three times as much for them as for all
// other ground. Seen at a grazing angle a mesh is thinner than a pixel and breaks up long before: there it is painted from 0.3 of that on,
// where a pixel is longer than kThinM.

uniform sampler2D farFeatureBeds; // shares of river, asphalt, gravel, runway
uniform ivec4 farFeatureGrid;     // first cell, number of cells
uniform float farFeatureCellM;
uniform float farFeatureNearestM;

const float kThinM = 4.5; // a lane and a half: a row of pixels that meets no road of two lanes is farther from the next

void addFarFeatures(inout Paint paint, vec2 place, vec2 alongX, vec2 alongY)
{
    bool wide = dot(alongX, alongX) > dot(alongY, alongY);
    vec2 scale = featureMapScale(farFeatureGrid, farFeatureCellM);
    vec2 at = featureMapPlace(place, farFeatureGrid, farFeatureCellM);
    vec2 longer = wide ? alongX : alongY;
    float lengthM = length(longer), distanceM = length(fromEye);
#ifdef PICTURE_LOW
    int parts = lengthM < 8.0 ? 1 : 2;
#else
    int parts = lengthM < 8.0 ? 2 : 4;
#endif
    vec2 part = scale * longer / float(parts), shorter = scale * (wide ? alongY : alongX);
    float nearestM = lengthM < kThinM ? farFeatureNearestM : 0.3 * farFeatureNearestM;
    bool isPainted = distanceM >= nearestM && all(lessThan(abs(at - 0.5), 0.5 + 0.5 * float(parts) * abs(part)));
    vec4 beds = vec4(0.0);
    // No branch: software drawing leaves out a loop that no pixel of a group enters.
    for (int i = isPainted ? 0 : parts; i < parts; ++i)
        beds += textureGrad(farFeatureBeds, at + part * (float(i) - 0.5 * float(parts - 1)), part, shorter) / float(parts);
    paint.beds = max(paint.beds, beds);
    // The gravel and the mown grass beside a road's paving, which near by are a part of its mesh: 1 m on both sides of some 7 m.
    paint.beds.z = max(paint.beds.z, 0.28 * beds.y * (1.0 - beds.y) * (1.0 + 3.0 * beds.y));
    paint.marks = max(paint.marks, marksOfBeds(beds));
}
