// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include <osgPMObjects/core/selection/SceneSelector.h>
#include <osgPMObjects/core/selection/Switch.h>

#include "scenery/models/Catalogue.h"
#include "scenery/placement/SelectionPlan.h"

namespace scenery
{

/// An object to be placed: a generated model or a file. Exactly one of `kind` and `file` is set.
struct SceneryObject
{
    std::optional<models::Kind> kind;
    std::uint64_t seed = 0;
    std::string file; ///< relative to the working folder of the program

    bool operator==(const SceneryObject&) const = default;
};

enum class Arrangement : std::uint8_t
{
    settlement, ///< houses along small streets, facing them
    parked,     ///< vehicles along the streets of a settlement
    rows,       ///< avenues, orchards
    scattered,
};

/// From `least` to `most`, both included.
struct Span
{
    double least = -std::numeric_limits<double>::infinity(), most = std::numeric_limits<double>::infinity();

    bool contains(double value) const { return value >= least && value <= most; }
};

struct Circle
{
    glm::dvec2 centreM{0.0};
    double radiusM = 0.0;
};

/// The rules for the positions of the objects of a field; all that are set must hold.
/// Frame: the scene's east and north. Units: metres; degrees.
struct Where
{
    std::optional<Circle> circle;
    std::vector<glm::dvec2> polygon;   ///< corners; empty: not given
    std::optional<Span> pathDistanceM; ///< from the paths of the scenario's entities, airborne ones too
    Span heightM, slopeDeg{0.0, 25.0};
    bool inWater = false;            ///< false: only above the sea level
    std::vector<std::string> covers; ///< names of land cover, where the terrain knows it; empty: any
    double patchM = 0.0;             ///< above 0: only within irregular patches of about this size …
    double patchShare = 1.0;         ///< … that cover so much of the land
};

struct RowLayout
{
    double spacingM = 9.0, betweenM = 9.0, lengthM = 150.0;
    int rows = 2;
};

struct SettlementLayout
{
    int settlements = 1, sideStreets = 3;
    double streetM = 220.0; ///< length of the main street; side streets have half of it
    double plotM = 24.0;    ///< along the street
    double setbackM = 5.0;  ///< from the edge of the street to the nearest point of a house
    double widthM = 6.0;    ///< of streets
};

/// A field: objects that are placed by one rule and drawn with one set of settings.
struct SceneryField
{
    std::string name;
    std::vector<SceneryObject> objects;
    Arrangement arrangement = Arrangement::scattered;
    std::uint32_t count = 0;    ///< of objects; 0: by density
    double densityPerKm2 = 0.0; ///< of the area of the field, whatever the rules of the ground leave of it
    Where where;
    RowLayout rows;
    SettlementLayout settlement;
    std::string beside;    ///< of `parked`: the settlement's name
    double spacingM = 0.0; ///< least gap to objects of all fields
    double crowding = 0.0; ///< share by which crowns of trees may overlap, 0 … 0.8
    double leastScale = 1.0, mostScale = 1.0;
    SelectionPlan selection;
    osgPMObjects::core::SwitchSettings switching{osgPMObjects::core::SwitchMethod::discrete};
    double importance = 1.0;
};

/// The description of the objects on a terrain. The file format is described in
/// docs/reference/scenery-file.md.
struct SceneryDescription
{
    std::uint64_t seed = 1;
    std::vector<SceneryField> fields; ///< their names differ
    osgPMObjects::core::SceneBudgetSettings budget;
};

/// Returns each object of the fields once, in the order of its first occurrence.
std::vector<SceneryObject> objectsOf(const SceneryDescription& description);

} // namespace scenery
