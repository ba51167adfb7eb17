// SPDX-License-Identifier: Apache-2.0
#include "simulation/tour/Sights.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <foundation/Earth.h>

namespace simulation
{
namespace
{

constexpr double kBlockM = 125.0; ///< houses of neighbouring blocks belong together
constexpr double kLargestWeight = 1.3, kWeightOfFold = 0.25;
constexpr double kShoreWeight = 0.15, kShoreRadiusM = 500.0;
constexpr int kShoreCells = 128; ///< along the longer side
constexpr double kAtSeaM = 0.15, kLandM = 0.2;

using Block = std::pair<int, int>;
using Blocks = std::map<Block, std::vector<glm::dvec2>>;

/// Takes a block, and all that are joined to it, out of the map.
std::vector<glm::dvec2> takeGroup(Blocks& blocks)
{
    std::vector<glm::dvec2> group;
    std::vector<Block> open{blocks.begin()->first};
    while (!open.empty())
    {
        const Block at = open.back();
        open.pop_back();
        auto found = blocks.extract(at);
        if (found.empty()) continue;
        group.insert(group.end(), found.mapped().begin(), found.mapped().end());
        for (int east = -1; east <= 1; ++east)
            for (int north = -1; north <= 1; ++north)
                open.emplace_back(at.first + east, at.second + north);
    }
    return group;
}

Sight settlementOf(const std::vector<glm::dvec2>& houses)
{
    const auto count = static_cast<double>(houses.size());
    glm::dvec2 middle(0.0);
    for (const glm::dvec2& house : houses)
        middle += house / count;
    double spread = 0.0;
    for (const glm::dvec2& house : houses)
        spread += glm::dot(house - middle, house - middle) / count;
    return {middle, std::max(80.0, 1.4 * std::sqrt(spread)),
            std::min(kLargestWeight, kWeightOfFold * std::log(count / 3.5))};
}

} // namespace

std::vector<Sight> settlementSights(std::span<const glm::dvec2> houses)
{
    Blocks blocks;
    for (const glm::dvec2& house : houses)
        blocks[{static_cast<int>(std::floor(house.x / kBlockM)),
                static_cast<int>(std::floor(house.y / kBlockM))}]
            .push_back(house);
    std::vector<Sight> sights;
    while (!blocks.empty())
        if (const std::vector<glm::dvec2> group = takeGroup(blocks); group.size() >= kLeastHouses)
            sights.push_back(settlementOf(group));
    std::stable_sort(sights.begin(), sights.end(),
                     [](const Sight& a, const Sight& b) { return a.weight > b.weight; });
    return sights;
}

std::vector<Sight> shoreSights(const TourTerrain& terrain, double seaLevelM)
{
    const double cellM = std::max(terrain.widthM(), terrain.depthM()) / kShoreCells;
    const auto columns = static_cast<int>(terrain.widthM() / cellM);
    const auto rows = static_cast<int>(terrain.depthM() / cellM);
    const auto place = [&](int column, int row)
    { return glm::dvec2(terrain.westM, terrain.southM) + cellM * glm::dvec2(column + 0.5, row + 0.5); };
    const auto aboveSeaM = [&](int column, int row)
    {
        const glm::dvec2 at = place(column, row);
        const double bend = terrain.origin ? glm::dot(at, at) / (2.0 * foundation::kEarthRadiusM) : 0.0;
        return terrain.heightM(at.x, at.y) + bend - seaLevelM;
    };
    std::vector<Sight> sights;
    for (int row = 1; row + 1 < rows; ++row)
        for (int column = 1; column + 1 < columns; ++column)
        {
            const glm::dvec2 at = place(column, row);
            if (std::fabs(aboveSeaM(column, row)) > kAtSeaM) continue;
            const bool isAtLand = std::max({aboveSeaM(column - 1, row), aboveSeaM(column + 1, row),
                                            aboveSeaM(column, row - 1), aboveSeaM(column, row + 1)}) > kLandM;
            const bool isNear = std::any_of(sights.begin(), sights.end(),
                                            [&](const Sight& other)
                                            { return glm::distance(other.place, at) < kShoreEveryM; });
            if (isAtLand && !isNear) sights.push_back({at, kShoreRadiusM, kShoreWeight});
        }
    return sights;
}

} // namespace simulation
