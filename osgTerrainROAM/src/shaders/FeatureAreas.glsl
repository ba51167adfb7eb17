// SPDX-License-Identifier: Apache-2.0
// Paints areas: fields with rows of plants, water, paved areas. Each area is a polygon in the records of its cell.

// Returns, for rows of plants, the share of visible soil between them, and the brightness of this field.
vec2 rowsOf(vec4 head, vec4 rows, vec2 at, Footprint f)
{
    vec2 across = vec2(-rows.y, rows.x);
    float x = dot(at, across) + rows.z, y = dot(at, rows.xy) + rows.w;
    float wide = widthAlong(f, across), far = widthAlong(f, rows.xy);
    float shade = 1.0 + 0.5 * (head.w / 63.0 - 0.5);
    // From afar the mean counts.
    if (wide > 12.0) return vec2(kMeanSoil[int(head.z)], shade);
    // Tracks of the sprayer's wheels, every 24 m.
    float tracks = coveredDashes(x, wide, 24.0, 0.45) + coveredDashes(x - 1.8, wide, 24.0, 0.45);
    shade *= 1.0 + 0.08 * (coveredDashes(x, wide, 6.0, 3.0) - 0.5);
    if (head.z < 0.5) return vec2(min(tracks + 0.25 * coveredDashes(x, wide, 0.25, 0.10), 1.0), shade);
    if (head.z < 1.5) return vec2(min(tracks + coveredDashes(x, wide, 0.75, 0.30), 1.0), shade);
    if (head.z < 2.5) return vec2(0.0, shade);
    return vec2(1.0 - coveredDashes(x, wide, 4.0, 2.4) * (0.3 + 0.7 * coveredDashes(y, far, 3.0, 2.2)), shade);
}

// The slope of what the plough and the harrow left, along the rows: wheat in drills of 25 cm, row crops on ridges of 75 cm, strips between
// trees. A wave that fades into level ground before a pixel is as wide as half of it.
vec2 furrowsOf(vec4 head, vec4 rows, vec2 at, Footprint f)
{
    vec2 across = vec2(-rows.y, rows.x);
    vec2 shape = head.z < 0.5 ? vec2(0.25, 0.22) : head.z < 1.5 ? vec2(0.75, 0.55) : vec2(0.25, 0.0); // period, steepest slope
    float shown = max(1.0 - 2.0 * widthAlong(f, across) / shape.x, 0.0);
    // Soil lies in the furrow: bare from 0 to four tenths of the period.
    float x = dot(at, across) + rows.z - 0.2 * shape.x;
    return across * (shape.y * shown * sin(6.2831853 * x / shape.x));
}

void paintArea(inout Paint paint, vec4 head, vec4 rows, float signedEdge, float width, vec2 at, Footprint f)
{
    float share = clamp(0.5 + signedEdge / width, 0.0, 1.0);
    bool isField = head.y < 0.5;
    // No branch: software drawing leaves out a loop that no pixel of a group enters.
    for (int i = isField && share > 0.0 ? 0 : 1; i < 1; ++i)
    {
        paint.crops *= 1.0 - share;
        paint.crops[int(head.z)] += share;
        paint.rows = mix(paint.rows, rowsOf(head, rows, at, f), share);
        paint.slope = mix(paint.slope, furrowsOf(head, rows, at, f), share);
    }
    if (isField) return;
    vec3 kinds = vec3(head.y < 1.5, head.y >= 1.5 && head.y < 2.5, head.y >= 2.5);
    paint.beds.xyw = max(paint.beds.xyw, share * kinds);
}

// Tests inside and outside with a ray to the east (even-odd rule), and filters the nearest edge along its normal.
// Returns the record behind the areas.
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
