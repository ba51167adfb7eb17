// SPDX-License-Identifier: Apache-2.0
// Source: ASAM OpenDRIVE 1.8, 13.7 (object markings).
#include "Markings.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <osgRoads/core/query/ObjectInstances.h>

#include "DecalMaker.h"
#include "PaintColour.h"

namespace osgRoads::core
{

namespace
{

constexpr double kShortestPaintedPeriodM = 0.1; ///< a finer pattern is painted without gaps

using Way = std::vector<glm::dvec2>; ///< from corner to corner, in the object's frame

/// The box around an object in its own frame.
struct Box
{
    glm::dvec2 low{0.0}, high{0.0};
};

Box boxOf(const RoadObject& object, const ObjectInstance& instance, const DecalMaker& maker)
{
    const glm::dvec2 half(0.5 * instance.length, 0.5 * instance.width);
    Box box{-half, half};
    if (half.x > 0.0 && half.y > 0.0) return box;
    for (const ObjectOutline& outline : object.outlines)
        for (const OutlineCorner& corner : outline.corners)
        {
            const glm::dvec2 at = maker.cornerOf(corner);
            box = {glm::min(box.low, at), glm::max(box.high, at)};
        }
    return box;
}

Way wayOfSide(ObjectSide side, const Box& box)
{
    switch (side)
    {
    case ObjectSide::left:
        return {{box.low.x, box.high.y}, box.high};
    case ObjectSide::right:
        return {box.low, {box.high.x, box.low.y}};
    case ObjectSide::front:
        return {{box.high.x, box.low.y}, box.high};
    case ObjectSide::rear:
        return {box.low, {box.low.x, box.high.y}};
    default:
        return {};
    }
}

Way wayOfCorners(const std::vector<int>& ids, const RoadObject& object, const DecalMaker& maker)
{
    Way way;
    for (const int id : ids)
        for (const ObjectOutline& outline : object.outlines)
            for (const OutlineCorner& corner : outline.corners)
                if (corner.id == id) way.push_back(maker.cornerOf(corner));
    return way;
}

/// Paints a way between two distances along it. Dashes go on around corners.
void paint(const Way& way, const ObjectMarking& marking, DecalMaker& maker)
{
    double length = 0.0;
    for (std::size_t i = 1; i < way.size(); ++i)
        length += glm::distance(way[i - 1], way[i]);
    const double begin = marking.startOffset, end = length - marking.stopOffset,
                 period = marking.lineLength + marking.spaceLength;
    const bool isDashed =
        marking.lineLength > 0.0 && marking.spaceLength > 0.0 && period >= kShortestPaintedPeriodM;
    double reached = 0.0; // along the way, at the start of the piece
    for (std::size_t i = 1; i < way.size(); ++i)
    {
        const double piece = glm::distance(way[i - 1], way[i]);
        const double from = std::max(begin - reached, 0.0), to = std::min(end - reached, piece);
        const double phase = isDashed ? std::fmod(reached + from - begin, period) : 0.0;
        if (to > from)
            maker.stripedBar(glm::mix(way[i - 1], way[i], from / piece),
                             glm::mix(way[i - 1], way[i], to / piece), marking.width,
                             isDashed ? marking.lineLength : 0.0, isDashed ? period : 0.0, phase);
        reached += piece;
    }
}

} // namespace

void addMarkings(const PlacedNetwork& network, int road, const RoadObject& object, std::vector<Decal>& into)
{
    if (object.markings.empty()) return;
    for (const ObjectInstance& instance : objectInstances(object))
    {
        if (instance.isStretch) continue;
        DecalMaker maker(network, road, instance.s, instance.t, instance.headingRad, into);
        for (const ObjectMarking& marking : object.markings)
        {
            maker.setPaint(paintOf(marking.colour));
            paint(marking.corners.size() > 1 ? wayOfCorners(marking.corners, object, maker)
                                             : wayOfSide(marking.side, boxOf(object, instance, maker)),
                  marking, maker);
        }
    }
}

} // namespace osgRoads::core
