// SPDX-License-Identifier: Apache-2.0
#include "scenery/structures/StructureFacets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "scenery/models/Dice.h"
#include "scenery/structures/Catenary.h"
#include "scenery/structures/Footbridge.h"
#include "scenery/structures/PowerLine.h"
#include "scenery/structures/RailTube.h"
#include "scenery/structures/SquareBeams.h"

namespace scenery
{

namespace
{

constexpr glm::vec3 kSteel(0.50F, 0.53F, 0.55F), kWire(0.22F, 0.23F, 0.25F), kWood(0.36F, 0.28F, 0.20F),
    kStone(0.55F, 0.53F, 0.49F), kRail(0.38F, 0.34F, 0.31F), kSleeper(0.45F, 0.44F, 0.42F),
    kBallast(0.42F, 0.40F, 0.38F), kWhite(0.88F, 0.89F, 0.90F);
constexpr double kWallStepM = 4.0, kPostM = 2.5, kSleeperM = 0.65, kGaugeM = 1.5, kContactM = 55.0;
constexpr int kWirePieces = 12;

glm::dvec2 leftOf(const glm::dvec2& along)
{
    return {-along.y, along.x};
}

/// A place on a line, with its direction.
struct LinePlace
{
    glm::dvec3 place;
    glm::dvec2 along;
};

/// Builds one structure after the other.
class StructureMaker
{
public:
    StructureMaker(StructureSquares& squares, const foundation::HeightInPlan& ground)
        : _beams(squares), _ground(ground)
    {
    }

    /// Returns false where a place has no ground.
    bool add(const Structure& structure)
    {
        switch (structure.kind)
        {
        case StructureKind::powerLine:
        case StructureKind::poleLine:
            return addPower(structure);
        case StructureKind::windTurbine:
            return addTurbine(structure);
        case StructureKind::railway:
            return addRailway(structure);
        case StructureKind::footbridge:
        case StructureKind::footRamp:
            addFootbridge(structure, _ground, _beams);
            return true;
        case StructureKind::fence:
        case StructureKind::wall:
            break;
        }
        return addBarrier(structure);
    }

private:
    StructureSquare& at(const glm::dvec3& place) { return _beams.at(place); }
    static Beams in(StructureSquare& square, Facets StructureSquare::*part, const glm::vec3& colour)
    {
        return SquareBeams::in(square, part, colour);
    }

    /// Places on the ground along a line, at its points and between, `stepM` apart at most.
    std::vector<LinePlace> placesOn(const std::vector<glm::dvec2>& line, double stepM) const
    {
        std::vector<LinePlace> places;
        for (std::size_t i = 0; i + 1 < line.size(); ++i)
        {
            const double lengthM = glm::distance(line[i], line[i + 1]);
            if (lengthM < 1e-3) continue;
            const int steps = std::max(1, static_cast<int>(std::ceil(lengthM / stepM)));
            for (int step = places.empty() ? 0 : 1; step <= steps; ++step)
            {
                const glm::dvec2 place = glm::mix(line[i], line[i + 1], static_cast<double>(step) / steps);
                const auto height = _ground(place);
                if (!height) return {};
                places.push_back({{place, *height}, (line[i + 1] - line[i]) / lengthM});
            }
        }
        return places;
    }

    bool addBarrier(const Structure& structure)
    {
        const bool isWall = structure.kind == StructureKind::wall;
        const auto places = placesOn(structure.line, isWall ? kWallStepM : kPostM);
        models::Dice dice(structure.id);
        const glm::vec3 stone = kStone * static_cast<float>(dice.between(0.85, 1.15));
        for (std::size_t i = 0; i + 1 < places.size(); ++i)
            if (isWall)
                addWallPiece(structure, places[i], places[i + 1].place, stone);
            else
                addFencePiece(structure, places[i], places[i + 1].place);
        return !places.empty();
    }

    void addWallPiece(const Structure& structure, const LinePlace& from, const glm::dvec3& to,
                      const glm::vec3& stone)
    {
        const glm::dvec3 up(0.0, 0.0, structure.heightM);
        in(at(from.place), &StructureSquare::low, stone)
            .slab({from.place + up, to + up, 0.5 * structure.widthM * leftOf(from.along), from.place.z - 0.4,
                   to.z - 0.4});
    }

