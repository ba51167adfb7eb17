// SPDX-License-Identifier: Apache-2.0
#include "FeatureShader.h"

namespace osgTerrainROAM
{

const char* featureCellsGlsl()
{
    return R"(
uniform sampler2D featureCells;     // per cell: first record, areas, lines, strokes
uniform sampler2D featureRecords;   // 1024 a row
uniform sampler2D featureFarCrops;  // shares, for footprints wider than cells' lists reach
uniform sampler2D featureFarBeds;   // river, asphalt, gravel, runway
uniform ivec4 featureGrid;          // first cell, number of cells
uniform float featureCellM;
uniform float featureFarTexelM;

const float kFeatureReachM = 16.0;

struct Paint
{
    vec4 crops; // shares by crop
    vec4 beds;  // shares of river, asphalt, gravel, runway
    vec4 marks; // shares of white, worn verge, wheel tracks; light
    vec2 rows;  // share of bare soil between the plants; shade
};

// The pixel's footprint on the ground: how far it goes for one step across the picture and one up it.
struct Footprint
{
    vec2 x, y;
};

float widthAlong(Footprint f, vec2 direction)
{
    return clamp(abs(dot(f.x, direction)) + abs(dot(f.y, direction)), 1e-3, 2.0 * kFeatureReachM);
}

// Share of a filter of a width about x that lies within low ... high.
float covered(float x, float width, float low, float high)
{
    return max(min(x + 0.5 * width, high) - max(x - 0.5 * width, low), 0.0) / width;
}

// The same of the band and of its mirror image.
float coveredTwice(float x, float width, float low, float high)
{
    return covered(x, width, low, high) + covered(x, width, -high, -low);
}

// The same of bands 0 ... on that come again with every period.
float coveredDashes(float x, float width, float period, float on)
{
    vec2 ends = vec2(x + 0.5 * width, x - 0.5 * width) / period;
    vec2 whole = floor(ends);
    vec2 filled = whole * (on / period) + min(ends - whole, vec2(on / period));
    return (filled.x - filled.y) * period / width;
}

vec4 featureRecord(int index) { return texelFetch(featureRecords, ivec2(index & 1023, index >> 10), 0); }

// Rows of plants: what of the ground between them shows, and how much lighter or darker this field is than others.
vec2 rowsOf(vec4 head, vec4 rows, vec2 at, Footprint f)
{
    vec2 across = vec2(-rows.y, rows.x);
    float x = dot(at, across) + rows.z, y = dot(at, rows.xy) + rows.w;
    float wide = widthAlong(f, across), far = widthAlong(f, rows.xy);
    float shade = 1.0 + 0.5 * (head.w / 63.0 - 0.5);
    // From afar, their mean.
    if (wide > 12.0) return vec2(head.z < 0.5 ? 0.14 : head.z < 1.5 ? 0.44 : head.z < 2.5 ? 0.0 : 0.51, shade);
    // Wheels of the sprayer, every 24 m.
    float tracks = coveredDashes(x, wide, 24.0, 0.45) + coveredDashes(x - 1.8, wide, 24.0, 0.45);
    shade *= 1.0 + 0.08 * (coveredDashes(x, wide, 6.0, 3.0) - 0.5);
    if (head.z < 0.5) return vec2(min(tracks + 0.25 * coveredDashes(x, wide, 0.25, 0.10), 1.0), shade);
    if (head.z < 1.5) return vec2(min(tracks + coveredDashes(x, wide, 0.75, 0.30), 1.0), shade);
    if (head.z < 2.5) return vec2(0.0, shade);
    return vec2(1.0 - coveredDashes(x, wide, 4.0, 2.4) * (0.3 + 0.7 * coveredDashes(y, far, 3.0, 2.2)), shade);
}

void paintArea(inout Paint paint, vec4 head, vec4 rows, float signedEdge, float width, vec2 at, Footprint f)
{
    float share = clamp(0.5 + signedEdge / width, 0.0, 1.0);
    if (share <= 0.0) return;
    if (head.y < 0.5)
    {
        paint.crops *= 1.0 - share;
        paint.crops[int(head.z)] += share;
        paint.rows = mix(paint.rows, rowsOf(head, rows, at, f), share);
    }
    else if (head.y < 1.5)
        paint.beds.x = max(paint.beds.x, share);
    else if (head.y < 2.5)
        paint.beds.y = max(paint.beds.y, share);
    else
        paint.beds.w = max(paint.beds.w, share);
}

// Even-odd by a ray to the east; the distance counts to the nearest edge, and the filter along its normal.
int paintAreas(inout Paint paint, int record, int count, vec2 at, Footprint f)
{
    for (int i = 0; i < count; ++i)
    {
        vec4 head = featureRecord(record);
        vec4 rows = featureRecord(record + 1);
        int end = record + 2 + int(head.x);
        float nearest2 = 1e12;
        vec2 nearest = vec2(1.0, 0.0);
        bool inside = false;
        for (record += 2; record < end; ++record)
        {
            vec4 edge = featureRecord(record);
            vec2 way = edge.zw - edge.xy;
            vec2 from = at - edge.xy;
            vec2 away = from - clamp(dot(from, way) / max(dot(way, way), 1e-12), 0.0, 1.0) * way;
            float away2 = dot(away, away);
            if (away2 < nearest2)
            {
                nearest2 = away2;
                nearest = away;
            }
            if ((edge.y > at.y) != (edge.w > at.y) && edge.x + from.y / way.y * way.x > at.x) inside = !inside;
        }
        float distanceM = sqrt(nearest2);
        float width = distanceM > 1e-4 ? widthAlong(f, nearest / distanceM) : 1e-3;
        paintArea(paint, head, rows, inside ? distanceM : -distanceM, width, at, f);
    }
    return record;
}

// Edge lines, lane lines and wheel tracks at a distance from the middle and a way along the road.
vec2 roadMarks(float across, float width, float way, float widthAhead, float halfWidth, int lanes)
{
    float white = coveredTwice(across, width, halfWidth - 0.37, halfWidth - 0.25);
    float lane = (2.0 * halfWidth - 0.74) / float(lanes);
    float dashes = coveredDashes(way, widthAhead, 12.0, 4.0);
    for (int k = 1; k < lanes; ++k)
    {
        float middle = (float(k) - 0.5 * float(lanes)) * lane;
        white += covered(across, width, middle - 0.06, middle + 0.06) * (lanes > 3 && 2 * k == lanes ? 1.0 : dashes);
    }
    // Two wheel tracks a lane, a wave that fades into its mean.
    float inLane = across + ((lanes & 1) == 1 ? 0.5 * lane : 0.0);
    float tracks = 0.5 - 0.5 * cos(12.566371 * inLane / lane) * max(1.0 - 2.0 * width / lane, 0.0);
    return vec2(white, tracks);
}

int paintLines(inout Paint paint, int record, int count, vec2 at, Footprint f)
{
    float reach = 0.5 * (length(f.x) + length(f.y)) + 1.4;
    float best = 1e6, second = 1e6, bestAcross = 0.0;
    vec4 bestEnds = vec4(0.0), bestStyle = vec4(-1.0);
    vec2 bestAway = vec2(1.0, 0.0);
    for (int end = record + 2 * count; record < end; record += 2)
    {
        vec4 ends = featureRecord(record);
        vec4 style = featureRecord(record + 1);
        vec2 way = ends.zw - ends.xy;
        vec2 from = at - ends.xy;
        vec2 away = from - clamp(dot(from, way) / dot(way, way), 0.0, 1.0) * way;
        float across = length(away);
        float edge = across - style.x;
        if (edge > reach) continue;
        int code = int(style.z);
        float width = widthAlong(f, across > 1e-4 ? away / across : normalize(vec2(-way.y, way.x)));
        float share = covered(across, width, -style.x, style.x);
        if ((code & 3) == 1)
        {
            paint.beds.x = max(paint.beds.x, share);
            continue;
        }
        if (((code >> 2) & 3) == 0)
            paint.beds.y = max(paint.beds.y, share);
        else
            paint.beds.z = max(paint.beds.z, share);
        paint.marks.y = max(paint.marks.y, clamp(1.0 - edge / 1.4, 0.0, 1.0) * min(1.4 / width, 1.0));
        if (edge < best)
        {
            if (style.w != bestStyle.w) second = best;
            best = edge;
            bestAcross = across;
            bestAway = away;
            bestEnds = ends;
            bestStyle = style;
        }
        else if (style.w != bestStyle.w)
            second = min(second, edge);
    }
    if (bestStyle.z < 256.0) return record;
    // Where another road crosses, neither has markings.
    vec2 way = normalize(bestEnds.zw - bestEnds.xy);
    vec2 normal = bestAcross > 1e-4 ? bestAway / bestAcross : vec2(-way.y, way.x);
    float width = widthAlong(f, normal);
    float ahead = clamp(dot(at - bestEnds.xy, way), 0.0, distance(bestEnds.xy, bestEnds.zw)) + bestStyle.y;
    vec2 marks = roadMarks(bestAcross, width, ahead, widthAlong(f, way), bestStyle.x, (int(bestStyle.z) >> 4) & 15);
    float alone = clamp(0.5 + second / width, 0.0, 1.0);
    paint.marks.x = marks.x * alone;
    paint.marks.z = marks.y * alone;
    return record;
}

void paintStrokes(inout Paint paint, int record, int count, vec2 at, Footprint f)
{
    float area = f.x.x * f.y.y - f.x.y * f.y.x;
    for (int end = record + 2 * count; record < end; record += 2)
    {
        vec4 ends = featureRecord(record);
        vec4 style = featureRecord(record + 1);
        vec2 from = at - 0.5 * (ends.xy + ends.zw);
        if (style.y > 1.5)
        {
            // A lamp is a point of the picture, however it lies on the ground.
            vec2 pixels = vec2(from.x * f.y.y - from.y * f.y.x, from.y * f.x.x - from.x * f.x.y)
                        / (abs(area) > 1e-9 ? area : 1e-9);
            paint.marks.w += exp(-1.2 * dot(pixels, pixels)) + 0.06 * exp(-0.08 * dot(pixels, pixels));
            continue;
        }
        vec2 along = ends.zw - ends.xy;
        float lengthM = length(along);
        along /= lengthM;
        vec2 right = vec2(along.y, -along.x);
        float share = covered(dot(from, along), widthAlong(f, along), -0.5 * lengthM, 0.5 * lengthM)
                    * covered(dot(from, right), widthAlong(f, right), -style.x, style.x);
        if (style.y < 0.5)
        {
            paint.beds.w = max(paint.beds.w, share);
            paint.marks.x *= 1.0 - share;
        }
        else
            paint.marks.x += share;
    }
}
)";
}

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
