// SPDX-License-Identifier: Apache-2.0
#include "simulation/control/RecordedInputs.h"

#include <algorithm>
#include <cmath>

#include <foundation/Excerpt.h>

namespace simulation
{
namespace
{

std::string namesOf(std::span<const std::string_view> names)
{
    std::string text;
    for (const std::string_view name : names)
        text += (text.empty() ? "" : ", ") + std::string(name);
    return text;
}

} // namespace

foundation::Result<RecordedInputs> RecordedInputs::create(InputTrack track, const DynamicVehicle& vehicle,
                                                          const std::string& name, std::int64_t firstStep)
{
    const double stepS = vehicle.stepSeconds();
    if (track.stepsPerSecond > 0 && std::abs(track.stepsPerSecond * stepS - 1.0) > 1e-9)
        return foundation::Error{name,
                                 "its rate is " + std::to_string(track.stepsPerSecond) +
                                     " steps a second, the vehicle's " +
                                     std::to_string(std::lround(1.0 / stepS)),
                                 "record it anew, or write rows over time"};
    RecordedInputs inputs(std::move(track), stepS, firstStep);
    const std::span<const std::string_view> known = vehicle.inputNames();
    for (const std::string& input : inputs._track.names)
    {
        const auto place = std::find(known.begin(), known.end(), input);
        if (place == known.end())
            return foundation::Error{name, "the vehicle has no input '" + foundation::excerpt(input) + "'",
                                     "write one of: " + namesOf(known)};
        inputs._places.push_back(static_cast<std::size_t>(place - known.begin()));
    }
    inputs._values.resize(inputs._places.size());
    return inputs;
}

void RecordedInputs::control(const ControlView& view, std::span<double> inputs)
{
    const double place = _track.placeOf(_firstStep + view.step, _stepS);
    _track.valuesAt(place, _values);
    for (std::size_t i = 0; i < _places.size(); ++i)
        if (_values[i] != kInputNotGiven) inputs[_places[i]] = _values[i];
    _isDone = _track.end && _track.placeOf(_firstStep + view.step + 1, _stepS) >= *_track.end;
}

} // namespace simulation
