// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>

#include "simulation/control/VehicleController.h"

namespace testsupport
{

/// A vehicle that goes east: the input `push` is its acceleration, `brake` takes speed away.
class TestCart : public simulation::DynamicVehicle
{
public:
    static constexpr std::array<std::string_view, 2> kNames{"push", "brake"};

    std::span<const std::string_view> inputNames() const override { return kNames; }
    std::span<double> inputs() override { return _inputs; }
    double stepSeconds() const override { return 1.0 / 120.0; }

    void step(const simulation::Ground& /*ground*/, const simulation::Air& /*air*/) override
    {
        _state.velocity.x += (_inputs[0] - _inputs[1]) * stepSeconds();
        _state.position.x += _state.velocity.x * stepSeconds();
        _state.timeS = static_cast<double>(++_steps) * stepSeconds();
    }

    foundation::Outcome begin(const simulation::VehicleStart& start, const simulation::Ground& /*ground*/,
                              const simulation::Air& /*air*/) override
    {
        _state.position = start.position - referencePoint();
        _state.velocity.x = start.speedMps;
        return foundation::success();
    }

    glm::dvec3 referencePoint() const override { return {-1.0, 0.0, -0.5}; }
    void writeParts(simulation::EntityState& entity) const override { entity.steeringDeg = _inputs[1]; }
    simulation::VehicleState state() const override { return _state; }
    simulation::VehicleStatus status() const override { return {}; }

private:
    std::array<double, 2> _inputs{};
    simulation::VehicleState _state;
    int _steps = 0;
};

} // namespace testsupport