    void addFencePiece(const Structure& structure, const LinePlace& from, const glm::dvec3& to)
    {
        Beams beams = in(at(from.place), &StructureSquare::low, kWood);
        beams.bar(from.place - glm::dvec3(0, 0, 0.3), from.place + glm::dvec3(0, 0, structure.heightM), 0.05,
                  0.05, 4);
        for (const double share : {0.45, 0.9})
        {
            const glm::dvec3 up(0.0, 0.0, share * structure.heightM);
            beams.slab({from.place + up, to + up, 0.02 * leftOf(from.along), from.place.z + up.z - 0.1,
                        to.z + up.z - 0.1});
        }
    }

    bool addPower(const Structure& line)
    {
        const auto supports = supportsOf(line, _ground);
        const bool isPoles = line.kind == StructureKind::poleLine;
        for (const Support& support : supports)
            isPoles ? addPole(support) : addPylon(support);
        for (std::size_t i = 0; i + 1 < supports.size(); ++i)
            for (const WirePlace& wire : wiresOf(line.kind))
                addWire(supports[i], supports[i + 1], wire, isPoles);
        return !supports.empty();
    }

    void addWire(const Support& a, const Support& b, const WirePlace& wire, bool isOfPoles)
    {
        const auto points = catenary(wireAt(a, wire), wireAt(b, wire),
                                     isOfPoles ? kPoleConstantM : kLineConstantM, kWirePieces);
        for (std::size_t i = 0; i + 1 < points.size(); ++i)
            in(at(points[i]), isOfPoles ? &StructureSquare::fine : &StructureSquare::low, kWire)
                .bar(points[i], points[i + 1], wire.isEarth ? 0.02 : 0.03);
    }

    void addPole(const Support& support)
    {
        StructureSquare& square = at(support.foot);
        const glm::dvec3 top = support.foot + glm::dvec3(0, 0, support.heightM);
        for (const auto part : {&StructureSquare::fine, &StructureSquare::coarse})
        {
            Beams beams = in(square, part, kWood);
            beams.bar(support.foot - glm::dvec3(0, 0, 1), top, 0.15, 0.1,
                      part == &StructureSquare::fine ? 6 : 3);
            const glm::dvec3 arm(1.1 * leftOf(support.along), 0.0), down(0, 0, 0.06 * support.heightM);
            beams.bar(top - arm - down, top + arm - down, 0.07);
        }
    }

    /// The corner of a mast: its half width falls to the waist at 0.6 of the height, and slowly above.
    static glm::dvec3 cornerOf(const Support& support, int corner, double share)
    {
        const double foot = 0.075 * support.heightM, waist = 0.024 * support.heightM,
                     tip = 0.008 * support.heightM;
        const double half =
            share < 0.6 ? std::lerp(foot, waist, share / 0.6) : std::lerp(waist, tip, (share - 0.6) / 0.4);
        const glm::dvec2 ahead = support.along, left = leftOf(ahead);
        const double x = corner == 0 || corner == 3 ? half : -half, y = corner < 2 ? half : -half;
        return support.foot + glm::dvec3(x * ahead + y * left, share * support.heightM);
    }

    void addPylon(const Support& support)
    {
        StructureSquare& square = at(support.foot);
        Beams fine = in(square, &StructureSquare::fine, kSteel);
        Beams coarse = in(square, &StructureSquare::coarse, kSteel);
        constexpr std::array<double, 8> kLevels{0.0, 0.2, 0.37, 0.5, 0.62, 0.72, 0.82, 1.0};
        for (int corner = 0; corner < 4; ++corner)
        {
            const int next = (corner + 1) % 4;
            const glm::dvec3 foot = cornerOf(support, corner, 0.0);
            fine.bar(foot - glm::dvec3(0, 0, 2), foot, 0.16);
            coarse.bar(foot - glm::dvec3(0, 0, 2), cornerOf(support, corner, 0.6), 0.16);
            coarse.bar(cornerOf(support, corner, 0.6), cornerOf(support, corner, 1.0), 0.12);
            for (std::size_t level = 0; level + 1 < kLevels.size(); ++level)
            {
                const double low = kLevels[level], high = kLevels[level + 1];
                fine.bar(cornerOf(support, corner, low), cornerOf(support, corner, high), 0.12);
                fine.bar(cornerOf(support, corner, low), cornerOf(support, next, high), 0.06);
                fine.bar(cornerOf(support, next, low), cornerOf(support, corner, high), 0.06);
                fine.bar(cornerOf(support, corner, high), cornerOf(support, next, high), 0.06);
            }
        }
        addArms(support, fine, coarse);
    }

