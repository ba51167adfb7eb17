// SPDX-License-Identifier: Apache-2.0
#include "scenery/buildings/BuildingFacets.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <foundation/Random.h>

#include <osgPMObjects/core/tessellate/Tessellation.h>

#include "scenery/buildings/ControlTower.h"
#include "scenery/buildings/Outline.h"
#include "scenery/buildings/RoofPlanes.h"
#include "scenery/models/houses/DetailAtlas.h"
#include "scenery/models/houses/GableRoof.h"
#include "scenery/models/houses/Wall.h"

namespace scenery
{

namespace
{

using models::Detail;

constexpr double kEavesOutM = 0.45, kFasciaM = 0.22;
constexpr double kUnderEavesM = 1.0; ///< of a wall: there the eaves hide a tenth of what it sees of the sky
constexpr float kSkyAtEaves = 0.35F; ///< what the ground throws up is left
constexpr double kProudM = 0.04;
constexpr double kPostsM = 6.0, kPostInM = 0.3, kPostHalfM = 0.1, kPostFootM = 0.3;
constexpr float kPlinthShade = 0.62F; ///< of the wall's colour
constexpr double kClearM = 0.15;      ///< from the ground to the sill of a window
constexpr double kHighStepM = 1.5;    ///< a door stands no higher above the ground: it opens into the plinth
constexpr double kWindowHalfM = 0.6, kSillM = 0.95, kHeadM = 2.3, kAxisM = 3.1, kDoorHalfM = 0.6,
                 kDoorM = 2.15, kShopSillM = 0.4;

/// Adds the parts of one building.
class Maker
{
public:
    Maker(const StandingBuilding& standing, const glm::dvec3& origin, BuildingFacets& facets)
        : _standing(standing),
          _building(standing.building),
          _roof(standing.building),
          _origin(origin),
          _facets(facets),
          _eavesM(standing.floorM + standing.building.eavesM)
    {
    }

    void makeShell()
    {
        std::vector<PlanRing> covered = _building.rings;
        if (_building.roof != RoofForm::flat) covered.front() = grownRing(covered.front(), kEavesOutM);
        for (const PlanRing& ring : _building.rings)
        {
            const bool hasEaves = &ring == &_building.rings.front() && covered.front() != ring;
            for (std::size_t i = 0; i < ring.size(); ++i)
                addWall(ring[i], ring[(i + 1) % ring.size()], hasEaves);
        }
        addRoof(covered);
        if (isLifted()) addUnderside();
        if (_building.isOnPosts) addPosts();
        for (std::size_t i = 0; i < covered.front().size(); ++i)
            addEaves(i, covered.front());
    }

    void makeOpenings()
    {
        if (_building.openings != Openings::none) addOpenings();
    }

private:
    bool isLifted() const { return _building.liftedM > 0.0; }

    glm::vec3 local(const glm::dvec2& place, double heightM) const
    {
        return glm::vec3(glm::dvec3(place, heightM) - _origin);
    }

    void addWall(const glm::dvec2& from, const glm::dvec2& to, bool hasEaves)
    {
        const double lengthM = glm::length(to - from),
                     lowM = std::max(_standing.footM, _standing.floorM) + _building.liftedM;
        if (!isLifted()) addPlinth(from, to, lowM);
        std::vector<double> shares{0.0};
        for (const double share : _roof.breaksOn(from, to))
            shares.push_back(share);
        shares.push_back(1.0);
        std::vector<glm::vec3> corners{local(from, lowM), local(to, lowM)};
        std::vector<glm::vec2> uv{uvOf(0.0, lowM), uvOf(lengthM, lowM)};
        for (auto share = shares.rbegin(); share != shares.rend(); ++share)
        {
            const glm::dvec2 place = glm::mix(from, to, *share);
            const double topM = std::max(_eavesM + _roof.heightM(place), lowM);
            const double freeM = hasEaves ? std::max(topM - kUnderEavesM, lowM) : topM;
            corners.push_back(local(place, freeM));
            uv.push_back(uvOf(*share * lengthM, freeM));
        }
        _facets.shell[_building.wall].addPolygon(corners, uv, _building.wallTint);
        for (std::size_t i = 0; hasEaves && i + 1 < shares.size(); ++i)
            addUnderEaves(from, to, {shares[i], shares[i + 1]}, lowM);
    }

