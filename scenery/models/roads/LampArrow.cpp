// SPDX-License-Identifier: Apache-2.0
// Source: Convention on Road Signs and Signals (Vienna, 1968), article 23, 4 (arrows in lamps).
#include "scenery/models/roads/LampArrow.h"

namespace scenery::models
{

namespace
{

using Pieces = std::vector<std::vector<glm::dvec2>>;
using Arrow = RoadModel::Arrow;

constexpr double kShaft = 0.14; ///< half of its width

/// A shaft and a head along a direction.
void addArrow(glm::dvec2 along, double from, double neck, double tip, double wide, Pieces& pieces)
{
    const glm::dvec2 aside(-along.y, along.x);
    pieces.push_back({along * from - aside * kShaft, along * neck - aside * kShaft,
                      along * neck + aside * kShaft, along * from + aside * kShaft});
    pieces.push_back({along * neck - aside * wide, along * tip, along * neck + aside * wide});
}

} // namespace

Pieces arrowPieces(Arrow arrow)
{
    Pieces pieces;
    const glm::dvec2 up(0.0, 1.0), left(1.0, 0.0);
    if (arrow == Arrow::left) addArrow(left, -0.8, 0.05, 0.85, 0.55, pieces);
    if (arrow == Arrow::right) addArrow(-left, -0.8, 0.05, 0.85, 0.55, pieces);
    if (arrow == Arrow::ahead) addArrow(up, -0.8, 0.05, 0.85, 0.55, pieces);
    if (arrow != Arrow::leftAhead && arrow != Arrow::rightAhead) return pieces;
    addArrow(up, -0.85, 0.35, 0.9, 0.38, pieces);
    addArrow(arrow == Arrow::leftAhead ? left : -left, kShaft, 0.4, 0.9, 0.34, pieces);
    return pieces;
}

} // namespace scenery::models
