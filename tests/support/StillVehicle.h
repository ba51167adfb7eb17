// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "simulation/vehicle/DynamicVehicle.h"

namespace testsupport
{

/// A vehicle with these inputs that nothing steps.
class StillVehicle : public simulation::DynamicVehicle
{
public:
    explicit StillVehicle(std::span<const std::string_view> names) : _names(names), _inputs(names.size()) {}

    std::span<const std::string_view> inputNames() const override { return _names; }
    std::span<double> inputs() override { return _inputs; }
    double stepSeconds() const override { return 0.01; }
    void step(const simulation::Ground& /*ground*/, const simulation::Air& /*air*/) override {}
    foundation::Outcome begin(const simulation::VehicleStart& /*start*/, const simulation::Ground& /*ground*/,
                              const simulation::Air& /*air*/) override
    {
        return foundation::success();
    }
    glm::dvec3 referencePoint() const override { return glm::dvec3(0.0); }
    void writeParts(simulation::EntityState& /*entity*/) const override {}
    simulation::VehicleState state() const override { return {}; }
    simulation::VehicleStatus status() const override { return {}; }

private:
    std::span<const std::string_view> _names;
    std::vector<double> _inputs;
};

} // namespace testsupport