    /// The part of a wall from one share of its length to another that lies in the shade of the eaves.
    void addUnderEaves(const glm::dvec2& from, const glm::dvec2& to, const glm::dvec2& shares, double lowM)
    {
        const double lengthM = glm::length(to - from);
        std::vector<glm::vec3> corners;
        std::vector<glm::vec2> uv;
        const auto add = [&](double share, bool isTop)
        {
            const glm::dvec2 place = glm::mix(from, to, share);
            const double topM = std::max(_eavesM + _roof.heightM(place), lowM);
            const double heightM = isTop ? topM : std::max(topM - kUnderEavesM, lowM);
            corners.push_back(local(place, heightM));
            uv.push_back(uvOf(share * lengthM, heightM));
        };
        add(shares.x, false);
        add(shares.y, false);
        add(shares.y, true);
        add(shares.x, true);
        _facets.shell[_building.wall].addPolygon(corners, uv, _building.wallTint,
                                                 {1.0F, 1.0F, kSkyAtEaves, kSkyAtEaves});
    }

    /// The wall below the floor, which shows where the ground falls.
    void addPlinth(const glm::dvec2& from, const glm::dvec2& to, double topM)
    {
        const double lengthM = glm::length(to - from), footM = _standing.footM;
        _facets.shell[_building.wall].addPolygon(
            {local(from, footM), local(to, footM), local(to, topM), local(from, topM)},
            {uvOf(0.0, footM), uvOf(lengthM, footM), uvOf(lengthM, topM), uvOf(0.0, topM)},
            kPlinthShade * _building.wallTint);
    }

    glm::vec2 uvOf(double alongM, double heightM) const
    {
        return glm::vec2(glm::dvec2(alongM, heightM - _standing.floorM) / models::kWallPictureM);
    }

    /// Calls `use` with the triangles of an area, counter-clockwise seen from above.
    template<class Use>
    void forTriangles(const std::vector<PlanRing>& rings, const Use& use) const
    {
        std::vector<glm::dvec3> corners;
        std::vector<std::uint32_t> sizes;
        for (const PlanRing& ring : rings)
        {
            sizes.push_back(static_cast<std::uint32_t>(ring.size()));
            for (const glm::dvec2& corner : ring)
                corners.emplace_back(corner - glm::dvec2(_origin), 0.0);
        }
        const auto tessellation = osgPMObjects::core::tessellate(corners, sizes);
        if (!tessellation) return;
        for (const auto& inserted : tessellation->inserted)
        {
            glm::dvec3 at(0.0);
            for (std::size_t i = 0; i < inserted.corners.size(); ++i)
                at += inserted.weights[i] * corners[inserted.corners[i]];
            corners.push_back(at);
        }
        for (const auto& indices : tessellation->triangles)
        {
            std::array<glm::dvec2, 3> triangle{glm::dvec2(corners[indices[0]]),
                                               glm::dvec2(corners[indices[1]]),
                                               glm::dvec2(corners[indices[2]])};
            const glm::dvec2 ab = triangle[1] - triangle[0], ac = triangle[2] - triangle[0];
            if (ab.x * ac.y - ab.y * ac.x < 0.0) std::swap(triangle[1], triangle[2]);
            for (glm::dvec2& corner : triangle)
                corner += glm::dvec2(_origin);
            use(triangle);
        }
    }

    void addRoof(const std::vector<PlanRing>& rings)
    {
        forTriangles(rings, [this](const std::array<glm::dvec2, 3>& triangle) { addRoofTriangle(triangle); });
    }

    /// The ceiling of a passage.
    void addUnderside()
    {
        const double heightM = std::max(_standing.footM, _standing.floorM) + _building.liftedM;
        forTriangles(_building.rings,
                     [&](const std::array<glm::dvec2, 3>& triangle)
                     {
                         std::vector<glm::vec3> corners;
                         std::vector<glm::vec2> uv;
                         for (const std::size_t i : {2, 1, 0})
                         {
                             corners.push_back(local(triangle[i], heightM));
                             uv.emplace_back((triangle[i] - glm::dvec2(_origin)) / models::kWallPictureM);
                         }
                         _facets.shell[_building.wall].addPolygon(corners, uv,
                                                                  kPlinthShade * _building.wallTint,
                                                                  std::vector<float>(3, kSkyAtEaves));
                     });
    }

