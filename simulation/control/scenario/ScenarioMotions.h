// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "simulation/player/MotionSource.h"
#include "simulation/vehicle/EarthFrame.h"
#include "simulation/vehicle/Ground.h"

namespace simulation
{

/// Makes the vehicles with physics that controllers of a scenario drive: Autopilot, Driver, RecordedInputs
/// with their properties (docs/reference/openscenario.md). Each has the scenario's wind, air and road
/// friction.
class ScenarioMotions final : public MotionSource
{
public:
    struct World
    {
        std::shared_ptr<const Ground> ground;
        std::optional<Geodetic>
            origin; ///< of the scene; absent: aircraft fly at 46° N, 8° E, cars drive on flat ground
        std::filesystem::path folder{}; ///< of the scenario: files of properties lie there
        std::uint64_t seed = 0;         ///< of turbulence, together with the property `seed`
    };

    explicit ScenarioMotions(World world);

    foundation::Outcome check(const Controller& controller, const ScenarioObject& object) override;
    foundation::Result<std::shared_ptr<ExternalMotion>>
    make(const Controller& controller, const ScenarioObject& object, const MotionStart& start) override;

private:
    World _world;
    std::shared_ptr<const EarthFrame> _earth;
};

} // namespace simulation
