// SPDX-License-Identifier: Apache-2.0
#include "simulation/record/CompareMotions.h"

#include <algorithm>
#include <cmath>

#include <foundation/Angle.h>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

namespace simulation
{
namespace
{

constexpr double kSameTimeS = 1e-6;

/// Collects the differences of one quantity.
class SpreadSum
{
public:
    void add(double difference, double timeS)
    {
        const double size = std::fabs(difference);
        if (_count == 0 || size > _spread.largest)
        {
            _spread.largest = size;
            _spread.largestAtS = timeS;
        }
        _squares += size * size;
        ++_count;
    }

    Spread result() const
    {
        Spread spread = _spread;
        if (_count > 0) spread.rms = std::sqrt(_squares / static_cast<double>(_count));
        return spread;
    }

private:
    Spread _spread;
    double _squares = 0.0;
    std::size_t _count = 0;
};

const MotionSample* sampleAt(const MotionTable& table, const MotionTrack& track, double timeS)
{
    const auto found = std::lower_bound(table.timeS.begin(), table.timeS.end(), timeS - kSameTimeS);
    if (found == table.timeS.end() || *found > timeS + kSameTimeS) return nullptr;
    const auto& sample = track.samples[static_cast<std::size_t>(found - table.timeS.begin())];
    return sample ? &*sample : nullptr;
}

MotionDifference differenceOf(const MotionTable& table, const MotionTable& reference,
                              const MotionTrack& expected)
{
    MotionDifference difference;
    difference.entity = expected.entity;
    const MotionTrack* const track = table.find(expected.entity);
    SpreadSum position;
    SpreadSum heading;
    SpreadSum speed;
    for (std::size_t row = 0; row < reference.timeS.size(); ++row)
    {
        if (!expected.samples[row]) continue;
        const double timeS = reference.timeS[row];
        const MotionSample* const sample = track ? sampleAt(table, *track, timeS) : nullptr;
        if (!sample)
        {
            ++difference.unmatchedRows;
            continue;
        }
        ++difference.rows;
        const MotionSample& wanted = *expected.samples[row];
        position.add(glm::distance(sample->position, wanted.position), timeS);
        heading.add(foundation::wrappedDeg(foundation::degreesOf(sample->headingRad - wanted.headingRad)),
                    timeS);
        speed.add(sample->speedMps - wanted.speedMps, timeS);
    }
    difference.positionM = position.result();
    difference.headingDeg = heading.result();
    difference.speedMps = speed.result();
    return difference;
}

nlohmann::ordered_json jsonOf(const Spread& spread)
{
    return {{"largest", spread.largest}, {"at_s", spread.largestAtS}, {"rms", spread.rms}};
}

nlohmann::ordered_json jsonOf(const PlaceSpread& spread)
{
    return {{"largest", spread.largest}, {"at_m", spread.largestAtM}, {"rms", spread.rms}};
}

nlohmann::ordered_json jsonOf(const PlaceDifference& place)
{
    nlohmann::ordered_json text = {{"way_m", place.wayM},
                                   {"covered_m", place.coveredM},
                                   {"places", place.places},
                                   {"beyond_rows", place.beyondRows},
                                   {"beside_m", jsonOf(place.besideM)},
                                   {"height_m", jsonOf(place.heightM)},
                                   {"speed_mps", jsonOf(place.speedMps)},
                                   {"bank_deg", nullptr},
                                   {"time_s", jsonOf(place.timeS)}};
    if (place.bankDeg) text["bank_deg"] = jsonOf(*place.bankDeg);
    return text;
}

nlohmann::ordered_json jsonOf(const EventMatch& match)
{
    return {{"count", match.count}, {"unmatched", match.unmatched}, {"largest_s", match.largestS}};
}

} // namespace

std::vector<MotionDifference> compareMotions(const MotionTable& table, const MotionTable& reference)
{
    std::vector<MotionDifference> differences;
    for (const MotionTrack& expected : reference.tracks)
        differences.push_back(differenceOf(table, reference, expected));
    return differences;
}

bool isWithin(const MotionDifference& difference, const MotionLimits& limits)
{
    return difference.unmatchedRows == 0 && difference.positionM.largest <= limits.positionM &&
           difference.headingDeg.largest <= limits.headingDeg;
}

std::string differencesText(const std::vector<MotionDifference>& differences,
                            const std::vector<EventDifference>& events,
                            const std::vector<PlaceDifference>& places, const MotionLimits& limits)
{
    nlohmann::ordered_json entities = nlohmann::ordered_json::array();
    bool within = true;
    for (std::size_t i = 0; i < differences.size(); ++i)
    {
        const MotionDifference& difference = differences[i];
        within = within && isWithin(difference, limits);
        entities.push_back({{"entity", difference.entity},
                            {"rows", difference.rows},
                            {"unmatched_rows", difference.unmatchedRows},
                            {"position_m", jsonOf(difference.positionM)},
                            {"heading_deg", jsonOf(difference.headingDeg)},
                            {"speed_mps", jsonOf(difference.speedMps)},
                            {"within", isWithin(difference, limits)}});
        for (const PlaceDifference& place : places)
            if (place.entity == difference.entity) entities.back()["by_place"] = jsonOf(place);
        if (i >= events.size()) continue;
        entities.back()["lane_changes"] = jsonOf(events[i].laneChanges);
        entities.back()["collisions"] = jsonOf(events[i].collisions);
        entities.back()["speed_kinks"] = jsonOf(events[i].speedKinks);
    }
    const nlohmann::ordered_json text = {
        {"limits", {{"position_m", limits.positionM}, {"heading_deg", limits.headingDeg}}},
        {"entities", entities},
        {"within", within}};
    return text.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

} // namespace simulation
