// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <ostream>
#include <set>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include <osgRoads/core/query/LaneSpan.h>
#include <osgRoads/core/query/RoadSurface.h>
#include <osgRoads/core/surface/BuildRoadMesh.h>

/// What is drawn of a network's roads, seen from above.
class DrawnRoads
{
public:
    struct Sample
    {
        double heightM = 0.0;
        osgRoads::core::SurfaceKind kind = osgRoads::core::SurfaceKind::asphalt;

        bool isPaved() const
        {
            using osgRoads::core::SurfaceKind;
            return kind == SurfaceKind::asphalt || kind == SurfaceKind::shoulder;
        }
        /// Steps up to sidewalks are meant to be there.
        bool isKerb() const
        {
            using osgRoads::core::SurfaceKind;
            return kind == SurfaceKind::sidewalk || kind == SurfaceKind::kerb;
        }
    };

    explicit DrawnRoads(osgRoads::core::RoadMesh mesh) : _mesh(std::move(mesh))
    {
        for (const auto& chunk : _mesh.chunks)
            for (std::uint32_t i = 0; i < chunk.levels.front().indexCount; i += 3)
                add(chunk.levels.front().firstIndex + i);
    }

    /// The highest surface at a place, where anything is drawn.
    std::optional<Sample> at(glm::dvec2 place) const
    {
        std::optional<Sample> highest;
        const auto cell = _cells.find(cellOf(place));
        if (cell == _cells.end()) return highest;
        for (const std::uint32_t first : cell->second)
            if (const auto sample = onTriangle(first, place);
                sample && (!highest || sample->heightM > highest->heightM))
                highest = sample;
        return highest;
    }

    /// The area of what is drawn of paving with its underside up: surfaces that are folded over. Square
    /// metres.
    double foldedM2() const
    {
        double folded = 0.0;
        for (const auto& chunk : _mesh.chunks)
            for (std::uint32_t i = 0; i < chunk.levels.front().indexCount; i += 3)
                folded += foldedM2Of(chunk.levels.front().firstIndex + i);
        return folded;
    }

private:
    double foldedM2Of(std::uint32_t first) const
    {
        const auto& corner = vertex(first);
        if (isGround(corner.kind) || corner.kind == osgRoads::core::SurfaceKind::kerb) return 0.0; // upright
        for (std::uint32_t i = 0; i < 3; ++i)
            if (vertex(first + i).present < 128) return 0.0;
        const glm::dvec2 from(_mesh.placeOf(corner)), a = glm::dvec2(_mesh.placeOf(vertex(first + 1))) - from,
                                                      b = glm::dvec2(_mesh.placeOf(vertex(first + 2))) - from;
        return std::max(0.0, -0.5 * (a.x * b.y - a.y * b.x));
    }

    static constexpr double kCellM = 1.0;
    static std::pair<int, int> cellOf(glm::dvec2 place)
    {
        return {static_cast<int>(std::floor(place.x / kCellM)),
                static_cast<int>(std::floor(place.y / kCellM))};
    }

    const osgRoads::core::MeshVertex& vertex(std::uint32_t index) const
    {
        return _mesh.vertices[_mesh.indices[index]];
    }

    void add(std::uint32_t first)
    {
        glm::dvec2 least(1e300), most(-1e300);
        for (std::uint32_t i = 0; i < 3; ++i)
        {
            const glm::dvec2 place(_mesh.placeOf(vertex(first + i)));
            least = glm::min(least, place), most = glm::max(most, place);
        }
        const auto [left, low] = cellOf(least);
        const auto [right, high] = cellOf(most);
        for (int x = left; x <= right; ++x)
            for (int y = low; y <= high; ++y)
                _cells[{x, y}].push_back(first);
    }

    std::optional<Sample> onTriangle(std::uint32_t first, glm::dvec2 place) const
    {
        std::array<glm::dvec3, 3> corners;
        for (std::uint32_t i = 0; i < 3; ++i)
            corners[i] = _mesh.placeOf(vertex(first + i));
        const glm::dvec2 a(corners[1] - corners[0]), b(corners[2] - corners[0]),
            way = place - glm::dvec2(corners[0]);
        const double area = a.x * b.y - a.y * b.x;
        if (std::fabs(area) < 1e-9) return std::nullopt;
        constexpr double kInside = -1e-3; // of a triangle's width: corners lie on steps of 1 mm
        const double u = (way.x * b.y - way.y * b.x) / area, v = (a.x * way.y - a.y * way.x) / area;
        if (u < kInside || v < kInside || u + v > 1.0 - kInside) return std::nullopt;
        const double present = (1.0 - u - v) * vertex(first).present + u * vertex(first + 1).present +
                               v * vertex(first + 2).present;
        if (present < 127.5) return std::nullopt; // cut in the fragment, as RoadMaterials.glsl does
        return Sample{(1.0 - u - v) * corners[0].z + u * corners[1].z + v * corners[2].z, vertex(first).kind};
    }

