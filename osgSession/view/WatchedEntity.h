// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

#include <foundation/Result.h>

#include "simulation/scenario/Scenario.h"

namespace trainer
{

/// Returns the index of the entity that the camera is in or looks at: the one of that name; without a name
/// the first whose name says that it is the person's own (ego, ownship, hero, in any case), else the first
/// vehicle that nothing tows, else the first that is no thing, else the first. Errors: there is none of that
/// name. Precondition: there are entities.
foundation::Result<std::size_t> watchedEntity(const simulation::Scenario& scenario, const std::string& name);

/// The room that an entity takes with all that it tows, straight behind it. Units: metres.
struct TrainSize
{
    double behindM = 0.0; ///< how far it reaches behind the reference point of the entity
    double heightM = 0.0; ///< of the highest part
};
TrainSize trainOf(const simulation::Scenario& scenario, std::size_t entity);

} // namespace trainer
