// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "simulation/control/InputTrack.h"
#include "simulation/control/VehicleController.h"

namespace simulation
{

/// Plays the inputs of a track. An input that the track does not name, or not yet, stays as the vehicle has
/// it.
class RecordedInputs final : public VehicleController
{
public:
    /// `name`: stands for the file in errors. Errors: an input that the vehicle does not have; a track that
    /// was recorded at another step.
    /// `firstStep`: step of the track that the vehicle's first one is.
    static foundation::Result<RecordedInputs> create(InputTrack track, const DynamicVehicle& vehicle,
                                                     const std::string& name, std::int64_t firstStep = 0);

    void control(const ControlView& view, std::span<double> inputs) override;
    std::string_view phase() const override { return "recorded"; }

    /// After the track's end; without one never.
    bool isDone() const override { return _isDone; }

private:
    RecordedInputs(InputTrack track, double stepS, std::int64_t firstStep)
        : _track(std::move(track)), _stepS(stepS), _firstStep(firstStep)
    {
    }

    InputTrack _track;
    double _stepS;
    std::int64_t _firstStep;
    std::vector<std::size_t> _places; ///< of the track's inputs among the vehicle's
    std::vector<double> _values;
    bool _isDone = false;
};

} // namespace simulation
