// SPDX-License-Identifier: Apache-2.0
#include "simulation/player/controllers/SpeedController.h"
#include "simulation/player/controllers/SpeedControllers.h"

namespace simulation
{
namespace
{

/// A person who is not there: the entity stands still.
class StandingStill final : public SpeedController
{
public:
    double speedAfter(ActionScene&, int) override { return 0.0; }
};

} // namespace

std::unique_ptr<EntityController> makeStandingStill(const Controller&, double)
{
    return std::make_unique<StandingStill>();
}

} // namespace simulation
