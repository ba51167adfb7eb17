// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "scenery/roads/things/Placers.h"
#include "scenery/roads/things/RoadLine.h"

namespace scenery::roads
{

namespace
{

Profile wall(double width, double low, double high)
{
    return {{-0.5 * width, low}, {0.5 * width, low}, {0.5 * width, high}, {-0.5 * width, high}};
}

/// The New Jersey profile: a foot of the told width, a slope, a steep stem.
/// Source: FHWA, Technical Advisory T 5040.23 (1984): of 32 inches the foot is 3, the slope 10 high; widths
/// 24, 19 and 6 of 24 inches.
Profile jersey(double width, double low, double height)
{
    const double foot = low + 0.094 * height, knee = low + 0.41 * height, top = low + height;
    const double wide = 0.5 * width, waist = 0.21 * width, narrow = 0.13 * width;
    return {{-wide, low},  {wide, low},    {wide, foot},   {waist, knee},
            {narrow, top}, {-narrow, top}, {-waist, knee}, {-wide, foot}};
}

} // namespace

void placeStretch(const osgRoads::core::PlacedNetwork& placed, int road, StretchForm form,
                  const osgRoads::core::ObjectInstance& stretch, RoadThings& into)
{
    if (form == StretchForm::guardRail) return placeGuardRail(placed, road, stretch, into);
    const auto between = [stretch](double from, double to, double s)
    {
        return from +
               (to - from) * std::clamp((s - stretch.s) / std::max(stretch.sEnd - stretch.s, 1e-9), 0.0, 1.0);
    };
    const auto sizeAt = [=](double from, double to, double s, double otherwise)
    {
        const double size = between(from, to, s);
        return size > 0.0 ? size : otherwise;
    };
    RoadLine line;
    line.s = stretch.s;
    line.sEnd = stretch.sEnd;
    line.lineT = [=](double s) { return between(stretch.t, stretch.tEnd, s); };
    const bool isFence = form == StretchForm::fence;
    if (form == StretchForm::jersey)
        line.body = simulation::ObstacleKind::barrier;
    else if (form != StretchForm::kerb) // which wheels climb
        line.body = isFence ? simulation::ObstacleKind::fence : simulation::ObstacleKind::wall;
    line.surface = {isFence ? models::Painting::planks : models::Painting::plaster, models::Coat::matt};
    line.tint = isFence ? glm::vec3(0.55F, 0.45F, 0.35F) : glm::vec3(0.62F, 0.61F, 0.59F);
    line.uvPerM = 1.0 / 2.4;
    line.profileAt = [=](double s)
    {
        const double z = between(stretch.z, stretch.zEnd, s);
        const auto width = [&](double otherwise)
        { return sizeAt(stretch.width, stretch.widthEnd, s, otherwise); };
        const auto height = [&](double otherwise)
        { return std::max(sizeAt(stretch.height, stretch.heightEnd, s, otherwise), 0.05); };
        // Bodies that stand on the road reach into the ground, which may lie a little lower beside it.
        const double foot = z < 0.3 ? z - 0.3 : z;
        switch (form)
        {
        case StretchForm::jersey:
            return jersey(width(0.61), z < 0.3 ? z - 0.05 : z, height(0.81));
        case StretchForm::kerb:
            return wall(width(0.15), foot, z + height(0.12));
        case StretchForm::fence:
            return wall(width(0.04), foot, z + height(1.5));
        default:
            return wall(width(0.2), foot, z + height(1.0));
        }
    };
    addRoadLine(placed, road, line, into);
}

} // namespace scenery::roads