    /// Cross arms where wires hang, and the insulators below them.
    static void addArms(const Support& support, Beams& fine, Beams& coarse)
    {
        constexpr double kInsulatorM = 2.2;
        for (const WirePlace& wire : wiresOf(StructureKind::powerLine))
        {
            if (wire.isEarth) continue;
            const glm::dvec3 hanging = wireAt(support, wire);
            const glm::dvec3 tip = hanging + glm::dvec3(0, 0, kInsulatorM);
            const double share = wire.share + kInsulatorM / support.heightM;
            const int first = wire.leftM > 0.0 ? 0 : 2;
            for (const int corner : {first, first + 1})
            {
                fine.bar(cornerOf(support, corner, share), tip, 0.09);
                fine.bar(cornerOf(support, corner, std::min(share + 0.06, 1.0)), tip, 0.07);
            }
            coarse.bar(cornerOf(support, first, share), tip, 0.12);
            fine.bar(tip, hanging, 0.09);
        }
    }

    bool addTurbine(const Structure& turbine)
    {
        const glm::dvec2 place = turbine.line.front();
        const auto height = _ground(place);
        if (!height) return false;
        const double hubM = turbine.heightM, bladeM = 0.46 * hubM;
        models::Dice dice(turbine.id);
        const double heading = 0.25 * std::numbers::pi, turned = dice.between(0.0, 2.0);
        const glm::dvec2 ahead(std::cos(heading), std::sin(heading));
        StructureSquare& square = at({place, *height});
        for (const auto part : {&StructureSquare::fine, &StructureSquare::coarse})
        {
            Beams beams = in(square, part, kWhite);
            const glm::dvec3 foot(place, *height - 2.0), top(place, *height + hubM);
            beams.bar(foot, top, 0.022 * hubM, 0.012 * hubM, part == &StructureSquare::fine ? 16 : 8);
            beams.box(top, ahead, {0.05 * hubM, 0.018 * hubM, 0.018 * hubM});
            const glm::dvec3 hub = top + glm::dvec3(0.06 * hubM * ahead, 0.0);
            for (int blade = 0; blade < 3; ++blade)
            {
                const double angle = turned + 2.0 * std::numbers::pi * blade / 3.0;
                const glm::dvec3 out(std::cos(angle) * leftOf(ahead), std::sin(angle));
                beams.bar(hub, hub + 0.25 * bladeM * out, 0.012 * hubM, 0.018 * hubM, 6);
                beams.bar(hub + 0.25 * bladeM * out, hub + bladeM * out, 0.018 * hubM, 0.003 * hubM, 6);
            }
        }
        return true;
    }

    /// Places along a line that has heights of its own.
    static std::vector<LinePlace> placesAt(const Structure& railway)
    {
        std::vector<LinePlace> places;
        const auto& line = railway.line;
        for (std::size_t i = 0; i < line.size(); ++i)
        {
            const std::size_t from = i + 1 < line.size() ? i : i - 1;
            const glm::dvec2 way = line[from + 1] - line[from];
            const double lengthM = glm::length(way);
            if (lengthM < 1e-3) continue;
            places.push_back({{line[i], railway.heightsM[i]}, way / lengthM});
        }
        return places;
    }

