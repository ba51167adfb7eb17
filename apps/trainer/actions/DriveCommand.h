// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>

#include <foundation/DataFile.h>
#include <foundation/Result.h>

#include "ride/RideRequest.h"
#include "simulation/vehicle/Ground.h"

namespace trainer
{

/// The arguments of `trainer drive`; the terrain file is the world: an OpenDRIVE network, or a .roam file
/// with roads. Empty paths: none.
struct DriveRequest : RideRequest
{
    std::filesystem::path vehicle = foundation::dataFile("vehicles/car.xml");
    double lengthM = 5000.0;                       ///< of the way
    double speedMps = 0.0;                         ///< most that the driver wants; 0: what the roads allow
    double startM = 1.0;                           ///< of the way, at which the rear axle begins
    std::optional<simulation::GroundKind> surface; ///< of the roads; absent: what their lanes are made of
};

/// Tells before any work, and before a world is made, what is wrong with a drive besides its pictures.
/// Errors: of files that cannot be read or written, of the vehicle's file.
foundation::Outcome checkDrive(const DriveRequest& request);

/// Drives a road vehicle by its own physics along the lanes of a world: by the driver or by recorded inputs,
/// with or without pictures, or by hand in a window. Prints how far it came and how far from the middle of
/// its lane it was at most.
/// Errors: those of the files, of the world (no roads), of the start.
foundation::Outcome drive(const DriveRequest& request);

} // namespace trainer