    /// Posts below the outer edge of a roof without walls, at its corners and not farther apart than
    /// kPostsM.
    void addPosts()
    {
        const PlanRing ring = grownRing(_building.rings.front(), -kPostInM);
        for (std::size_t i = 0; i < ring.size(); ++i)
        {
            const glm::dvec2 &from = ring[i], &to = ring[(i + 1) % ring.size()];
            const int spans = std::max(1, static_cast<int>(std::ceil(glm::length(to - from) / kPostsM)));
            for (int span = 0; span < spans; ++span)
            {
                const double share = static_cast<double>(span) / spans;
                addPost(glm::mix(from, to, share), _standing.groundAt(0, i, share));
            }
        }
    }

    void addPost(const glm::dvec2& place, double groundM)
    {
        const double footM = std::min(groundM, _standing.floorM) - kPostFootM,
                     topM = std::max(_standing.footM, _standing.floorM) + _building.liftedM;
        constexpr std::array<glm::dvec2, 4> kCorners{{{-kPostHalfM, -kPostHalfM},
                                                      {kPostHalfM, -kPostHalfM},
                                                      {kPostHalfM, kPostHalfM},
                                                      {-kPostHalfM, kPostHalfM}}};
        for (std::size_t i = 0; i < kCorners.size(); ++i)
        {
            const glm::dvec2 a = place + kCorners[i], b = place + kCorners[(i + 1) % kCorners.size()];
            _facets.shell[_building.wall].addPolygon(
                {local(a, footM), local(b, footM), local(b, topM), local(a, topM)},
                {uvOf(0.0, footM), uvOf(2.0 * kPostHalfM, footM), uvOf(2.0 * kPostHalfM, topM),
                 uvOf(0.0, topM)},
                kPlinthShade * _building.wallTint);
        }
    }

    void addRoofTriangle(const std::array<glm::dvec2, 3>& triangle)
    {
        for (const RoofPlanes::Part& part : _roof.partsOf(triangle))
        {
            std::vector<glm::vec3> corners;
            std::vector<glm::vec2> uv;
            const double slope = glm::length(part.gradient);
            const glm::dvec2 up = slope > 1e-6 ? part.gradient / slope : glm::dvec2(0.0, 1.0);
            for (const glm::dvec2& corner : part.corners)
            {
                const glm::dvec2 at = corner - glm::dvec2(_origin);
                corners.push_back(local(corner, _eavesM + _roof.heightM(corner)));
                uv.emplace_back(
                    glm::dvec2(at.x * up.y - at.y * up.x, glm::dot(at, up) * std::hypot(1.0, slope)) /
                    models::kRoofPictureM);
            }
            _facets.shell[_building.cover].addPolygon(corners, uv, _building.roofTint);
        }
    }

    /// The board along an edge of the roof, and what closes it to the wall from below.
    void addEaves(std::size_t edge, const PlanRing& outer)
    {
        const PlanRing& wall = _building.rings.front();
        const std::size_t next = (edge + 1) % outer.size();
        if (outer[edge] == wall[edge]) return; // no eaves
        std::vector<double> shares{0.0};
        for (const double share : _roof.breaksOn(outer[edge], outer[next]))
            shares.push_back(share);
        shares.push_back(1.0);
        for (std::size_t i = 0; i + 1 < shares.size(); ++i)
        {
            const glm::dvec2 a = glm::mix(outer[edge], outer[next], shares[i]);
            const glm::dvec2 b = glm::mix(outer[edge], outer[next], shares[i + 1]);
            const glm::dvec2 c = glm::mix(wall[edge], wall[next], shares[i]);
            const glm::dvec2 d = glm::mix(wall[edge], wall[next], shares[i + 1]);
            const double aM = _eavesM + _roof.heightM(a), bM = _eavesM + _roof.heightM(b);
            addBoard({local(a, aM - kFasciaM), local(b, bM - kFasciaM), local(b, bM), local(a, aM)}, 1.0F);
            addBoard({local(c, _eavesM + _roof.heightM(c) - kFasciaM),
                      local(d, _eavesM + _roof.heightM(d) - kFasciaM), local(b, bM - kFasciaM),
                      local(a, aM - kFasciaM)},
                     kSkyAtEaves);
        }
    }

