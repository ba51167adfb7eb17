// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "FlightStarts.h"
#include "FlyRequest.h"
#include "Ride.h"
#include "simulation/control/ControlSwitch.h"
#include "simulation/control/scenario/VehicleFiles.h"
#include "simulation/vehicle/DynamicVehicle.h"
#include "simulation/vehicle/EarthFrame.h"

namespace trainer
{

/// Makes one flight after the other over one ground, among what stands there.
class FlightMaker final : public RideMaker
{
public:
    FlightMaker(const FlyRequest& request, std::shared_ptr<const simulation::Ground> ground,
                const std::optional<simulation::Geodetic>& origin,
                std::shared_ptr<const simulation::ObstacleMap> obstacles = nullptr)
        : _request(request),
          _ground(std::move(ground)),
          _obstacles(std::move(obstacles)),
          _origin(origin),
          _earth(simulation::earthOf(origin)),
          _starts(startsOf(request))
    {
    }

    KeyScope kind() const override { return KeyScope::flight; }
    std::vector<RidePlace> places() const override;
    foundation::Result<Ride> make(std::size_t place) override;

private:
    foundation::Result<std::unique_ptr<simulation::VehicleController>>
    seated(std::unique_ptr<simulation::VehicleController> automatic,
           const simulation::DynamicVehicle& aircraft) const;

    const FlyRequest& _request;
    std::shared_ptr<const simulation::Ground> _ground;
    std::shared_ptr<const simulation::ObstacleMap> _obstacles; ///< null: nothing stands there
    std::optional<simulation::Geodetic> _origin;
    std::shared_ptr<const simulation::EarthFrame> _earth;
    std::vector<FlightStart> _starts;
};

} // namespace trainer
