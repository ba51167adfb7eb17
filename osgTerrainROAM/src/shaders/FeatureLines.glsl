// SPDX-License-Identifier: Apache-2.0
// Paints roads and rivers as segments of constant width, by the distance to them, with the markings of roads.
// Source of the distance to a segment: Quilez, 2D distance functions.

// Returns the shares of white paint (edge and lane lines) and of wheel tracks. `across`: distance from the middle line;
// `way`: distance along the road; metres.
vec2 featureRoadMarks(float across, float width, float way, float widthAhead, float halfWidth, int lanes)
{
    float white = coveredTwice(across, width, halfWidth - 0.37, halfWidth - 0.25);
    float lane = (2.0 * halfWidth - 0.74) / float(lanes);
    float dashes = coveredDashes(way, widthAhead, 12.0, 4.0);
    for (int k = 1; k < lanes; ++k)
    {
        float middle = (float(k) - 0.5 * float(lanes)) * lane;
        white += covered(across, width, middle - 0.06, middle + 0.06) * (lanes > 3 && 2 * k == lanes ? 1.0 : dashes);
    }
    // A lane has two wheel tracks: a wave that fades into its mean.
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
    // Where two roads cross, neither has markings.
    vec2 way = normalize(bestEnds.zw - bestEnds.xy);
    vec2 normal = bestAcross > 1e-4 ? bestAway / bestAcross : vec2(-way.y, way.x);
    float width = widthAlong(f, normal);
    float ahead = clamp(dot(at - bestEnds.xy, way), 0.0, distance(bestEnds.xy, bestEnds.zw)) + bestStyle.y;
    vec2 marks = featureRoadMarks(bestAcross, width, ahead, widthAlong(f, way), bestStyle.x, (int(bestStyle.z) >> 4) & 15);
    float alone = clamp(0.5 + second / width, 0.0, 1.0);
    paint.marks.x = marks.x * alone;
    paint.marks.z = marks.y * alone;
    return record;
}