    osgRoads::core::RoadMesh _mesh;
    std::map<std::pair<int, int>, std::vector<std::uint32_t>> _cells;
};

/// What sections across junctions show.
struct PavingFaults
{
    std::size_t samples = 0; ///< on paving
    std::size_t steps = 0, holes = 0, wedges = 0, planted = 0;
    glm::dvec2 place{0.0}; ///< of the last fault

    std::size_t count() const { return steps + holes + wedges + planted; }
};

inline std::ostream& operator<<(std::ostream& out, const PavingFaults& faults)
{
    return out << faults.steps << " steps, " << faults.holes << " holes, " << faults.wedges << " wedges, "
               << faults.planted << " planted, the last at " << faults.place.x << ", " << faults.place.y;
}

/// Looks along sections 0.5 m apart in both directions, a sample each 5 cm, within `reachM` of `middle`:
/// paving has no step above 3 cm to the sample beside it (5 cm down to ground at its edge: verges are folded
/// in the tips between arms), no hole, and no wedge of ground within it (up to 1 m across in all of four
/// directions); and `isBare` says that nothing grows on it.
template<class IsBare>
void lookAlong(const DrawnRoads& roads, glm::dvec2 middle, double reachM, const IsBare& isBare,
               PavingFaults& faults)
{
    constexpr double kApartM = 0.5, kSampleM = 0.05, kStepM = 0.03, kEdgeStepM = 0.05, kWedgeM = 1.0;
    const auto isPaved = [&](glm::dvec2 place)
    {
        const auto sample = roads.at(place);
        return sample && (sample->isPaved() || sample->isKerb());
    };
    const auto isClosedIn = [&](glm::dvec2 place)
    {
        for (int direction = 0; direction < 4; ++direction)
        {
            const double angle = direction * 0.785398;
            const glm::dvec2 way(std::cos(angle), std::sin(angle));
            bool before = false, after = false;
            for (double away = 0.1; away <= kWedgeM; away += 0.1)
                before = before || isPaved(place - away * way), after = after || isPaved(place + away * way);
            if (!before || !after) return false;
        }
        return true;
    };
    const auto note = [&](std::size_t& count, glm::dvec2 place) { ++count, faults.place = place; };
    for (int axis = 0; axis < 2; ++axis)
        for (double across = -reachM; across <= reachM; across += kApartM)
        {
            std::optional<DrawnRoads::Sample> before;
            for (double along = -reachM; along <= reachM; along += kSampleM)
            {
                const glm::dvec2 place =
                    middle + (axis == 0 ? glm::dvec2(along, across) : glm::dvec2(across, along));
                const auto here = roads.at(place);
                const bool isFirst = along == -reachM;
                if (here && here->isPaved())
                {
                    ++faults.samples;
                    if (!isBare(glm::dvec3(place, here->heightM))) note(faults.planted, place);
                }
                else if (!(here && here->isKerb()) && isClosedIn(place))
                    note(faults.wedges, place);
                if (!isFirst && ((here && here->isPaved()) || (before && before->isPaved())))
                {
                    if (!here || !before)
                        note(faults.holes, place);
                    else if (!here->isKerb() && !before->isKerb() &&
                             std::fabs(here->heightM - before->heightM) >
                                 (here->isPaved() && before->isPaved() ? kStepM : kEdgeStepM))
                        note(faults.steps, place);
                }
                before = here;
            }
        }
}

/// The junctions of a network that lie on the ground: where, and how far their joints are.
struct JunctionPlace
{
    glm::dvec2 middle{0.0};
    double reachM = 0.0;
};

inline std::vector<JunctionPlace> junctionPlaces(const osgRoads::core::PlacedNetwork& network)
{
    constexpr double kBesideM = 3.0, kMostM = 25.0;
    std::map<int, std::vector<glm::dvec2>> joints;
    std::set<int> raised;
    for (std::size_t i = 0; i < network.network().roads.size(); ++i)
    {
        const auto& road = network.network().roads[i];
        if (road.junction < 0) continue;
        for (const double s : {0.0, road.length})
            joints[road.junction].push_back(glm::dvec2(network.point({static_cast<int>(i), s, 0.0, 0.0})));
        if (!road.structures.empty()) raised.insert(road.junction);
        for (const auto& link : {road.predecessor, road.successor})
            if (link && link->index >= 0 && !link->isJunction &&
                !network.network().roads[static_cast<std::size_t>(link->index)].structures.empty())
                raised.insert(road.junction);
    }
    std::vector<JunctionPlace> places;
    for (const auto& [junction, points] : joints)
    {
        if (raised.count(junction) > 0) continue;
        glm::dvec2 sum(0.0);
        for (const glm::dvec2& point : points)
            sum += point;
        JunctionPlace place{sum / static_cast<double>(points.size()), 0.0};
        for (const glm::dvec2& point : points)
            place.reachM = std::max(place.reachM, glm::distance(point, place.middle));
        place.reachM = std::min(place.reachM + kBesideM, kMostM);
        places.push_back(place);
    }
    return places;
}
