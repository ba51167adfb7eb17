// SPDX-License-Identifier: Apache-2.0
#include "scenery/structures/RailTube.h"

#include <algorithm>

#include "scenery/roads/TunnelOpenings.h"
#include "scenery/roads/things/StructureParts.h"

namespace scenery
{

namespace
{

using osgRoads::core::TunnelTube;
using roads::Profile;

constexpr glm::vec3 kTubeConcrete(0.58F, 0.57F, 0.55F);
constexpr double kTubeHalfM = 2.7;

/// The tube of a railway above its formation: a street's, with room for a contact wire.
TunnelTube railTube()
{
    TunnelTube tube;
    tube.wallM = 5.0, tube.kneeM = 6.2, tube.crownM = 6.6;
    tube.feetM = -0.8, tube.liningM = 0.5;
    tube.portalSideM = 1.4, tube.portalRoofM = 0.9;
    return tube;
}

/// A ring without the walls of a side: its roof goes on level there.
Profile opened(Profile ring, const Structure& railway, const TunnelTube& tube)
{
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
        const bool isOpen = ring[i].x > 1e-6 ? railway.isOpenLeft : ring[i].x < -1e-6 && railway.isOpenRight;
        const bool isOutside = 2 * i < ring.size();
        if (isOpen) ring[i].y = std::max(ring[i].y, tube.crownM + (isOutside ? tube.liningM : 0.0));
        if (isOpen) ring[i].x = std::clamp(ring[i].x, -kTubeHalfM, kTubeHalfM);
    }
    return ring;
}

struct Station
{
    glm::dvec3 place{0.0};
    glm::dvec2 left{0.0};

    glm::dvec3 at(const glm::dvec2& profile) const { return place + glm::dvec3(profile.x * left, profile.y); }
};

void sweep(Beams& beams, const Profile& ring, const Station& from, const Station& to)
{
    const std::size_t half = ring.size() / 2;
    for (std::size_t i = 0; i + 1 < ring.size(); ++i)
        if (i + 1 != half) // the foot
            beams.face(from.at(ring[i]), from.at(ring[i + 1]), to.at(ring[i + 1]), to.at(ring[i]));
}

/// Closes a ring at its first end, or at its last.
void cap(Beams& beams, const Profile& ring, const Station& at, bool isLast)
{
    for (std::size_t i = 0; i + 1 < ring.size() / 2; ++i)
    {
        const glm::dvec3 a = at.at(ring[i]), b = at.at(ring[i + 1]), c = at.at(ring[ring.size() - 2 - i]),
                         d = at.at(ring[ring.size() - 1 - i]);
        isLast ? beams.face(a, b, c, d) : beams.face(d, c, b, a);
    }
}

/// The place on a line so far from its start or end; beyond it where `alongM` is below 0.
Station stationFrom(const Structure& railway, bool isEnd, double alongM)
{
    const auto& line = railway.line;
    const std::size_t count = line.size();
    const auto index = [&](std::size_t k) { return isEnd ? count - 1 - k : k; };
    for (std::size_t k = 0; k + 1 < count; ++k)
    {
        const std::size_t a = index(k), b = index(k + 1);
        const double lengthM = glm::distance(line[a], line[b]);
        if (alongM > lengthM && k + 2 < count)
        {
            alongM -= lengthM;
            continue;
        }
        const double share = std::min(1.0, alongM / std::max(1e-6, lengthM));
        const glm::dvec3 from(line[a], railway.heightsM[a]), to(line[b], railway.heightsM[b]);
        return {glm::mix(from, to, share), leftAt(line, a)};
    }
    return {};
}

void addPortal(const Structure& railway, bool isEnd, const TunnelTube& tube, SquareBeams& beams)
{
    const Profile ring = opened(roads::tunnelPortal(tube, kTubeHalfM), railway, tube);
    const Profile within = opened(roads::tunnelPortalBack(tube, kTubeHalfM), railway, tube);
    const Station front = stationFrom(railway, isEnd, -tube.portalM),
                  mouth = stationFrom(railway, isEnd, 0.0),
                  back = stationFrom(railway, isEnd, kRailPortalBackM);
    Beams made = SquareBeams::in(beams.at(front.place), &StructureSquare::low, kTubeConcrete);
    const auto add = [&](const Profile& profile, const Station& from, const Station& to)
    {
        const Station &first = isEnd ? to : from, &last = isEnd ? from : to;
        sweep(made, profile, first, last);
        cap(made, profile, first, false);
        cap(made, profile, last, true);
    };
    add(ring, front, mouth);
    add(within, mouth, back);
}

} // namespace

void addRailTube(const Structure& railway, SquareBeams& beams)
{
    const TunnelTube tube = railTube();
    const Profile ring = opened(roads::tunnelLining(tube, kTubeHalfM), railway, tube);
    for (std::size_t i = 0; i + 1 < railway.line.size(); ++i)
    {
        const Station from{{railway.line[i], railway.heightsM[i]}, leftAt(railway.line, i)},
            to{{railway.line[i + 1], railway.heightsM[i + 1]}, leftAt(railway.line, i + 1)};
        Beams made = SquareBeams::in(beams.at(from.place), &StructureSquare::low, kTubeConcrete);
        sweep(made, ring, from, to);
    }
    if (railway.isPortalAtStart) addPortal(railway, false, tube, beams);
    if (railway.isPortalAtEnd) addPortal(railway, true, tube, beams);
}

std::vector<osgTerrainROAM::core::GroundOpening> railOpenings(std::span<const Structure> structures)
{
    const TunnelTube tube = railTube();
    std::vector<osgTerrainROAM::core::GroundOpening> openings;
    for (const Structure& railway : structures)
    {
        if (!railway.isTunnel || railway.heightsM.size() != railway.line.size()) continue;
        auto opening = emptyOpening(tube);
        const auto add = [&](const Station& at) {
            opening.line.push_back({at.place, kTubeHalfM + 0.5 * tube.liningM});
        };
        if (railway.isPortalAtStart) add(stationFrom(railway, false, -tube.portalM));
        for (std::size_t i = 0; i < railway.line.size(); ++i)
            add({{railway.line[i], railway.heightsM[i]}, {}});
        if (railway.isPortalAtEnd) add(stationFrom(railway, true, -tube.portalM));
        openings.push_back(std::move(opening));
    }
    return openings;
}

} // namespace scenery