    void addBoard(const std::vector<glm::vec3>& corners, float skyShare)
    {
        _facets.shell[_building.cover].addPolygon(
            corners, std::vector<glm::vec2>(corners.size(), glm::vec2(0.2F)), 0.7F * _building.roofTint,
            std::vector<float>(corners.size(), skyShare));
    }

    void addOpenings()
    {
        for (std::size_t r = 0; r < _building.rings.size(); ++r)
            for (std::size_t i = 0; i < _building.rings[r].size(); ++i)
                addAxes(r, i);
    }

    void addAxes(std::size_t ring, std::size_t edge)
    {
        const PlanRing& corners = _building.rings[ring];
        const glm::dvec2 &from = corners[edge], &to = corners[(edge + 1) % corners.size()];
        const double lengthM = glm::length(to - from);
        if (_building.openings == Openings::hangar) return addGate(from, to, lengthM);
        if (_building.openings == Openings::control) addGlassBand(from, to, lengthM);
        const int axes = static_cast<int>((lengthM - 0.6) / kAxisM + 0.25);
        const bool hasDoor = ring == 0 && edge == _standing.doorEdge && !isLifted();
        for (int axis = 0; axis < axes; ++axis)
        {
            const double share = (axis + 0.5) / axes, groundM = _standing.groundAt(ring, edge, share);
            const bool isDoor = hasDoor && axis == axes / 2;
            if (isDoor) addDoor(from, to, share * lengthM, groundM);
            if (_building.openings == Openings::control) continue;
            for (int storey = isDoor ? 1 : 0; storey < _building.storeys; ++storey)
                addWindow(from, to, {share * lengthM, lengthM / axes, groundM}, storey);
        }
    }

    void addDoor(const glm::dvec2& from, const glm::dvec2& to, double middleM, double groundM)
    {
        const double floorM =
            _standing.floorM - groundM > kHighStepM ? groundM : std::max(_standing.floorM, groundM);
        addOpening(from, to,
                   {middleM, kDoorHalfM, floorM + 0.05, floorM + kDoorM,
                    _building.hasShop ? Detail::glassDoor : Detail::door, _building.doorTint});
    }

    /// The gates of a hangar are in its gables.
    void addGate(const glm::dvec2& from, const glm::dvec2& to, double lengthM)
    {
        constexpr double kGateShare = 0.84, kLeastGateM = 6.0;
        const PlanRectangle box = rectangleAround(_building.rings.front());
        const glm::dvec2 ridge = _building.isRidgeAcross ? box.across() : box.along;
        if (lengthM < kLeastGateM || std::abs(glm::dot(ridge, to - from)) > 0.1 * lengthM) return;
        addOpening(from, to,
                   {0.5 * lengthM, 0.5 * kGateShare * lengthM, _standing.floorM + 0.05,
                    _standing.floorM + 0.94 * _building.eavesM, Detail::gate, _building.doorTint});
    }

    /// The highest storey of a control tower is glass all around.
    void addGlassBand(const glm::dvec2& from, const glm::dvec2& to, double lengthM)
    {
        const double storeyM = _building.eavesM / _building.storeys,
                     lowM = _standing.floorM + _building.eavesM - storeyM;
        const int panes = std::max(1, static_cast<int>(std::lround(lengthM / 1.8)));
        for (int pane = 0; pane < panes; ++pane)
            addOpening(from, to,
                       {(pane + 0.5) * lengthM / panes, 0.5 * lengthM / panes, lowM + 0.7,
                        lowM + storeyM - 0.15, Detail::shopFront, glm::vec3(0.85F)});
    }

    /// The place of windows over each other. Units: metres.
    struct Axis
    {
        double middleM, spacingM, groundM;
    };

