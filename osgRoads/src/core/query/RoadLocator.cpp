// SPDX-License-Identifier: Apache-2.0
// Source: Roussopoulos, Kelley & Vincent, *Nearest neighbor queries*, 1995 (branch and bound).
#include <algorithm>
#include <limits>
#include <tuple>

#include <osgRoads/core/query/BoxTree.h>
#include <osgRoads/core/query/RoadLocator.h>

#include "RoadCandidate.h"

namespace osgRoads::core
{

namespace
{

constexpr double kNoHeight = std::numeric_limits<double>::quiet_NaN();

double limitOf(double distance)
{
    return (distance + kSameDistanceM) * (distance + kSameDistanceM);
}

} // namespace

struct RoadLocator::Index
{
    explicit Index(const RoadNetwork& networkIn) : network(networkIn), pieces(piecesOf(networkIn))
    {
        std::vector<PlanBox> boxes;
        boxes.reserve(pieces.size());
        for (const RoadPiece& piece : pieces)
            boxes.push_back(piece.box());
        tree = BoxTree(boxes);
    }

    std::optional<RoadMatch> nearest(glm::dvec2 point, double height, double withinM) const
    {
        RoadCandidate best;
        best.match.distance = withinM;
        tree.search(point, limitOf(withinM),
                    [&](std::uint32_t item, double limit)
                    {
                        const RoadPiece& piece = pieces[item];
                        if (piece.squareTo(point) > limit) return limit;
                        const RoadCandidate candidate = candidateOn(network, piece, point, height);
                        if (!candidate.isBetterThan(best)) return limit;
                        best = candidate;
                        return limitOf(best.match.distance);
                    });
        if (best.match.position.road < 0) return std::nullopt;
        return best.match;
    }

    const RoadNetwork& network;
    std::vector<RoadPiece> pieces;
    BoxTree tree;
};

RoadLocator::RoadLocator(const RoadNetwork& network) : _index(std::make_unique<const Index>(network)) {}
RoadLocator::~RoadLocator() = default;
RoadLocator::RoadLocator(RoadLocator&&) noexcept = default;
RoadLocator& RoadLocator::operator=(RoadLocator&&) noexcept = default;

std::optional<RoadMatch> RoadLocator::nearest(glm::dvec2 point, double withinM) const
{
    return _index->nearest(point, kNoHeight, withinM);
}

std::optional<RoadMatch> RoadLocator::nearest(const glm::dvec3& point, double withinM) const
{
    return _index->nearest(glm::dvec2(point), point.z, withinM);
}

bool RoadLocator::holdsOnOther(glm::dvec2 point, double withinM, int road,
                               const std::function<bool(const RoadMatch&)>& holds) const
{
    constexpr double kStop = -1.0; // no box is nearer
    bool isFound = false;
    _index->tree.search(
        point, limitOf(withinM),
        [&](std::uint32_t item, double limit)
        {
            const RoadPiece& piece = _index->pieces[item];
            if (isFound || static_cast<int>(piece.road) == road || piece.squareTo(point) > limit)
                return limit;
            const RoadMatch match = candidateOn(_index->network, piece, point, kNoHeight).match;
            isFound = match.distance <= withinM + kSameDistanceM && holds(match);
            return isFound ? kStop : limit;
        });
    return isFound;
}

std::vector<RoadMatch> RoadLocator::within(glm::dvec2 point, double withinM) const
{
    std::vector<RoadCandidate> found;
    _index->tree.search(point, limitOf(withinM),
                        [&](std::uint32_t item, double limit)
                        {
                            const RoadPiece& piece = _index->pieces[item];
                            const double square = piece.squareTo(point);
                            if (square > limit) return limit;
                            const auto same = std::find_if(
                                found.begin(), found.end(),
                                [&](const RoadCandidate& other)
                                { return other.match.position.road == static_cast<int>(piece.road); });
                            // Most pieces nearby belong to a road of which a nearer piece is known.
                            if (same != found.end() && square > limitOf(same->match.distance)) return limit;
                            const RoadCandidate candidate =
                                candidateOn(_index->network, piece, point, kNoHeight);
                            if (candidate.match.distance > withinM + kSameDistanceM) return limit;
                            if (same == found.end())
                                found.push_back(candidate);
                            else if (candidate.isBetterThan(*same))
                                *same = candidate;
                            return limit;
                        });
    std::sort(found.begin(), found.end(),
              [](const RoadCandidate& a, const RoadCandidate& b)
              {
                  return std::tie(a.match.distance, a.lateral, a.match.position.road) <
                         std::tie(b.match.distance, b.lateral, b.match.position.road);
              });
    std::vector<RoadMatch> matches;
    for (const RoadCandidate& candidate : found)
        matches.push_back(candidate.match);
    return matches;
}

} // namespace osgRoads::core
