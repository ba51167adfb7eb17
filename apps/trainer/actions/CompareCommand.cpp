// SPDX-License-Identifier: Apache-2.0
#include "CompareCommand.h"

#include <algorithm>
#include <cstdio>
#include <utility>

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

void print(const char* what, const char* unit, const simulation::PlaceSpread& spread)
{
    std::printf("  %s %+.3f %s at %.1f m (rms %.3f)", what, spread.largest, unit, spread.largestAtM,
                spread.rms);
}

void print(const simulation::PlaceDifference& place)
{
    std::printf("%-24s by place: %.1f of %.1f m of the way of the reference", place.entity.c_str(),
                place.coveredM, place.wayM);
    if (place.places > 0)
    {
        print("beside", "m", place.besideM);
        print("height", "m", place.heightM);
        print("speed", "m/s", place.speedMps);
        if (place.bankDeg) print("bank", "deg", *place.bankDeg);
        print("time", "s", place.timeS);
    }
    if (place.beyondRows > 0) std::printf("  %zu rows beyond its ends", place.beyondRows);
    std::printf("\n");
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

/// Errors: nothing in one table can be compared with the other.
foundation::Outcome checkComparable(const CompareRequest& request, const simulation::MotionTable& table,
                                    const simulation::MotionTable& reference)
{
    for (const auto& [read, file] :
         {std::pair(&table, &request.table), std::pair(&reference, &request.reference)})
        if (read->tracks.empty())
            return foundation::Error{file->string(), "no row has an entity", "give the table of a run"};
    if (std::none_of(reference.tracks.begin(), reference.tracks.end(),
                     [&](const auto& track) { return table.find(track.entity); }))
        return foundation::Error{request.table.string(),
                                 "none of the entities of " + request.reference.string() + " is in it (" +
                                     table.tracks.front().entity + " is, " + reference.tracks.front().entity +
                                     " is there)",
                                 "compare runs of the same entities"};
    return foundation::success();
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
    const auto places = simulation::comparePlaces(*table, *reference);
    if (const auto comparable = checkComparable(request, *table, *reference); !comparable) return comparable;
    for (std::size_t i = 0; i < differences.size(); ++i)
    {
        print(differences[i], request.limits);
        print(events[i]);
    }
    for (const simulation::PlaceDifference& place : places)
        print(place);
    if (!request.jsonFile.empty())
    {
        const std::string text = simulation::differencesText(differences, events, places, request.limits);
        if (const auto written = foundation::writeWholeFile(request.jsonFile, text); !written) return written;
    }
    if (!request.failsBeyond) return foundation::success();
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
