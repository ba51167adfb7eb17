// SPDX-License-Identifier: Apache-2.0
// Source: ASAM OpenDRIVE 1.8, 11.9 (road markings).
#include "MarkRows.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include <glm/vec3.hpp>

#include <osgRoads/core/query/MarkStrokes.h>

namespace osgRoads::core
{

namespace
{

/// Linear reflectance of the paint.
glm::vec3 paintOf(MarkColour colour)
{
    switch (colour)
    {
    case MarkColour::black:
        return {0.02F, 0.02F, 0.02F};
    case MarkColour::blue:
        return {0.03F, 0.12F, 0.50F};
    case MarkColour::green:
        return {0.03F, 0.30F, 0.10F};
    case MarkColour::orange:
        return {0.70F, 0.25F, 0.02F};
    case MarkColour::red:
        return {0.50F, 0.03F, 0.03F};
    case MarkColour::violet:
        return {0.25F, 0.06F, 0.40F};
    case MarkColour::yellow:
        return {0.70F, 0.48F, 0.04F};
    default:
        return {0.72F, 0.72F, 0.70F};
    }
}

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
