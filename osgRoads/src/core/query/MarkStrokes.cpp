// SPDX-License-Identifier: Apache-2.0
// Source: ASAM OpenDRIVE 1.8, 11.9 (road markings).
#include <algorithm>
#include <cmath>

#include <osgRoads/core/query/LaneSpan.h>
#include <osgRoads/core/query/MarkStrokes.h>

namespace osgRoads::core
{

namespace
{

constexpr double kShortestPeriodM = 0.1;

/// The lines that a type of mark stands for; the left one of a pair is the first word of its name.
std::vector<MarkLine> linesOf(const RoadMark& mark, double width)
{
    const double half = 0.5 * (width + kDoubleSpaceM);
    const auto solid = [&](double tOffset)
    { return MarkLine{0.0, 0.0, tOffset, 0.0, width, mark.colour, ""}; };
    const auto broken = [&](double tOffset)
    { return MarkLine{kDashM, kGapM, tOffset, 0.0, width, mark.colour, ""}; };
    switch (mark.type)
    {
    case MarkType::solid:
    case MarkType::custom:
        return {solid(0.0)};
    case MarkType::broken:
        return {broken(0.0)};
    case MarkType::solidSolid:
        return {solid(half), solid(-half)};
    case MarkType::solidBroken:
        return {solid(half), broken(-half)};
    case MarkType::brokenSolid:
        return {broken(half), solid(-half)};
    case MarkType::brokenBroken:
        return {broken(half), broken(-half)};
    case MarkType::bottsDots:
        return {MarkLine{width, 1.0, 0.0, 0.0, width, mark.colour, ""}};
    default:
        return {};
    }
}

double widthOf(const RoadMark& mark)
{
    if (mark.width > 0.0) return mark.width;
    return mark.weight == MarkWeight::bold ? kBoldMarkWidthM : kMarkWidthM;
}

/// Adds the strokes of one line between two s.
class StrokeMaker
{
public:
    StrokeMaker(const Lane& lane, const RoadMark& mark, double begin, double end)
        : _lane(lane), _mark(mark), _begin(begin), _end(end), _width(widthOf(mark))
    {
    }

    void addOne(const MarkLine& line, double from, double to, std::vector<MarkStroke>& strokes) const
    {
        MarkStroke stroke{_lane.id,
                          std::max(from, _begin),
                          std::min(to, _end),
                          line.tOffset,
                          line.width > 0.0 ? line.width : _width,
                          _mark.height,
                          line.colour,
                          &_mark};
        if (stroke.sEnd > stroke.sStart) strokes.push_back(stroke);
    }

    void addRepeated(const MarkLine& line, std::vector<MarkStroke>& strokes) const
    {
        const double period = line.length + line.space;
        if (line.length <= 0.0 || line.space <= 0.0 || period < kShortestPeriodM)
        {
            addOne(line, _begin + std::max(line.sOffset, 0.0), _end, strokes);
            return;
        }
        const double first = _begin + std::max(line.sOffset, 0.0);
        const auto count = static_cast<long>(std::ceil(std::max(_end - first, 0.0) / period));
        for (long i = 0; i < count; ++i)
        {
            const double from = first + static_cast<double>(i) * period;
            addOne(line, from, from + line.length, strokes);
        }
    }

private:
    const Lane& _lane;
    const RoadMark& _mark;
    double _begin, _end, _width;
};

} // namespace

std::vector<MarkLine> repeatedLines(const RoadMark& mark)
{
    if (!mark.explicitLines.empty() || mark.type == MarkType::none) return {};
    std::vector<MarkLine> lines = mark.lines.empty() ? linesOf(mark, widthOf(mark)) : mark.lines;
    for (MarkLine& line : lines)
        if (!(line.width > 0.0)) line.width = widthOf(mark);
    return lines;
}

std::vector<MarkStroke> markStrokes(const Road& road, const LaneSection& section, const Lane& lane)
{
    std::vector<MarkStroke> strokes;
    for (std::size_t i = 0; i < lane.marks.size(); ++i)
    {
        const RoadMark& mark = lane.marks[i];
        const double begin = std::clamp(section.s + mark.s, 0.0, road.length);
        const double last = i + 1 < lane.marks.size() ? section.s + lane.marks[i + 1].s : section.end;
        const double end = std::min({last, section.end, road.length});
        const StrokeMaker maker(lane, mark, begin, end);
        if (!mark.explicitLines.empty())
            for (const MarkLine& line : mark.explicitLines)
                maker.addOne(line, begin + line.sOffset, begin + line.sOffset + line.length, strokes);
        else
            for (const MarkLine& line : repeatedLines(mark))
                maker.addRepeated(line, strokes);
    }
    return strokes;
}

double strokeT(const Road& road, const LaneSection& section, const MarkStroke& stroke, double s)
{
    double border = road.laneOffset.value(s);
    if (stroke.laneId != 0)
        forLanesOutwards(road, section, stroke.laneId > 0 ? 1 : -1, s,
                         [&](const LaneSpan& span)
                         {
                             border = span.outerT;
                             return span.lane->id != stroke.laneId;
                         });
    const double sway = stroke.mark ? stroke.mark->sway.value(s - section.s - stroke.mark->s) : 0.0;
    return border + stroke.tOffset + sway;
}

} // namespace osgRoads::core
