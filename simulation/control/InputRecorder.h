// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <span>

#include "simulation/control/InputTrack.h"
#include "simulation/vehicle/DynamicVehicle.h"

namespace simulation
{

/// Records the inputs of a vehicle step by step; a row is kept where an input changes. RecordedInputs plays
/// the file back to the last bit.
class InputRecorder
{
public:
    explicit InputRecorder(const DynamicVehicle& vehicle);

    /// Takes the inputs of the step that follows. `step`: steps made since the vehicle's start, ascending.
    void add(std::int64_t step, std::span<const double> inputs);

    const InputTrack& track() const { return _track; }

    /// Writes the inputs file. Errors: those of foundation::writeWholeFile(); nothing was recorded.
    foundation::Outcome write(const std::filesystem::path& file) const;

private:
    InputTrack _track;
};

} // namespace simulation
