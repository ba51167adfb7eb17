// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include <foundation/Result.h>

#include <osgRoads/core/network/RoadNetwork.h>

namespace osgRoads::core
{

/// Writes a network as OpenDRIVE 1.7: header with geoReference, roads with links, kinds, plan view,
/// elevation, superelevation, lanes (widths, links, heights, speeds, marks by their type), bridges and
/// tunnels, objects, signals with their controllers, junctions with their connections and priorities.
/// Numbers have twelve significant digits: 1 µm at 1000 km from the origin. The same network gives the same
/// bytes.
/// Differs: not written are crossfall, shapes, explicit marks, lane rules, objects with outlines or repeats,
/// signals with a post elsewhere, dependencies or references, so a network that has any of these is an error,
/// not a shorter file.
/// Errors: those; the file cannot be written (then nothing is left under its name).
/// Source: ASAM OpenDRIVE 1.7, 6 (general), 8 to 14.
foundation::Outcome writeNetwork(const RoadNetwork& network, const std::filesystem::path& file);

} // namespace osgRoads::core
