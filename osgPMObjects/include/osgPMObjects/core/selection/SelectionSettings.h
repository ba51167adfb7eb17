// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>

#include <foundation/Result.h>

#include <osgPMObjects/core/selection/AreaRows.h>
#include <osgPMObjects/core/selection/OverlappingRanges.h>
#include <osgPMObjects/core/selection/Ranges.h>
#include <osgPMObjects/core/selection/ScreenErrorRule.h>

namespace osgPMObjects::core
{

/// By what an object's level is chosen. Source: paper 004, section 2.3 and 5; spec 5.
enum class SelectionMethod : std::uint8_t
{
    ranges,            ///< Ranges
    overlappingRanges, ///< OverlappingRanges
    boxArea,           ///< AreaRows by boxAreaPx()
    sphereArea,        ///< AreaRows by sphereAreaPx()
    ellipsoidArea,     ///< AreaRows by ellipsoidAreaPx() of the ellipsoid within the box
    facingArea,        ///< AreaRows by facingAreaPx()
    continuous,        ///< heldRemovalAt()
    screenError,       ///< heldWithin()
    budget,            ///< SceneBudget, among all objects that have this method
};

inline constexpr std::size_t kSelectionMethods = 9;

/// Its name in scene descriptions and statistics.
const char* nameOf(SelectionMethod method);

/// Where an object fades to nothing: alpha is 1 up to `fadeM`, 0 from `goneM` on, linear between; then it is not processed
/// at all.
/// Units: metres of the author's camera (SelectionView::distanceScale). Source: paper 004, section 2.2.3.
struct AlphaRange
{
    double fadeM = std::numeric_limits<double>::infinity();
    double goneM = std::numeric_limits<double>::infinity();

    float alphaAt(double distanceM) const
    {
        if (distanceM <= fadeM) return 1.0f;
        if (distanceM >= goneM) return 0.0f;
        return static_cast<float>((goneM - distanceM) / (goneM - fadeM));
    }
};

/// How the levels of objects are chosen; shared by all objects that have the same. Each method looks at its own fields.
/// Invariant: checkSettings().
struct SelectionSettings
{
    SelectionMethod method = SelectionMethod::screenError;
    Ranges ranges;
    OverlappingRanges overlappingRanges;
    AreaRows areaRows;
    double referenceM =
        0.0; ///< z1 of the continuous rule, in metres of the author's camera; 0: referenceDistanceM()
    double trianglePx = 1.5;  ///< of referenceDistanceM()
    double tolerancePx = 1.0; ///< of the screen error, and where more detail under a budget is worth nothing
    /// Levels with fewer faces are not chosen, by any method; fields heed it, and whoever gives curves or levels that can be drawn leaves those
    /// levels out. A mesh that has fewer is drawn whole.
    std::uint32_t leastFaces = 0;
    AttributeWeights weights;
    double band = kDefaultBand;  ///< of areas, screen error and budget's tolerance; at least 1
    double continuousBand = 1.0; ///< 1: the rule is exact to the position
    AlphaRange alpha;            ///< with any method
};

/// Whether the settings can choose among `levels` levels (LevelTable): else which field is wrong, and what to do. Settings
/// that a user wrote are looked at once, with this; the rules themselves trust them.
foundation::Outcome checkSettings(const SelectionSettings& settings, std::uint32_t levels);

} // namespace osgPMObjects::core
