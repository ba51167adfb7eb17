// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/roads/Plate.h"

#include <cmath>
#include <numbers>

namespace scenery::models
{

namespace
{

using Outline = std::vector<
    glm::dvec2>; ///< in a square from -1 to 1: to the left, up; counter-clockwise seen from behind

Outline outlineOf(RoadModel::Shape shape)
{
    switch (shape)
    {
    case RoadModel::Shape::triangle:
        return {{-1.0, -0.96}, {1.0, -0.96}, {0.0, 0.98}};
    case RoadModel::Shape::triangleDown:
        return {{-1.0, 0.96}, {0.0, -0.98}, {1.0, 0.96}};
    case RoadModel::Shape::diamond:
        return {{0.0, -1.0}, {1.0, 0.0}, {0.0, 1.0}, {-1.0, 0.0}};
    case RoadModel::Shape::square:
        return {{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}};
    default:
        break;
    }
    const bool isOctagon = shape == RoadModel::Shape::octagon;
    const int points = isOctagon ? 8 : 24;
    const double reach = isOctagon ? 1.0 / std::cos(std::numbers::pi / 8.0) : 1.0;
    Outline outline;
    for (int i = 0; i < points; ++i)
    {
        const double turn = 2.0 * std::numbers::pi * (i + (isOctagon ? 0.5 : 0.0)) / points;
        outline.push_back(reach * glm::dvec2(std::cos(turn), std::sin(turn)));
    }
    return outline;
}

} // namespace

void addPlate(ModelBuilder& builder, const Plate& plate)
{
    const Outline outline = outlineOf(plate.shape);
    // The driver sees y to the left: the picture runs against y. Behind, the back's cell is plain.
    const auto corner = [&](std::size_t i, bool isBack, bool isRim)
    {
        const glm::dvec2 at = outline[i % outline.size()];
        const SignCell& cell = isBack || isRim ? plate.back : plate.front;
        const glm::vec2 share(0.5 - 0.5 * at.x, 0.5 + 0.5 * at.y);
        return Corner{plate.middle + glm::dvec3(isBack ? plate.thicknessM : 0.0, 0.5 * plate.widthM * at.x,
                                                0.5 * plate.heightM * at.y),
                      cell.low + (cell.high - cell.low) * share};
    };
    for (std::size_t i = 1; i + 1 < outline.size(); ++i)
    {
        builder.triangle(corner(0, false, false), corner(i + 1, false, false), corner(i, false, false));
        builder.triangle(corner(0, true, false), corner(i, true, false), corner(i + 1, true, false));
    }
    for (std::size_t i = 0; i < outline.size(); ++i)
        builder.quad(corner(i, false, true), corner(i + 1, false, true), corner(i + 1, true, true),
                     corner(i, true, true));
}

} // namespace scenery::models
