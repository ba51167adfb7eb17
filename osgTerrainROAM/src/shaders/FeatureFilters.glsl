// SPDX-License-Identifier: Apache-2.0
// Declares the vector features' textures and the shares that they paint, and filters bands over a pixel's footprint.
// The filters are exact integrals over the footprint's width, so a line thinner than a pixel becomes its share of it.
// Features are drawn by the parts FeatureFilters, then Maps, Areas, Lines, Strokes, Paint, then FarFeatures, then Colours, in this order; either
// of the two in the middle may be missing.
// Source of the lists: Nehab and Hoppe, Random-access rendering of general vector graphics (2008), section 3.

uniform sampler2D featureCells;     // per cell: first record; numbers of areas, lines (and a half: a road has markings), strokes
uniform sampler2D featureRecords;   // FeatureCells.h; 1024 in a row
uniform ivec4 featureGrid;          // first cell, number of cells
uniform float featureCellM;

const float kFeatureReachM = 16.0;

struct Paint
{
    vec4 crops; // share of each crop
    vec4 beds;  // shares of river, asphalt, gravel, runway
    vec4 marks; // shares of white, worn verge, wheel tracks; light
    vec2 rows;  // share of bare soil between the plants; shade
    vec2 slope; // of furrows and ridges, east and north
    vec2 more;  // shares of yellow lines of taxiways, and of rubber of tyres on runways
};

const vec4 kMeanSoil = vec4(0.14, 0.44, 0.0, 0.51); // that is seen between the plants of each crop

const Paint kNoPaint = Paint(vec4(0.0), vec4(0.0), vec4(0.0), vec2(0.0, 1.0), vec2(0.0), vec2(0.0));

// The pixel's footprint on the ground: the vectors of one pixel to the right and one pixel up, metres.
struct Footprint
{
    vec2 x, y;
};

float widthAlong(Footprint f, vec2 direction)
{
    return clamp(abs(dot(f.x, direction)) + abs(dot(f.y, direction)), 1e-3, 2.0 * kFeatureReachM);
}

// The share of a box filter, centred at x, that lies within low ... high.
float covered(float x, float width, float low, float high)
{
    return max(min(x + 0.5 * width, high) - max(x - 0.5 * width, low), 0.0) / width;
}

// The same for the band and its mirror image.
float coveredTwice(float x, float width, float low, float high)
{
    return covered(x, width, low, high) + covered(x, width, -high, -low);
}

// The same for bands 0 ... on that repeat with every period.
float coveredDashes(float x, float width, float period, float on)
{
    vec2 ends = vec2(x + 0.5 * width, x - 0.5 * width) / period;
    vec2 whole = floor(ends);
    vec2 filled = whole * (on / period) + min(ends - whole, vec2(on / period));
    return (filled.x - filled.y) * period / width;
}

// A position in the maps of shares, 0 to 1. `place`: the wrapped position, metres; `grid`, `cellM`: of the cells.
vec2 featureMapPlace(vec2 place, ivec4 grid, float cellM)
{
    vec2 cell = place / cellM + vec2(terrainEyeWraps.xy * int(4096.0 / cellM) - grid.xy);
    return cell / vec2(grid.zw);
}

// The scale from metres to these maps.
vec2 featureMapScale(ivec4 grid, float cellM) { return 1.0 / (cellM * vec2(grid.zw)); }

// What the shares of beds mean for marks: a part of a road's asphalt is white paint.
vec4 marksOfBeds(vec4 beds) { return vec4(0.015 * beds.y + 0.07 * beds.w, 0.05 * beds.y, 0.25, 0.02 * beds.w); }

vec4 featureRecord(int index) { return texelFetch(featureRecords, ivec2(index & 1023, index >> 10), 0); }
