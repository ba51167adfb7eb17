// SPDX-License-Identifier: Apache-2.0
#include "PlaySeats.h"

#include <algorithm>
#include <cstdio>

#include <foundation/WholeFile.h>

namespace trainer
{

namespace
{

/// The entity that a seat is in; empty: none.
std::string entityFor(const simulation::Scenario& scenario, const SeatRequest& asked,
                      const std::string& watched)
{
    if (!asked.entity.empty()) return asked.entity;
    if (const auto manual = simulation::manualEntity(scenario)) return scenario.entities[*manual].name;
    return watched;
}

} // namespace

foundation::Result<std::optional<SeatRequest>> seatFor(const simulation::Scenario& scenario,
                                                       const SeatRequest& asked, const std::string& watched)
{
    SeatRequest seat = asked;
    seat.entity = entityFor(scenario, asked, watched);
    if (seat.entity.empty())
    {
        if (asked.inputs.empty() && asked.recordInputs.empty()) return std::optional<SeatRequest>();
        return foundation::Error{asked.inputs.empty() ? "--record-inputs" : "--inputs",
                                 "the scenario gives no entity to a person", "add --drive ENTITY"};
    }
    const auto entity = simulation::seatIn(scenario, seat.entity);
    if (!entity)
    {
        // Somebody looks at a pedestrian: then nobody sits there.
        if (asked.entity.empty() && asked.inputs.empty() && asked.recordInputs.empty())
            return std::optional<SeatRequest>();
        return entity.error();
    }
    const auto usable = simulation::PersonSeat::create(
        {seat.entity, seat.isTakenAtStart, seat.vehicle, seat.inputs, false, 0}, scenario.entities[*entity],
        {nullptr, std::nullopt});
    if (!usable) return usable.error();
    return std::optional<SeatRequest>(std::move(seat));
}

foundation::Outcome checkHands(const SeatRequest& seat, bool hasWindow)
{
    if (hasWindow || seat.entity.empty() || !seat.inputs.empty()) return foundation::success();
    return foundation::Error{"--drive", "nobody can drive without a window",
                             "add --window, or --inputs FILE with what somebody did"};
}

foundation::Outcome tellInputs(const std::filesystem::path& file)
{
    if (file.empty()) return foundation::success();
    const auto track = simulation::readInputs(file);
    if (!track) return track.error();
    const auto has = [&](std::string_view name)
    { return std::find(track->names.begin(), track->names.end(), name) != track->names.end(); };
    if (has("throttle") && !has("gear"))
        std::printf("note: %s has no column gear: the vehicle stays in neutral; add one, with 1 in it\n",
                    file.string().c_str());
    return foundation::success();
}

foundation::Outcome writeRecorded(const simulation::PersonSeat& seat, const std::filesystem::path& file,
                                  double timeS)
{
    if (file.empty()) return foundation::success();
    return foundation::writeWholeFile(file, simulation::writeInputs(seat.recorded(timeS)));
}

} // namespace trainer
