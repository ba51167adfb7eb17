// SPDX-License-Identifier: Apache-2.0
// Source: ASAM OpenDRIVE 1.8, 11.9 (road markings).
#include "MarkRows.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include <osgRoads/core/query/MarkStrokes.h>

#include "PaintColour.h"

namespace osgRoads::core
{

namespace
{

MarkRowLine rowLineOf(const MarkLine& line, double fromMarkM)
{
    const glm::vec3 paint = paintOf(line.colour);
    MarkRowLine row;
    row.offset = static_cast<float>(line.tOffset);
    row.width = static_cast<float>(line.width);
    row.red = paint.x;
    row.green = paint.y;
    row.blue = paint.z;
    const double period = line.length + line.space;
    if (line.length > 0.0 && line.space > 0.0 && period >= 0.1)
    {
        const double phase = std::fmod(fromMarkM - std::max(line.sOffset, 0.0), period);
        row.dash = static_cast<float>(line.length);
        row.period = static_cast<float>(period);
        row.phase = static_cast<float>(phase < 0.0 ? phase + period : phase);
    }
    return row;
}

} // namespace

std::uint32_t MarkRows::rowOf(const LaneSection& section, const Lane& lane, double s)
{
    // A cut may lie a rounding before the start of the mark that holds in the chunk.
    constexpr double kRoundingM = 1e-6;
    const int index = lastStartingBy(lane.marks, s - section.s + kRoundingM);
    if (index < 0) return 0;
    const RoadMark& mark = lane.marks[static_cast<std::size_t>(index)];
    MarkRow row;
    std::size_t count = 0;
    for (const MarkLine& line : repeatedLines(mark))
        if (count < row.size()) row[count++] = rowLineOf(line, s - section.s - mark.s);
    if (count == 0) return 0;
    const auto [known, isNew] =
        _known.emplace(std::bit_cast<std::array<float, 16>>(row), static_cast<std::uint32_t>(_rows.size()));
    if (isNew) _rows.push_back(row);
    return known->second;
}

} // namespace osgRoads::core
