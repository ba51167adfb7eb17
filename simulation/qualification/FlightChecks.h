// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>

#include <foundation/Result.h>

#include "simulation/qualification/QualificationCheck.h"
#include "simulation/vehicle/flight/AircraftData.h"

namespace simulation
{

/// Steady flight at 70 and 100 kt, and what a flight does from there after each stored input, against the
/// flights of JSBSim's c172p in `folder` (jsbsim/c172p-response of the real data). A response is judged by
/// its RMS difference over the largest excursion.
/// Errors: those of reading the flights.
foundation::Result<QualificationChecks> responseChecks(const std::shared_ptr<const AircraftData>& aircraft,
                                                       const std::filesystem::path& folder);
foundation::Result<QualificationChecks> steadyFlightChecks(const AircraftData& aircraft,
                                                           const std::filesystem::path& folder);
foundation::Result<QualificationChecks> oscillationChecks(const std::shared_ptr<const AircraftData>& aircraft,
                                                          const std::filesystem::path& folder);

/// Performance at the handbook's weight in standard air at sea level, and the rate of a steady turn. A figure
/// that the aircraft does not reach at all is not a number and fails.
QualificationChecks handbookChecks(const AircraftData& aircraft);

} // namespace simulation
