// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/land/Structures.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <utility>

#include <glm/glm.hpp>

#include "scenery/buildings/Outline.h"
#include "scenery/structures/Structure.h"
#include "worldmaking/land/MapFile.h"

namespace worldmaking
{

namespace
{

using scenery::StructureKind;

constexpr double kGateStepM = 2.0; ///< a wall is looked at so often
constexpr double kLeastPieceM = 3.0;
constexpr double kWindsockM = 15.0; ///< beyond the edge of the strip that stays free
constexpr double kWindsockAlongM = 150.0;
constexpr double kNearRunwayM = 1500.0;

const std::vector<std::string> kKeys{
    "kind",   "barrier",  "power",     "voltage",     "railway",          "bridge",
    "height", "width",    "layer",     "electrified", "generator:source", "generator:method",
    "tunnel", "location", "height:hub"};

/// Numbers along a line as one text.
std::string heightsText(const std::vector<double>& heightsM)
{
    std::string list;
    char text[32];
    for (const double height : heightsM)
    {
        std::snprintf(text, sizeof text, list.empty() ? "%.2f" : ";%.2f", height);
        list += text;
    }
    return list;
}

/// Collects what a map has, and writes it.
class StructureTaker
{
public:
    StructureTaker(const MapPlane& plane, const StructureRoom& room, StructureReport& report)
        : _plane(plane), _room(room), _report(report)
    {
        for (const Track& track : room.tracks)
            _tracks[track.shape].push_back(&track);
    }

    void take(const LandShape& shape, std::size_t number)
    {
        if (takeTracks(shape, number)) return;
        if (shape.form == ShapeForm::point && valueOf(shape.tags, "aeroway") == "windsock")
            return takeWindsock(shape);
        if (!valueOf(shape.tags, "highway").empty()) return takeLight(shape);
        // Areas with a barrier are fenced; a plant's outline is no turbine.
        const bool isFenced = shape.form == ShapeForm::area && !valueOf(shape.tags, "barrier").empty();
        if (shape.form == ShapeForm::area && !isFenced) return;
        auto paths = _plane.toPlan(shape.paths);
        if (!paths) return;
        if (isFenced)
            for (auto& ring : *paths)
                ring.push_back(ring.front());
        for (auto& path : *paths)
            takeLine(shape, std::move(path));
    }

    /// A runway without a windsock gets one.
    void addWindsocks()
    {
        for (const Runway& runway : _room.runways)
        {
            const auto from = _plane.toPlan(runway.from), to = _plane.toPlan(runway.to);
            if (!from || !to) continue;
            const bool hasOne =
                std::any_of(_windsocks.begin(), _windsocks.end(),
                            [&](const glm::dvec2& sock)
                            { return glm::distance(sock, 0.5 * (*from + *to)) < kNearRunwayM; });
            if (hasOne) continue;
            const glm::dvec2 along = glm::normalize(*to - *from), left(-along.y, along.x);
            const double outM = 0.5 * runway.widthM + kStripSideM + kWindsockM;
            const double aheadM = std::min(kWindsockAlongM, 0.4 * glm::distance(*from, *to));
            for (const double side : {1.0, -1.0})
                if (const glm::dvec2 place = *from + aheadM * along + side * outM * left; isFree(place))
                {
                    addWindsock(place);
                    break;
                }
        }
    }

    void takeFootbridges()
    {
        for (const Footbridge& bridge : _room.footbridges)
        {
            char width[32];
            std::snprintf(width, sizeof width, "%.2f", bridge.widthM);
            Tags tags{{"kind", bridge.isRamp ? "footramp" : "footbridge"},
                      {"width", width},
                      {"heights", heightsText(bridge.heightsM)}};
            if (!bridge.piersM.empty()) tags["piers"] = heightsText(bridge.piersM);
            if (bridge.treads > 1) tags["treads"] = std::to_string(bridge.treads);
            _lines.emplace_back(bridge.points, std::move(tags));
            _report.footbridges += bridge.isRamp ? 0 : 1;
        }
    }

    std::size_t size() const { return _lines.size() + _points.size(); }

    foundation::Outcome write(const std::filesystem::path& file) const
    {
        MapFile made(file);
        const auto writeAll = [&](const char* name, ShapeForm form, const auto& things)
        {
            auto keys = kKeys;
            if (!_room.tracks.empty() || !_room.footbridges.empty()) keys.push_back("heights");
            if (!_room.tracks.empty()) keys.insert(keys.end(), {"portals", "tube", "embedded"});
            if (!_room.footbridges.empty()) keys.insert(keys.end(), {"piers", "treads"});
            if (_report.litStreets + _report.unlitStreets > 0) keys.push_back("lit");
            if (!things.empty()) made.beginLayer(name, form, keys);
            for (const auto& [path, tags] : things)
                if (const auto degrees = _plane.toDegrees({path})) made.add(*degrees, tags);
        };
        writeAll("lines", ShapeForm::line, _lines);
        writeAll("points", ShapeForm::point, _points);
        return made.finish();
    }

private:
    using Thing = std::pair<std::vector<glm::dvec2>, Tags>;