    bool addRailway(const Structure& railway)
    {
        const bool hasHeights = railway.heightsM.size() == railway.line.size();
        auto places = hasHeights ? placesAt(railway) : placesOn(railway.line, kWallStepM);
        if (places.empty()) return false;
        if (railway.isBridge && !hasHeights) span(places);
        if (railway.isTunnel && hasHeights) addRailTube(railway, _beams);
        double sleeperM = 0.0, poleM = 0.5 * kContactM;
        for (std::size_t i = 0; i + 1 < places.size(); ++i)
        {
            addTrack(railway, places[i], places[i + 1].place, sleeperM);
            poleM += glm::distance(places[i].place, places[i + 1].place);
            if (!railway.hasWire) continue;
            addContactWire(places[i], places[i + 1].place, railway.isTunnel);
            if (poleM < kContactM || railway.isTunnel) continue;
            poleM = 0.0;
            addContactPole(places[i]);
        }
        return true;
    }

    /// A straight deck between the ends.
    static void span(std::vector<LinePlace>& places)
    {
        const double from = places.front().place.z, to = places.back().place.z;
        for (std::size_t i = 0; i < places.size(); ++i)
            places[i].place.z =
                std::lerp(from, to, static_cast<double>(i) / static_cast<double>(places.size() - 1));
    }

    void addTrack(const Structure& railway, const LinePlace& from, const glm::dvec3& to, double& sleeperM)
    {
        constexpr double kBedM = 0.25, kRailTopM = 0.55;
        StructureSquare& square = at(from.place);
        const glm::dvec2 left = leftOf(from.along);
        const glm::dvec3 bed(0.0, 0.0, kBedM), top(0.0, 0.0, kRailTopM);
        const double deepM = railway.isBridge ? 0.9 : 0.3;
        if (!railway.isInStreet)
            in(square, &StructureSquare::low, railway.isBridge ? kStone : kBallast)
                .slab({from.place + bed, to + bed, 1.7 * left, from.place.z - deepM, to.z - deepM});
        Beams rails = in(square, &StructureSquare::low, kRail);
        for (const double side : {-0.5, 0.5})
        {
            const glm::dvec3 out(side * kGaugeM * left, 0.0);
            rails.slab(
                {from.place + top + out, to + top + out, 0.035 * left, from.place.z + kBedM, to.z + kBedM});
        }
        if (railway.isInStreet) return;
        Beams sleepers = in(square, &StructureSquare::fine, kSleeper);
        const double lengthM = glm::distance(from.place, to);
        for (; sleeperM < lengthM; sleeperM += kSleeperM)
            sleepers.box(glm::mix(from.place, to, sleeperM / lengthM) + glm::dvec3(0, 0, kBedM + 0.04),
                         from.along, {0.12, 1.25, 0.08});
        sleeperM -= lengthM;
    }

    void addContactWire(const LinePlace& from, const glm::dvec3& to, bool isInTube)
    {
        for (const double up : {5.9, 7.1})
            if (up < 6.0 || !isInTube)
                in(at(from.place), &StructureSquare::fine, kWire)
                    .bar(from.place + glm::dvec3(0, 0, up), to + glm::dvec3(0, 0, up), 0.015);
    }

    void addContactPole(const LinePlace& at3)
    {
        Beams beams = in(at(at3.place), &StructureSquare::low, kSteel);
        const glm::dvec3 foot = at3.place + glm::dvec3(3.3 * leftOf(at3.along), -0.5);
        beams.bar(foot, foot + glm::dvec3(0, 0, 8.3), 0.14, 0.11, 6);
        beams.bar(foot + glm::dvec3(0, 0, 7.2), at3.place + glm::dvec3(0, 0, 6.9), 0.05);
        beams.bar(foot + glm::dvec3(0, 0, 6.4), at3.place + glm::dvec3(0, 0, 6.9), 0.04);
    }

    SquareBeams _beams;
    const foundation::HeightInPlan& _ground;
};

} // namespace

StructureSquares structureFacets(std::span<const Structure> structures,
                                 const foundation::HeightInPlan& ground, std::size_t& beyondGround)
{
    StructureSquares squares;
    StructureMaker maker(squares, ground);
    for (const Structure& structure : structures)
        if (!maker.add(structure)) ++beyondGround;
    return squares;
}

} // namespace scenery
