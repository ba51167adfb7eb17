// SPDX-License-Identifier: Apache-2.0
#include "FeatureShader.h"

namespace osgTerrainROAM
{

const char* featurePaintGlsl()
{
    return R"(
uniform vec3 featureCrops[4];
uniform vec3 featureSoil;

Paint paintInCell(vec2 place, Footprint f)
{
    Paint paint = Paint(vec4(0.0), vec4(0.0), vec4(0.0), vec2(0.0, 1.0));
    vec2 cell = floor(place / featureCellM);
    ivec2 index = ivec2(cell) + terrainEyeWraps.xy * int(4096.0 / featureCellM) - featureGrid.xy;
    if (any(lessThan(index, ivec2(0))) || any(greaterThanEqual(index, featureGrid.zw))) return paint;
    vec4 list = texelFetch(featureCells, index, 0);
    if (list.y + list.z + list.w == 0.0) return paint;
    vec2 at = place - (cell + 0.5) * featureCellM;
    int record = int(list.x);
    if (list.y > 0.0) record = paintAreas(paint, record, int(list.y), at, f);
    if (list.z > 0.0) record = paintLines(paint, record, int(list.z), at, f);
    if (list.w > 0.0) paintStrokes(paint, record, int(list.w), at, f);
    return paint;
}

// From mip-mapped shares: of a road's asphalt some is paint.
Paint paintOfMaps(vec2 place, Footprint f)
{
    vec2 cell = place / featureCellM + vec2(terrainEyeWraps.xy * int(4096.0 / featureCellM) - featureGrid.xy);
    vec2 scale = 1.0 / vec2(featureGrid.zw);
    vec2 x = f.x / featureCellM * scale, y = f.y / featureCellM * scale;
    Paint paint;
    paint.crops = textureGrad(featureFarCrops, cell * scale, x, y);
    paint.beds = textureGrad(featureFarBeds, cell * scale, x, y);
    paint.marks = vec4(0.03 * paint.beds.y + 0.07 * paint.beds.w, 0.05 * paint.beds.y, 0.25, 0.02 * paint.beds.w);
    paint.rows = vec2(0.12, 1.0);
    return paint;
}

Paint mixed(Paint a, Paint b, float t)
{
    return Paint(mix(a.crops, b.crops, t), mix(a.beds, b.beds, t), mix(a.marks, b.marks, t), mix(a.rows, b.rows, t));
}

// A long footprint is cut into up to four across its length; where even these are longer than the lists reach, or the pixel
// is as wide as a texel of the far maps, those take over.
Paint terrainPaint(vec2 place, vec2 alongX, vec2 alongY)
{
    bool wide = dot(alongX, alongX) > dot(alongY, alongY);
    vec2 longer = wide ? alongX : alongY;
    vec2 shorter = wide ? alongY : alongX;
    float length1 = length(longer);
    float across = abs(alongX.x * alongY.y - alongX.y * alongY.x) / max(length1, 1e-9);
    float far = max(smoothstep(96.0, 160.0, length1), smoothstep(0.5, 1.0, across / featureFarTexelM));
    Footprint whole = Footprint(longer, shorter);
    Paint distant;
    if (far > 0.0) distant = paintOfMaps(place, Footprint(0.25 * longer, shorter));
    if (far >= 1.0) return distant;
    int taps = int(clamp(ceil(length1 / 24.0), 1.0, 4.0));
    Footprint f = Footprint(longer / float(taps), shorter);
    Paint paint = paintInCell(place + longer * (0.5 / float(taps) - 0.5), f);
    for (int i = 1; i < taps; ++i)
    {
        Paint more = paintInCell(place + longer * ((float(i) + 0.5) / float(taps) - 0.5), f);
        paint = mixed(paint, more, 1.0 / float(i + 1));
    }
    paint.marks.w *= float(taps); // a lamp is a point, not a share of the footprint
    return far > 0.0 ? mixed(paint, distant, far) : paint;
}

// Of what lies on top: nothing grows where the river, a road or a runway is.
float openShare(Paint paint) { return 1.0 - max(max(paint.beds.x, paint.beds.y), max(paint.beds.z, paint.beds.w)); }

vec4 fieldAlbedo(vec4 ground, Paint paint, Grain g)
{
    float share = dot(paint.crops, vec4(1.0));
    vec3 colour = featureCrops[0] * paint.crops.x + featureCrops[1] * paint.crops.y + featureCrops[2] * paint.crops.z
                + featureCrops[3] * paint.crops.w;
    colour = colour * (paint.rows.y * (1.0 - paint.rows.x)) + featureSoil * (share * paint.rows.x);
    colour *= 1.0 + 0.5 * g.metres2.z + 0.25 * g.metres28.z + 0.2 * g.metres324.w;
    return vec4(ground.rgb * (1.0 - min(share, 1.0)) + colour, ground.a * (1.0 - min(share, 1.0)));
}

// Lamps burn from dusk to dawn.
vec3 paintLight(Paint paint)
{
    float night = smoothstep(0.02, -0.09, sunDirection().z);
    return vec3(3.2, 2.7, 1.9) * (min(paint.marks.w, 1.5) * night);
}

vec3 pavedAlbedo(vec3 albedo, Paint paint, Grain g)
{
    float worn = smoothstep(0.25, 0.75, paint.marks.y + 0.9 * g.metres2.w + 0.5 * g.metres28.w);
    albedo = mix(albedo, featureSoil * 1.1, worn * min(2.0 * paint.marks.y, 0.75));
    vec3 gravel = vec3(0.27, 0.24, 0.195) * (1.0 + 0.7 * g.metres2.z + 0.3 * g.metres28.z);
    albedo = mix(albedo, gravel, paint.beds.z);
    float stone = 1.0 + 0.35 * g.metres2.z + 0.15 * g.metres28.z + 0.12 * g.metres324.w;
    albedo = mix(albedo, vec3(0.088, 0.087, 0.086) * stone * (1.0 - 0.14 * paint.marks.z), paint.beds.y);
    albedo = mix(albedo, vec3(0.070, 0.071, 0.073) * stone, paint.beds.w);
    float paved = max(paint.beds.y, paint.beds.w);
    return mix(albedo, vec3(0.60, 0.60, 0.57) * (1.0 + 0.25 * g.metres2.z), min(paint.marks.x, paved) * 0.92);
}
)";
}

} // namespace osgTerrainROAM
