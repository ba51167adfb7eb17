// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>
#include <utility>

#include <osgTerrainROAM/core/roam/ErrorTree.h>
#include <osgTerrainROAM/core/vdpm/BoundedForest.h>

#include "../RoundedUp.h"

namespace osgTerrainROAM::core
{

namespace
{

/// How far a split of 1 m error is wanted: finders are chosen for a tolerance of about a pixel and a half in
/// a picture of 1280 × 1024.
constexpr double kTypicalReach = 1000.0;

/// How much a small finder counts beside one that need not grow. With 0 a few coarse splits find dozens of
/// others, which then are all watched: up to five times the checks; with 0.1 there are 3 to 4 % more
/// triangles.
constexpr double kSmallness = 0.01;

/// The least bound that contains two.
SplitBound joined(const SplitBound& outer, const SplitBound& inner)
{
    SplitBound both = outer;
    both.errorM = std::max(outer.errorM, inner.errorM);
    const glm::dvec3 from(outer.centre), to(inner.centre);
    const double distance = glm::distance(from, to);
    if (distance + inner.radiusM * ErrorTree::kRadiusSlack <= outer.radiusM) return both;
    if (distance + outer.radiusM <= inner.radiusM)
        both.centre = inner.centre;
    else if (distance + inner.radiusM >
             outer.radiusM) // else the slack alone makes it larger, about the same centre
        both.centre =
            glm::vec3(from + (to - from) * ((distance + inner.radiusM - outer.radiusM) / (2.0 * distance)));
    const glm::dvec3 centre(both.centre); // the rounding of the centre counts
    both.radiusM = roundedUp(
        std::max(glm::distance(centre, from) + outer.radiusM, glm::distance(centre, to) + inner.radiusM) *
        ErrorTree::kRadiusSlack);
    return both;
}

double reachOf(const SplitBound& bound)
{
    return kTypicalReach * bound.errorM + bound.radiusM;
}

/// Sorts splits by their finder.
void listFound(BoundedForest& forest)
{
    const std::uint32_t count = forest.forest.splitCount();
    forest.firstFound.assign(count + 1, 0);
    for (const std::uint32_t finder : forest.finder)
        if (finder != kNone) ++forest.firstFound[finder + 1];
    for (std::uint32_t w = 0; w < count; ++w)
        forest.firstFound[w + 1] += forest.firstFound[w];
    forest.found.resize(forest.firstFound[count]);
    std::vector<std::uint32_t> next(forest.firstFound.begin(), forest.firstFound.end());
    for (std::uint32_t w = 0; w < count; ++w)
        if (const std::uint32_t finder = forest.finder[w]; finder != kNone)
            forest.found[next[finder]++] = w;
        else
            forest.unfound.push_back(w);
}

} // namespace

BoundedForest nestBounds(VertexForest forest, std::vector<glm::dvec3> positions,
                         std::vector<SplitBound> bounds, std::vector<NormalCone> cones)
{
    BoundedForest result{
        std::move(forest), std::move(positions), std::move(bounds), std::move(cones), {}, {}, {}, {}};
    const std::uint32_t count = result.forest.splitCount();
    result.finder.assign(count, kNone);
    for (std::uint32_t w = count; w-- > 0;)
    {
        double least = std::numeric_limits<double>::infinity();
        SplitBound grown;
        for (const std::uint32_t needed : result.forest.dependenciesOf(w))
        {
            const SplitBound both = joined(result.bounds[needed], result.bounds[w]);
            const double cost = reachOf(both) * (1.0 + kSmallness) - reachOf(result.bounds[needed]);
            if (cost >= least) continue;
            least = cost;
            grown = both;
            result.finder[w] = needed;
        }
        const std::uint32_t finder = result.finder[w];
        if (finder == kNone) continue;
        result.bounds[finder] = grown;
        if (!result.cones.empty()) result.cones[finder] = result.cones[finder].joined(result.cones[w]);
    }
    listFound(result);
    return result;
}

bool areBoundsNested(const BoundedForest& forest)
{
    for (std::uint32_t w = 0; w < forest.forest.splitCount(); ++w)
    {
        if (forest.finder[w] == kNone) continue;
        const SplitBound &outer = forest.bounds[forest.finder[w]], &inner = forest.bounds[w];
        const double distance = glm::distance(glm::dvec3(outer.centre), glm::dvec3(inner.centre));
        if (!(outer.errorM >= inner.errorM && distance + inner.radiusM <= outer.radiusM))
            return false; // or no number
        if (!forest.cones.empty() && !forest.cones[forest.finder[w]].contains(forest.cones[w])) return false;
    }
    return true;
}

} // namespace osgTerrainROAM::core
