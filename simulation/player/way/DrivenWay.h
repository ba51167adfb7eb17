// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "simulation/parser/RandomDraw.h"
#include "simulation/player/EntityMotion.h"
#include "simulation/road/JunctionTable.h"

namespace simulation
{

/// The way of a vehicle along lanes, from some metres behind it to some hundred metres ahead: where it leads,
/// how fast one may go there, and through which junctions. Where several roads follow it draws one that does
/// not lead to the end of all roads, nor back through junctions that lie close together, and lets the entity
/// follow it. Distances count along the way from where it began. Units: metres, m/s.
class DrivenWay
{
public:
    struct Point
    {
        glm::dvec3 place{0.0};
        double alongM = 0.0;
        double headingRad = 0.0;
        glm::dvec2 along{1.0, 0.0}; ///< the same as a direction
        double limitMps = 0.0;      ///< of signs, and of the bend
        double allowedMps = 0.0;    ///< to keep the limits ahead by gentle braking
    };

    /// A road of the way through a junction, or a narrow stretch of another one (LaneMeetings).
    struct Crossing
    {
        JunctionLane lane;
        double fromM = 0.0, toM = 0.0; ///< `toM` behind all points: not known yet
        double onLaneM = 0.0;          ///< where it begins, along the lane
        bool isNarrow = false;
        int junction = -1;                                   ///< its index; -1: none
        const std::vector<LaneMeetings::Met>* met = nullptr; ///< the lanes that the lane meets
    };

    /// A stop sign or a traffic light that holds for the way.
    struct Line
    {
        double alongM = 0.0;
        std::string light; ///< its id; empty: a sign
    };

    /// `draw`: which roads it takes; nothing: those of the entity's own way, else the straightest. `table`
    /// must outlive it.
    DrivenWay(JunctionTable& table, const std::optional<RandomDraw>& draw) : _table(&table), _draw(draw) {}

    /// Goes on to where an entity is on its lane, and looks farther ahead. False: it is on no road.
    bool follow(EntityMotion& motion);

    const std::vector<Point>& points() const { return _points; }
    std::size_t at() const { return _at; } ///< the last point that is not ahead
    double alongM() const { return _alongM; }
    double allowedMps() const;
    const std::vector<Crossing>& crossings() const { return _crossings; } ///< ahead, under it and just behind
    const std::vector<Line>& lines() const { return _lines; } ///< the same, in the order of the way

private:
    void begin(EntityMotion& motion);
    bool findPlace(const glm::dvec3& position);
    void forget();
    void lookAhead(EntityMotion& motion);
    void choose(EntityMotion& motion);
    double headingBeforeJunctions() const;
    void add(const RoadPlace& place);
    void addCrossings(const RoadPlace& place, double laneM);
    void addLines(const RoadPlace& before);
    void addLinesOn(const RoadPlace& place, double fromM, double toM, double alongM);
    void findLimits();

    JunctionTable* _table;
    std::optional<RandomDraw> _draw;
    RoadWay _way;              ///< roads, from that under the entity
    std::size_t _tailRoad = 0; ///< of the way, on which the last point lies
    RoadPlace _tail;
    bool _hasEnded = false; ///< at the end of the last road
    std::vector<Point> _points;
    std::vector<Crossing> _crossings;
    std::vector<Line> _lines;
    std::size_t _at = 0;
    double _alongM = 0.0;
};

} // namespace simulation
