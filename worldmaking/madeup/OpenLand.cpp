// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/madeup/OpenLand.h"

#include <algorithm>
#include <cmath>

#include "worldmaking/madeup/Contours.h"
#include "worldmaking/plan/Noise.h"

namespace worldmaking
{

namespace
{

constexpr double kGrassAboveTreesM = 100.0;
constexpr double kBroadM = 1700.0, kFrayedM = 320.0;          ///< sizes of the noise
constexpr double kBroadClimbM = 420.0, kFrayedClimbM = 260.0; ///< for noise from 0 to 1
constexpr double kHollowM = 90.0, kHollowClimb = 4.0;         ///< how far hollows look; metres a metre
constexpr double kHollowMostM = 170.0, kSouthClimbM = 110.0;
constexpr double kGentle = 0.45, kSteepFallM = 420.0; ///< a slope of 1 more costs so many metres
constexpr double kRockSlope = 0.78, kRockNoise = 0.42, kRockHeightM = 900.0;
constexpr double kLeastGrassM2 = 3e4, kLeastRockM2 = 6e3;
constexpr float kNeither = -1e4F;

/// What the lie of a point says of grass and rock: metres below the line of grass, and slope above what rock
/// begins at.
struct LieOfLand
{
    double belowLineM = 0.0, rocky = 0.0;
};

class OpenLandRule
{
public:
    OpenLandRule(const GroundGrid& ground, double treeLineM, std::uint64_t seed)
        : _ground(ground), _treeLineM(treeLineM), _seed(seed)
    {
    }

    LieOfLand at(int column, int row) const
    {
        const glm::dvec2 place = _ground.placeOf(column, row);
        const double height = _ground.heightAt(column, row);
        const glm::dvec2 gradient = _ground.gradient(place);
        const double slope = glm::length(gradient);
        const double broad = roughNoiseAt(place, kBroadM, seedFor(_seed, 81)) - 0.5,
                     frayed = roughNoiseAt(place, kFrayedM, seedFor(_seed, 82)) - 0.5;
        const double hollow =
            std::clamp(kHollowClimb * hollowM(column, row, height), -kHollowMostM, kHollowMostM);
        const double southness = std::clamp(gradient.y / std::max(slope, 0.2), -1.0, 1.0);
        const double line = _treeLineM + kGrassAboveTreesM + kBroadClimbM * broad + kFrayedClimbM * frayed +
                            hollow + kSouthClimbM * southness - kSteepFallM * std::max(slope - kGentle, 0.0);
        const double high = std::clamp((height - _treeLineM) / kRockHeightM, -0.25, 0.4);
        return {line - height,
                slope - kRockSlope + kRockNoise * (frayed + 0.5 * broad) + high - 0.001 * hollow};
    }

private:
    /// How much lower a point lies than those around it, metres.
    double hollowM(int column, int row, double height) const
    {
        const int reach = std::max(1, static_cast<int>(std::lround(kHollowM / _ground.cellM())));
        double sum = 0.0;
        int count = 0;
        for (const int y : {row - reach, row, row + reach})
            for (const int x : {column - reach, column, column + reach})
                if (x >= 0 && y >= 0 && x < _ground.columns() && y < _ground.rows() &&
                    _ground.hasGround(x, y))
                {
                    sum += _ground.heightAt(x, y);
                    ++count;
                }
        return count > 0 ? sum / count - height : 0.0;
    }

    const GroundGrid& _ground;
    double _treeLineM;
    std::uint64_t _seed;
};

} // namespace

OpenLand openLandOn(const GroundGrid& ground, double treeLineM, std::uint64_t seed)
{
    const OpenLandRule rule(ground, treeLineM, seed);
    std::vector<float> grass(ground.size(), kNeither), rock(ground.size(), kNeither);
    for (int row = 0; row < ground.rows(); ++row)
        for (int column = 0; column < ground.columns(); ++column)
        {
            const double height = ground.hasGround(column, row) ? ground.heightAt(column, row) : -1.0;
            if (!ground.hasGround(column, row) || (ground.hasSea() && height <= GroundGrid::kShoreM))
                continue;
            const LieOfLand lie = rule.at(column, row);
            const std::size_t at = ground.index(column, row);
            // Rock is cut out of grass: one step between them, whatever is painted later.
            grass[at] = static_cast<float>(std::min(lie.belowLineM, -600.0 * lie.rocky));
            rock[at] = static_cast<float>(lie.rocky);
        }
    const double cell = ground.cellM();
    const MapBox box{ground.box().low - 0.5 * cell, ground.box().high + 0.5 * cell};
    for (float& value : grass) // just below 0 at sea: the outline goes as far as it can
        value = value == kNeither ? -1e-3F : std::clamp(value, -60.0F, 60.0F) / 60.0F;
    for (float& value : rock)
        value = value == kNeither ? -1.0F : std::clamp(value, -0.5F, 0.5F);
    return {areasAbove(grass, ground.columns(), box, cell, 0.0, kLeastGrassM2),
            areasAbove(rock, ground.columns(), box, cell, 0.0, kLeastRockM2)};
}

} // namespace worldmaking
