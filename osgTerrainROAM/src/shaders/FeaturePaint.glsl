// SPDX-License-Identifier: Apache-2.0
// Finds the features under a pixel: Paint listedPaint(vec2 place, vec2 alongX, vec2 alongY). `place`: the wrapped position, metres; the
// others: its derivatives. Near features come from cells, far ones from mip-mapped maps of shares. Pictures of low quality have the maps
// alone, but for what rules need: cells with strokes, as those of runways and taxiways, are drawn whole, and of others the roads with markings.

// The list of a cell: its first record, numbers of areas, lines and strokes; zeros where there is none. `at`: from the cell's middle, metres.
vec4 cellAt(vec2 place, out vec2 at)
{
    vec2 cell = floor(place / featureCellM);
    at = place - (cell + 0.5) * featureCellM;
    ivec2 index = ivec2(cell) + terrainEyeWraps.xy * int(4096.0 / featureCellM) - featureGrid.xy;
    if (any(lessThan(index, ivec2(0))) || any(greaterThanEqual(index, featureGrid.zw))) return vec4(0.0);
    return texelFetch(featureCells, index, 0);
}

bool listsMarkedRoad(vec4 list) { return fract(list.z) > 0.25; }

Paint paintInCell(vec2 place, Footprint f)
{
    Paint paint = kNoPaint;
    vec2 at;
    vec4 list = cellAt(place, at);
    if (list.y + list.z + list.w == 0.0) return paint;
    int record = int(list.x);
#ifdef PICTURE_LOW
    if (list.w == 0.0)
    {
        for (int i = 0; i < int(list.y); ++i) record += 2 + int(featureRecord(record).x);
        if (listsMarkedRoad(list)) paintLines(paint, record, int(list.z), at, f);
        return paint;
    }
#endif
    if (list.y > 0.0) record = paintAreas(paint, record, int(list.y), at, f);
    if (list.z > 0.0) record = paintLines(paint, record, int(list.z), at, f);
    if (list.w > 0.0) paintStrokes(paint, record, int(list.w), at, f);
    return paint;
}

Paint mixed(Paint a, Paint b, float t)
{
    return Paint(mix(a.crops, b.crops, t), mix(a.beds, b.beds, t), mix(a.marks, b.marks, t), mix(a.rows, b.rows, t),
                 mix(a.slope, b.slope, t), mix(a.more, b.more, t));
}

// Divides a long footprint into up to four parts along its length. The far maps replace the cells where the parts are longer
// than the reach of the lists, or the pixel is as wide as a texel of the maps.
Paint listedPaint(vec2 place, vec2 alongX, vec2 alongY)
{
    bool wide = dot(alongX, alongX) > dot(alongY, alongY);
    vec2 longer = wide ? alongX : alongY;
    vec2 shorter = wide ? alongY : alongX;
    float length1 = length(longer);
    float across = abs(alongX.x * alongY.y - alongX.y * alongY.x) / max(length1, 1e-9);
    float far = max(smoothstep(96.0, 160.0, length1), smoothstep(0.5, 1.0, across / featureFarTexelM));
#ifdef PICTURE_LOW
    vec2 at;
    vec4 list = cellAt(place, at);
    if (list.w == 0.0 && !listsMarkedRoad(list)) far = 1.0;
#endif
    Footprint whole = Footprint(longer, shorter);
    Paint paint = kNoPaint;
    // No branches: software drawing leaves out a loop that no pixel of a group enters.
    int taps = far < 1.0 ? int(clamp(ceil(length1 / 24.0), 1.0, 4.0)) : 0;
    Footprint f = Footprint(longer / float(max(taps, 1)), shorter);
    for (int i = 0; i < taps; ++i)
    {
        Paint more = paintInCell(place + longer * ((float(i) + 0.5) / float(taps) - 0.5), f);
        paint = mixed(paint, more, 1.0 / float(i + 1));
    }
    paint.marks.w *= float(taps); // a lamp is a point, its light is no share of the footprint
#ifdef PICTURE_LOW
    Paint listed = paint;
    paint = paintOfMaps(place, whole);
    // Where a texel is wider than a pixel the blended shares of crops are made steeper, so that fields have an edge.
    float blur = clamp(length1 / featureFarTexelM, 0.1, 1.0);
    paint.crops = clamp(0.5 + (paint.crops - 0.5) / blur, 0.0, 1.0);
    if (list.w > 0.0)
        paint = mixed(listed, paint, far);
    else
    {
        paint.beds.y = mix(max(listed.beds.y, paint.beds.y), paint.beds.y, far);
        paint.marks.x = mix(listed.marks.x, paint.marks.x, far);
    }
#else
    for (int i = far > 0.0 ? 0 : 1; i < 1; ++i)
        paint = mixed(paint, paintOfMaps(place, whole), far);
#endif
    return paint;
}
