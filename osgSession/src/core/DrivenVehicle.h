// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <foundation/Result.h>

#include "simulation/control/ManualController.h"
#include "simulation/control/VehicleMotion.h"
#include "simulation/geodesy/LocalFrame.h"
#include "simulation/vehicle/Ground.h"

namespace osgSession::core
{

/// A vehicle whose inputs a host puts.
class DrivenVehicle
{
public:
    /// `file`: data of a road vehicle or an aircraft. `origin`: of the scene; absent: no georeference.
    /// Errors: as openVehicle() and manualPilot().
    static foundation::Result<DrivenVehicle> create(const std::filesystem::path& file,
                                                    std::shared_ptr<const simulation::Ground> ground,
                                                    const std::optional<simulation::Geodetic>& origin,
                                                    std::uint64_t seed);

    const std::shared_ptr<simulation::VehicleMotion>& motion() const { return _motion; }

    std::vector<std::string> inputs() const;

    /// Errors: an input that the vehicle has not, NaN.
    foundation::Outcome set(const std::string& input, double value);

private:
    DrivenVehicle(std::shared_ptr<simulation::VehicleMotion> motion, simulation::ManualController* manual)
        : _motion(std::move(motion)), _manual(manual)
    {
    }

    std::shared_ptr<simulation::VehicleMotion> _motion;
    simulation::ManualController* _manual; ///< of the motion
};

} // namespace osgSession::core