    void addWindow(const glm::dvec2& from, const glm::dvec2& to, const Axis& axis, int storey)
    {
        const double storeyM = _building.eavesM / _building.storeys,
                     floorM = _standing.floorM + storey * storeyM;
        const bool isShop = _building.hasShop && storey == 0;
        const double sillM = floorM + (isShop ? kShopSillM : kSillM);
        if (sillM < axis.groundM + kClearM) return;                                       // in the ground
        if (isLifted() && sillM < _standing.floorM + _building.liftedM + kClearM) return; // below the house
        if (isShop)
            addOpening(from, to,
                       {axis.middleM, 0.45 * axis.spacingM, floorM + kShopSillM, floorM + 2.5,
                        Detail::shopFront, glm::vec3(0.9F)});
        else
            addOpening(from, to,
                       {axis.middleM, kWindowHalfM, floorM + kSillM,
                        floorM + std::min(kHeadM, storeyM - 0.15), Detail::window, glm::vec3(1.0F)});
    }

    /// A rectangle in a wall: its middle along the wall, half its width, its lower and its upper edge.
    struct Opening
    {
        double middleM, halfM, lowM, highM;
        Detail detail;
        glm::vec3 tint;
    };

    void addOpening(const glm::dvec2& from, const glm::dvec2& to, const Opening& opening)
    {
        const auto& [middleM, halfM, lowM, highM, detail, tint] = opening;
        const glm::dvec2 along = glm::normalize(to - from), out(along.y, -along.x);
        const glm::dvec2 left = from + along * (middleM - halfM) + out * kProudM;
        const glm::dvec2 right = from + along * (middleM + halfM) + out * kProudM;
        const models::CellUv uv = models::uvOf(detail);
        if (detail == Detail::window || detail == Detail::shopFront)
            addPane({left, lowM}, {right, lowM}, highM - lowM, detail);
        _facets.openings.addPolygon(
            {local(left, lowM), local(right, lowM), local(right, highM), local(left, highM)},
            {uv.at(0.0F, 0.0F), uv.at(1.0F, 0.0F), uv.at(1.0F, 1.0F), uv.at(0.0F, 1.0F)}, tint);
    }

    void addPane(const glm::dvec3& left, const glm::dvec3& right, double heightM, Detail detail)
    {
        const glm::i64vec3 place(glm::floor(10.0 * left)); // chance follows from the place
        const auto bits =
            static_cast<std::uint64_t>(place.x * 73856093 ^ place.y * 19349663 ^ place.z * 83492791);
        const bool isShop = detail == Detail::shopFront && _building.openings == Openings::house;
        _facets.panes.push_back({left, right, heightM, isShop ? RoomUse::shop : _building.rooms,
                                 foundation::mixedBits(bits + 1)});
    }

    const StandingBuilding& _standing;
    const Building& _building;
    RoofPlanes _roof;
    glm::dvec3 _origin;
    BuildingFacets& _facets;
    double _eavesM;
};

std::vector<StandingBuilding> partsOf(const StandingBuilding& standing)
{
    return standing.building.openings == Openings::control ? partsOfControlTower(standing)
                                                           : std::vector{standing};
}

} // namespace

void Facets::addPolygon(const std::vector<glm::vec3>& corners, const std::vector<glm::vec2>& uv,
                        const glm::vec3& colour, const std::vector<float>& skyShares)
{
    glm::vec3 normal(0.0F); // twice the area (Newell)
    for (std::size_t i = 0; i < corners.size(); ++i)
        normal += glm::cross(corners[i] - corners[0], corners[(i + 1) % corners.size()] - corners[0]);
    const float length = glm::length(normal);
    if (!(length > 1e-5F)) return;
    const auto first = static_cast<std::uint32_t>(positions.size());
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
        positions.push_back(corners[i]);
        normals.push_back(normal / length);
        colours.push_back(colour);
        uvs.push_back(uv[i]);
        skies.push_back(skyShares.empty() ? 1.0F : skyShares[i]);
    }
    for (std::uint32_t i = 1; i + 1 < corners.size(); ++i)
        indices.insert(indices.end(), {first, first + i, first + i + 1});
}

void addShell(const StandingBuilding& standing, const glm::dvec3& origin, BuildingFacets& facets)
{
    for (const StandingBuilding& part : partsOf(standing))
        Maker(part, origin, facets).makeShell();
}

void addOpenings(const StandingBuilding& standing, const glm::dvec3& origin, BuildingFacets& facets)
{
    for (const StandingBuilding& part : partsOf(standing))
        Maker(part, origin, facets).makeOpenings();
}

} // namespace scenery
