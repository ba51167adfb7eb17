// SPDX-License-Identifier: Apache-2.0
#include "simulation/control/InputRecorder.h"

#include <algorithm>
#include <cmath>

#include <foundation/WholeFile.h>

namespace simulation
{

InputRecorder::InputRecorder(const DynamicVehicle& vehicle)
{
    _track.stepsPerSecond = static_cast<int>(std::lround(1.0 / vehicle.stepSeconds()));
    for (const std::string_view name : vehicle.inputNames())
        _track.names.emplace_back(name);
}

void InputRecorder::add(std::int64_t step, std::span<const double> inputs)
{
    const auto at = static_cast<double>(step);
    _track.end = at + 1.0;
    InputTrack::Row row{at, {inputs.begin(), inputs.end()}};
    for (double& value : row.values)
        if (!std::isfinite(value)) value = 0.0; // as vehicles take NaN
    if (_track.rows.empty() || _track.rows.back().values != row.values) _track.rows.push_back(std::move(row));
}

foundation::Outcome InputRecorder::write(const std::filesystem::path& file) const
{
    if (_track.rows.empty())
        return foundation::Error{file.string(), "no step was made, so there are no inputs",
                                 "play for longer than one step"};
    return foundation::writeWholeFile(file, writeInputs(_track));
}

} // namespace simulation
