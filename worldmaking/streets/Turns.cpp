// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/streets/Turns.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <foundation/Angle.h>

namespace worldmaking
{

namespace
{

constexpr double kTurnRad = foundation::radiansOf(45.0);

/// An arm that traffic may leave by, and by how much it turns to the left.
struct Exit
{
    std::size_t arm = 0;
    double turnRad = 0.0;
};

std::vector<Exit> exitsOf(const std::vector<ArmLanes>& arms, std::size_t from,
                          const std::vector<char>& isAllowed)
{
    std::vector<Exit> exits;
    for (std::size_t to = 0; to < arms.size(); ++to)
        if (to != from && arms[to].out > 0 && isAllowed[from * arms.size() + to] != 0)
            exits.push_back(
                {to, foundation::wrappedRad(arms[to].headingRad - arms[from].headingRad - std::numbers::pi)});
    return exits;
}

void addStraight(std::vector<Turn>& turns, std::size_t from, int in, const Exit& exit, int out)
{
    for (int lane = 0; lane < std::max(in, out); ++lane)
        turns.push_back({from, exit.arm, std::min(lane, in - 1), std::min(lane, out - 1)});
}

/// Gives lanes that lead nowhere the exit that asks for the least turn.
void addMissing(std::vector<Turn>& turns, std::size_t from, int in, const std::vector<Exit>& exits,
                const std::vector<ArmLanes>& arms)
{
    const auto straightest = std::min_element(exits.begin(), exits.end(),
                                              [](const Exit& a, const Exit& b)
                                              { return std::fabs(a.turnRad) < std::fabs(b.turnRad); });
    for (int lane = 0; lane < in; ++lane)
    {
        const bool leads =
            std::any_of(turns.begin(), turns.end(),
                        [&](const Turn& turn) { return turn.fromArm == from && turn.fromLane == lane; });
        if (!leads)
            turns.push_back({from, straightest->arm, lane, std::min(lane, arms[straightest->arm].out - 1)});
    }
}

} // namespace

std::vector<Turn> turnsOf(const std::vector<ArmLanes>& arms, const std::vector<char>& isAllowed)
{
    std::vector<Turn> turns;
    for (std::size_t from = 0; from < arms.size(); ++from)
    {
        const int in = arms[from].in;
        const std::vector<Exit> exits = exitsOf(arms, from, isAllowed);
        if (in == 0 || exits.empty()) continue;
        for (const Exit& exit : exits)
        {
            const int out = arms[exit.arm].out;
            if (exits.size() == 1 || std::fabs(exit.turnRad) <= kTurnRad)
                addStraight(turns, from, in, exit, out);
            else if (exit.turnRad > 0.0)
                turns.push_back({from, exit.arm, 0, 0});
            else
                turns.push_back({from, exit.arm, in - 1, out - 1});
        }
        addMissing(turns, from, in, exits, arms);
    }
    return turns;
}

} // namespace worldmaking
