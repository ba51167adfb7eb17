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
)";
}

} // namespace osgTerrainROAM
