// SPDX-License-Identifier: Apache-2.0
// Paints strokes: rectangles with a middle line, such as runways, their markings and those of taxiways, and lamps.
// What a stroke paints is FeatureCells::Paint: yellow, asphalt, white, rubber, a lamp.

void paintStrokes(inout Paint paint, int record, int count, vec2 at, Footprint f)
{
    float area = f.x.x * f.y.y - f.x.y * f.y.x;
    for (int end = record + 2 * count; record < end; record += 2)
    {
        vec4 ends = featureRecord(record);
        vec4 style = featureRecord(record + 1);
        vec2 from = at - 0.5 * (ends.xy + ends.zw);
        if (style.y > 3.5)
        {
            // A lamp is a point of the image: its size is in pixels, not metres.
            vec2 pixels = vec2(from.x * f.y.y - from.y * f.y.x, from.y * f.x.x - from.x * f.x.y)
                        / (abs(area) > 1e-9 ? area : 1e-9);
            paint.marks.w += exp(-1.2 * dot(pixels, pixels)) + 0.03 * exp(-0.08 * dot(pixels, pixels));
            continue;
        }
        vec2 along = ends.zw - ends.xy;
        float lengthM = length(along);
        along /= lengthM;
        vec2 right = vec2(along.y, -along.x);
        float share = covered(dot(from, along), widthAlong(f, along), -0.5 * lengthM, 0.5 * lengthM)
                    * covered(dot(from, right), widthAlong(f, right), -style.x, style.x);
        if (style.y < 0.5)
            paint.more.x += share;
        else if (style.y < 1.5)
        {
            paint.beds.w = max(paint.beds.w, share);
            paint.marks.x *= 1.0 - share;
            paint.more.x *= 1.0 - share;
        }
        else if (style.y < 2.5)
            paint.marks.x += share;
        else
            paint.more.y += (1.0 - paint.more.y) * 0.5 * share;
    }
}
