// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/cockpit/PanelView.h"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace
{

using namespace scenery::models;

constexpr double kDegPerRad = 180.0 / std::numbers::pi;

/// Where a place of the panel lies in the picture, -1 … 1 from the middle to its edges.
glm::dvec2 inPicture(const PanelView& view, const glm::dvec2& place, double distanceM)
{
    const double left = view.leftDeg / kDegPerRad, up = view.upDeg / kDegPerRad;
    const glm::dvec3 ahead(std::cos(up) * std::cos(left), std::cos(up) * std::sin(left), std::sin(up));
    const glm::dvec3 right = glm::normalize(glm::cross(ahead, glm::dvec3(0.0, 0.0, 1.0)));
    const glm::dvec3 seen(distanceM, -place.x, place.y);
    const double half = std::tan(0.5 * view.heightDeg / kDegPerRad) * glm::dot(seen, ahead);
    return {glm::dot(seen, right) / (half * kPanelAspect), glm::dot(seen, glm::cross(right, ahead)) / half};
}

TEST(PanelView, HoldsEveryInstrumentLargeEnoughToRead)
{
    for (const auto& [panel, distanceM] : {std::pair{aircraftPanel(), 0.64}, std::pair{carPanel(), 0.66}})
    {
        const PanelView view = panelViewOf(panel, distanceM);
        for (const PlacedInstrument& placed : panel)
        {
            const glm::dvec2 middle = inPicture(view, placed.middle, distanceM);
            for (const glm::dvec2& side :
                 {glm::dvec2(1.0, 0.0), glm::dvec2(-1.0, 0.0), glm::dvec2(0.0, 1.0), glm::dvec2(0.0, -1.0)})
            {
                const glm::dvec2 edge = inPicture(view, placed.middle + placed.radiusM * side, distanceM);
                EXPECT_LT(std::abs(edge.x), 1.0);
                EXPECT_LT(std::abs(edge.y), 1.0);
            }
            // Of a window of 360 lines: the large ones 90 pixels and more.
            const double widePx =
                360.0 *
                std::abs(inPicture(view, placed.middle + glm::dvec2(0.0, placed.radiusM), distanceM).y -
                         middle.y);
            EXPECT_GT(widePx, placed.radiusM > 0.04 ? 90.0 : 50.0);
        }
    }
}

} // namespace
