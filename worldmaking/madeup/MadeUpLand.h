// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "worldmaking/madeup/Airfield.h"
#include "worldmaking/madeup/AreaSet.h"
#include "worldmaking/madeup/Drainage.h"
#include "worldmaking/madeup/MadeUpMap.h"
#include "worldmaking/madeup/PlanArea.h"
#include "worldmaking/madeup/Plots.h"

namespace worldmaking
{

/// Makes up a map in the plane, stage after stage: each sees what those before it have taken. Frame: the
/// plane. Units: metres.
class MadeUpLand
{
public:
    MadeUpLand(const GroundGrid& ground, const MadeUpSettings& settings);

    void make();

    MadeShapes shapes; ///< everything, streets included
    std::optional<Airfield> airfield;
    std::vector<std::pair<std::string_view, glm::dvec2>> places; ///< as MadeUpPlace, in the plane
    MadeUpReport report;

    /// The line above which no tree stands.
    double treeLineM() const { return _treeLineM; }

private:
    void layWaters();
    void settle();
    void buildHouses();
    void till();
    void plantWoods();
    void emitStreets();
    void emitLand();
    void addHedges(const PlanRings& field, std::size_t number);
    void addAvenues();

    bool isFree(const glm::dvec2& place) const;   ///< to build on
    double tollAt(const glm::dvec2& place) const; ///< of roads
    double farmWish(const glm::dvec2& place) const;
    static std::vector<std::vector<glm::dvec2>> piecesOf(const std::vector<glm::dvec2>& line);

    static constexpr double kBridgedKm2 = 2.0; ///< roads cross smaller streams by culverts

    const GroundGrid& _ground;
    const MadeUpSettings& _settings;
    Drainage _drainage;
    std::vector<Stream> _streams;
    AreaSet _strip, _approaches, _lakes, _shores, _brooks, _zones, _fields,
        _tilled; ///< tilled: fields with a balk around; brooks: streams with some room beside them
    double _treeLineM = 0.0;
    std::vector<Settlement> _settlements;
    WayWeb _web;
    TakenPlots _plots;
};

} // namespace worldmaking