    /// Takes the stretches of a railway that has heights; false: it has none.
    bool takeTracks(const LandShape& shape, std::size_t number)
    {
        const auto found = _tracks.find(number);
        if (found == _tracks.end()) return false;
        ++_report.railways;
        for (const Track* stretch : found->second)
        {
            const Track& track = *stretch;
            Tags tags = shape.tags;
            for (const char* key : {"layer", "tunnel", "bridge", "location"})
                tags.erase(key);
            if (track.place == StreetPlace::bridge && !track.isInStreet) tags["bridge"] = "yes";
            if (track.place == StreetPlace::tunnel && !track.isInStreet) tags["tunnel"] = "yes";
            if (track.isInStreet) tags["embedded"] = "yes";
            const auto set = [&](const char* key, bool first, bool second, const char* one, const char* other)
            {
                if (first || second) tags[key] = first && second ? "both" : first ? one : other;
            };
            set("portals", track.isPortalAtStart, track.isPortalAtEnd, "start", "end");
            set("tube", track.isOpenLeft, track.isOpenRight, "left", "right");
            tags["heights"] = heightsText(track.heightsM);
            _lines.emplace_back(track.points, std::move(tags));
        }
        return true;
    }

    /// A lamp, or a way that the map says is lit or is not. Nothing of a tunnel: its lamps are its own.
    void takeLight(const LandShape& shape)
    {
        if (shape.form == ShapeForm::point && valueOf(shape.tags, "highway") == "street_lamp")
        {
            const auto place = _plane.toPlan(shape.paths.front().front());
            if (!place || !_room.ground(*place)) return;
            _points.push_back({{*place}, {{"kind", "street_lamp"}}});
            ++_report.streetLamps;
        }
        const auto lit = valueOf(shape.tags, "lit"), tunnel = valueOf(shape.tags, "tunnel");
        if (shape.form != ShapeForm::line || lit.empty() || !(tunnel.empty() || tunnel == "no")) return;
        const auto paths = _plane.toPlan(shape.paths);
        if (!paths) return;
        const bool isLit = lit != "no" && lit != "disused";
        for (const auto& path : *paths)
            _lines.push_back({path, {{"kind", "street"}, {"lit", isLit ? "yes" : "no"}}});
        ++(isLit ? _report.litStreets : _report.unlitStreets);
    }

    void takeWindsock(const LandShape& shape)
    {
        if (const auto place = _plane.toPlan(shape.paths.front().front()); place && isFree(*place))
            addWindsock(*place);
    }

    void addWindsock(const glm::dvec2& place)
    {
        _windsocks.push_back(place);
        _points.push_back({{place}, {{"kind", "windsock"}}});
        ++_report.windsocks;
    }

    bool isFree(const glm::dvec2& place) const
    {
        const bool isOnStrip =
            std::any_of(_room.strips.begin(), _room.strips.end(),
                        [&](const PlanRings& strip) { return scenery::isWithin(strip, place); });
        return !isOnStrip && _room.ground(place) && _room.roads.distanceM(place, kGateM) >= kGateM;
    }

    void takeLine(const LandShape& shape, std::vector<glm::dvec2> path)
    {
        const auto structure = scenery::structureOf(path, shape.tags, static_cast<std::uint64_t>(shape.id));
        if (!structure) return;
        const bool isKnown =
            std::all_of(path.begin(), path.end(),
                        [&](const glm::dvec2& place) { return _room.ground(place).has_value(); });
        if (!isKnown)
        {
            ++_report.beyondGround;
            return;
        }
        switch (structure->kind)
        {
        case StructureKind::wall:
        case StructureKind::fence:
            return takeBarrier(shape, structure->kind, path);
        case StructureKind::powerLine:
        case StructureKind::poleLine:
            ++_report.powerLines;
            break;
        case StructureKind::railway:
            ++_report.railways;
            break;
        case StructureKind::windTurbine:
            if (!isFree(path.front())) return;
            ++_report.turbines;
            _points.emplace_back(std::move(path), shape.tags);
            return;
        case StructureKind::footbridge: // made of paths
        case StructureKind::footRamp:
            return;
        }
        _lines.emplace_back(std::move(path), shape.tags);
    }

    /// The pieces of a wall between roads.
    void takeBarrier(const LandShape& shape, StructureKind kind, const std::vector<glm::dvec2>& path)
    {
        ++(kind == StructureKind::wall ? _report.walls : _report.fences);
        std::vector<glm::dvec2> piece;
        double pieceM = 0.0;
        bool isCut = false;
        const auto finish = [&]
        {
            if (pieceM >= kLeastPieceM) _lines.emplace_back(piece, shape.tags);
            piece.clear();
            pieceM = 0.0;
        };
        for (std::size_t i = 0; i + 1 < path.size(); ++i)
        {
            const int steps = std::max(1, static_cast<int>(glm::distance(path[i], path[i + 1]) / kGateStepM));
            for (int step = i == 0 ? 0 : 1; step <= steps; ++step)
            {
                const glm::dvec2 place = glm::mix(path[i], path[i + 1], static_cast<double>(step) / steps);
                if (!isFree(place))
                {
                    isCut = true;
                    finish();
                    continue;
                }
                if (!piece.empty()) pieceM += glm::distance(piece.back(), place);
                // Places on a straight stretch need no corner.
                if (piece.size() > 1 && step > 1)
                    piece.back() = place;
                else
                    piece.push_back(place);
            }
        }
        finish();
        _report.cut += isCut;
    }

    const MapPlane& _plane;
    const StructureRoom& _room;
    StructureReport& _report;
    std::map<std::size_t, std::vector<const Track*>> _tracks; ///< by their shapes
    std::vector<Thing> _lines, _points;
    std::vector<glm::dvec2> _windsocks;
};

} // namespace

foundation::Outcome writeStructures(const LandMap& map, const MapPlane& plane, const StructureRoom& room,
                                    const std::filesystem::path& file, StructureReport& report)
{
    StructureTaker taker(plane, room, report);
    for (std::size_t i = 0; i < map.shapes.size(); ++i)
        taker.take(map.shapes[i], i);
    taker.takeFootbridges();
    taker.addWindsocks();
    report.written = taker.size();
    return taker.size() == 0 ? foundation::success() : taker.write(file);
}

} // namespace worldmaking
