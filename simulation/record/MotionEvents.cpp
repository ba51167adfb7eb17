// SPDX-License-Identifier: Apache-2.0
#include "simulation/record/MotionEvents.h"

#include <algorithm>
#include <cmath>

namespace simulation
{
namespace
{

constexpr double kFarthestS = 0.5;
constexpr double kKinkMps2 = 1.0;
constexpr double kSameRowS = 1e-6;

/// An event and what it leads to: the lane, or nothing.
struct MotionEvent
{
    double timeS = 0.0;
    int value = 0;
};

/// The samples of an entity at the rows of the reference.
struct SeenTrack
{
    std::vector<double> timeS;
    std::vector<MotionSample> samples;
};

SeenTrack seenAt(const MotionTable& table, const MotionTrack* track, const std::vector<double>& times)
{
    SeenTrack seen;
    std::size_t row = 0;
    for (const double timeS : times)
    {
        while (row < table.timeS.size() && table.timeS[row] < timeS - kSameRowS)
            ++row;
        if (!track || row >= table.timeS.size() || table.timeS[row] > timeS + kSameRowS) continue;
        if (!track->samples[row]) continue;
        seen.timeS.push_back(timeS);
        seen.samples.push_back(*track->samples[row]);
    }
    return seen;
}

std::vector<MotionEvent> laneChanges(const SeenTrack& seen)
{
    std::vector<MotionEvent> events;
    for (std::size_t i = 1; i < seen.samples.size(); ++i)
        if (seen.samples[i].lane != seen.samples[i - 1].lane)
            events.push_back({seen.timeS[i], seen.samples[i].lane});
    return events;
}

std::vector<MotionEvent> collisions(const SeenTrack& seen)
{
    std::vector<MotionEvent> events;
    for (std::size_t i = 0; i < seen.samples.size(); ++i)
        if (seen.samples[i].collides && (i == 0 || !seen.samples[i - 1].collides))
            events.push_back({seen.timeS[i], 0});
    return events;
}

/// The rows at which the change of acceleration is above the bound, and as great as at the rows beside them
/// at least.
std::vector<MotionEvent> speedKinks(const SeenTrack& seen)
{
    std::vector<double> jumps(seen.samples.size(), 0.0);
    for (std::size_t i = 1; i + 1 < seen.samples.size(); ++i)
    {
        const double before = seen.timeS[i] - seen.timeS[i - 1], after = seen.timeS[i + 1] - seen.timeS[i];
        if (before <= 0.0 || after <= 0.0) continue;
        jumps[i] = std::fabs((seen.samples[i + 1].speedMps - seen.samples[i].speedMps) / after -
                             (seen.samples[i].speedMps - seen.samples[i - 1].speedMps) / before);
    }
    std::vector<MotionEvent> events;
    for (std::size_t i = 1; i + 1 < jumps.size(); ++i)
        if (jumps[i] > kKinkMps2 && jumps[i] > jumps[i - 1] && jumps[i] >= jumps[i + 1])
            events.push_back({seen.timeS[i], 0});
    return events;
}

/// Takes for each event of one table the nearest one of the other that leads to the same.
EventMatch matched(const std::vector<MotionEvent>& events, const std::vector<MotionEvent>& reference)
{
    EventMatch match;
    match.count = reference.size();
    std::vector<bool> taken(events.size(), false);
    for (const MotionEvent& wanted : reference)
    {
        std::size_t best = events.size();
        for (std::size_t i = 0; i < events.size(); ++i)
        {
            const double apart = std::fabs(events[i].timeS - wanted.timeS);
            if (taken[i] || events[i].value != wanted.value || apart > kFarthestS) continue;
            if (best == events.size() || apart < std::fabs(events[best].timeS - wanted.timeS)) best = i;
        }
        if (best == events.size())
        {
            ++match.unmatched;
            continue;
        }
        taken[best] = true;
        match.largestS = std::max(match.largestS, std::fabs(events[best].timeS - wanted.timeS));
    }
    match.unmatched += static_cast<std::size_t>(std::count(taken.begin(), taken.end(), false));
    return match;
}

bool isWithin(const EventMatch& match, double mostS)
{
    return match.unmatched == 0 && match.largestS <= mostS;
}

} // namespace

std::vector<EventDifference> compareEvents(const MotionTable& table, const MotionTable& reference)
{
    std::vector<EventDifference> differences;
    for (const MotionTrack& expected : reference.tracks)
    {
        const SeenTrack wanted = seenAt(reference, &expected, reference.timeS);
        const SeenTrack seen = seenAt(table, table.find(expected.entity), reference.timeS);
        differences.push_back({expected.entity, matched(laneChanges(seen), laneChanges(wanted)),
                               matched(collisions(seen), collisions(wanted)),
                               matched(speedKinks(seen), speedKinks(wanted))});
    }
    return differences;
}

bool isWithin(const EventDifference& difference, double mostS)
{
    return isWithin(difference.laneChanges, mostS) && isWithin(difference.collisions, mostS) &&
           isWithin(difference.speedKinks, mostS);
}

} // namespace simulation
