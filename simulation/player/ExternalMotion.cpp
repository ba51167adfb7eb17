// SPDX-License-Identifier: Apache-2.0
#include "simulation/player/ExternalMotion.h"

#include "simulation/player/actions/RunningAction.h"

namespace simulation
{

void ExternalMotion::move(ActionScene& scene, int actor)
{
    advanceTo(scene.timeS(), scene.trafficOf(actor));
    scene.motion(actor).takeState(state(), scene.timeS());
}

} // namespace simulation
