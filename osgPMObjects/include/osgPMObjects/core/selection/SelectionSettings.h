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

/// The method that chooses an object's level. Source: Sadykov & Zakharov, *Choosing the level of detail in
/// continuous simplification of polygonal objects* (2002), sections 2.3 and 5, except for screenError and
/// budget.
enum class SelectionMethod : std::uint8_t
{
    ranges,            ///< by distance, without hysteresis: Ranges
    overlappingRanges, ///< by distance, with hysteresis: OverlappingRanges
    boxArea,           ///< by projected area: AreaRows with boxAreaPx()
    sphereArea,        ///< AreaRows with sphereAreaPx()
    ellipsoidArea,     ///< AreaRows with ellipsoidAreaPx() of Ellipsoid::within() the box
    facingArea,        ///< AreaRows with facingAreaPx()
    continuous,        ///< by distance, to the single position: heldRemovalAt()
    screenError,       ///< by error in pixels: heldWithin()
    budget,            ///< by cost: SceneBudget, shared by all objects with this method
};

inline constexpr std::size_t kSelectionMethods = 9;

/// Returns the name of a method in scene descriptions and statistics.
const char* nameOf(SelectionMethod method);

/// The distances over which an object fades out: alpha is 1 up to `fadeM`, falls linearly to 0 at `goneM`,
/// and the object is not drawn from there on. An infinite `goneM`, the default, means that it never fades.
/// Units: metres of the author's camera (SelectionView::distanceScale).
/// Source: Sadykov & Zakharov (2002), section 2.2.3.
struct AlphaRange
{
    double fadeM = std::numeric_limits<double>::infinity();
    double goneM = std::numeric_limits<double>::infinity();

    float alphaAt(double distanceM) const
    {
        if (distanceM <= fadeM || goneM == std::numeric_limits<double>::infinity()) return 1.0f;
        if (distanceM >= goneM) return 0.0f;
        return static_cast<float>((goneM - distanceM) / (goneM - fadeM));
    }
};

/// The settings by which objects choose their levels; objects with equal settings share one instance. Each
/// method reads its own fields only. Invariant: checkSettings().
struct SelectionSettings
{
    SelectionMethod method = SelectionMethod::screenError;
    Ranges ranges;
    OverlappingRanges overlappingRanges;
    AreaRows areaRows;
    double referenceM =
        0.0; ///< z1 of the continuous rule, in metres of the author's camera; finite; 0: referenceDistanceM()
    double trianglePx = 1.5; ///< pixels, above 0, finite: argument of referenceDistanceM()
    double tolerancePx =
        1.0; ///< pixels, above 0, finite: error that screenError allows and budget does not refine
    /// The number of faces below which no level is chosen, by any method; a mesh with fewer faces is drawn
    /// whole. Callers that give SelectableObject::drawable or ::curve leave such levels out themselves.
    std::uint32_t leastFaces = 0;
    ErrorKind errorKind = ErrorKind::maximum; ///< the measured error that screenError and budget bound
    AttributeWeights weights;
    double band =
        kDefaultBand; ///< hysteresis of areas, screenError and budget's tolerance: factor ≥ 1, finite
    double continuousBand = 1.0; ///< hysteresis of continuous: factor ≥ 1, finite; 1: exact to the position
    AlphaRange alpha;            ///< for every method

    ErrorMeasure measure() const { return {weights, errorKind}; }
};

/// Tells whether settings can choose among `levels` levels (LevelTable): else an error that names the field
/// and the remedy. Check settings that a user wrote once with this; the rules themselves do not check.
foundation::Outcome checkSettings(const SelectionSettings& settings, std::uint32_t levels);

} // namespace osgPMObjects::core
