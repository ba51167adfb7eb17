// SPDX-License-Identifier: Apache-2.0
#include "CompareCommand.h"

#include <algorithm>
#include <cstdio>

#include <foundation/WholeFile.h>

namespace trainer
{
namespace
{

void print(const simulation::MotionDifference& difference, const simulation::MotionLimits& limits)
{
    std::printf("%-24s rows %6zu  position %9.4f m at %7.2f s (rms %9.4f)  heading %8.4f deg at %7.2f s (rms "
                "%8.4f)%s%s\n",
                difference.entity.c_str(), difference.rows, difference.positionM.largest,
                difference.positionM.largestAtS, difference.positionM.rms, difference.headingDeg.largest,
                difference.headingDeg.largestAtS, difference.headingDeg.rms,
                difference.unmatchedRows > 0 ? "  rows are missing" : "",
                simulation::isWithin(difference, limits) ? "" : "  beyond the limits");
}

void print(const char* kind, const simulation::EventMatch& match)
{
    if (match.count + match.unmatched > 0)
        std::printf("  %s %zu, unmatched %zu, at most %.2f s apart", kind, match.count, match.unmatched,
                    match.largestS);
}

void print(const simulation::EventDifference& events)
{
    if (events.laneChanges.count + events.laneChanges.unmatched + events.collisions.count +
            events.collisions.unmatched + events.speedKinks.count + events.speedKinks.unmatched ==
        0)
        return;
    std::printf("%-24s", "");
    print("lane changes", events.laneChanges);
    print("collisions", events.collisions);
    print("kinks of speed", events.speedKinks);
    std::printf("\n");
}

} // namespace

foundation::Outcome compare(const CompareRequest& request)
{
    if (const auto writable = foundation::checkWritable(request.jsonFile); !writable) return writable;
    const auto table = simulation::readMotionTable(request.table);
    if (!table) return table.error();
    const auto reference = simulation::readMotionTable(request.reference);
    if (!reference) return reference.error();
    const auto differences = simulation::compareMotions(*table, *reference);
    const auto events = simulation::compareEvents(*table, *reference);
    for (std::size_t i = 0; i < differences.size(); ++i)
    {
        print(differences[i], request.limits);
        print(events[i]);
    }
    if (!request.jsonFile.empty())
    {
        const std::string text = simulation::differencesText(differences, events, request.limits);
        if (const auto written = foundation::writeWholeFile(request.jsonFile, text); !written) return written;
    }
    const auto beyond = std::count_if(differences.begin(), differences.end(),
                                      [&](const auto& difference)
                                      { return !simulation::isWithin(difference, request.limits); });
    if (beyond == 0) return foundation::success();
    return foundation::Error{request.table.string(),
                             std::to_string(beyond) + " of " + std::to_string(differences.size()) +
                                 " entities differ from " + request.reference.string(),
                             "see the lines above, or allow more with --position and --heading"};
}

} // namespace trainer
