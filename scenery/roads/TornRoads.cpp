// SPDX-License-Identifier: Apache-2.0
#include "scenery/roads/TornRoads.h"

#include <algorithm>
#include <cmath>

#include <osgRoads/core/check/NetworkCheck.h>
#include <osgRoads/core/read/Problem.h>

namespace scenery
{

namespace
{

constexpr double kRunPerRise = 0.75; ///< of a stretch, on either side: a slope of 1 to 1.5
constexpr double kShareOfRoad =
    0.8; ///< of the way to the nearer end: beyond it the ground knows the road's height

} // namespace

TornRoads::TornRoads(const osgRoads::core::RoadNetwork& network) : _ofRoads(network.roads.size())
{
    for (std::size_t i = 0; i < network.roads.size(); ++i)
    {
        const osgRoads::core::Road& road = network.roads[i];
        if (!road.isUsable) continue;
        for (const auto& step : osgRoads::core::elevationSteps(road, kStepM))
        {
            const double room = kShareOfRoad * std::min(step.s, road.length - step.s);
            _ofRoads[i].push_back({step.s, step.size, std::min({kRunPerRise * step.size, kFarthestM, room})});
        }
    }
}

bool TornRoads::at(int road, double s) const
{
    const std::vector<Stretch>& stretches = _ofRoads[static_cast<std::size_t>(road)];
    return std::any_of(stretches.begin(), stretches.end(),
                       [s](const Stretch& stretch) { return std::fabs(s - stretch.s) <= stretch.halfM; });
}

std::vector<std::string> TornRoads::notes(const osgRoads::core::RoadNetwork& network,
                                          const std::string& file) const
{
    using osgRoads::core::shortNumber;
    std::vector<osgRoads::core::Problem> problems;
    for (std::size_t i = 0; i < _ofRoads.size(); ++i)
        for (const Stretch& stretch : _ofRoads[i])
        {
            osgRoads::core::Problem problem;
            problem.line = network.roads[i].line;
            problem.what = "road " + network.roads[i].id + " at s " + shortNumber(stretch.s) +
                           ": the elevation jumps by " + shortNumber(stretch.size) +
                           " m, the ground is left as it is for " + shortNumber(std::round(stretch.halfM)) +
                           " m on either side";
            problem.remedy = "let its pieces meet";
            problems.push_back(problem);
        }
    return osgRoads::core::firstMessages(problems, file);
}

} // namespace scenery
