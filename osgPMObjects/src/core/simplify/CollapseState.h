// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <glm/vec3.hpp>

#include <osgPMObjects/core/mesh/Extent.h>
#include <osgPMObjects/core/mesh/Mesh.h>
#include <osgPMObjects/core/simplify/Simplify.h>

#include "CollapseQueue.h"
#include "ConnectedParts.h"
#include "Envelope.h"
#include "MirrorTwins.h"
#include "Placement.h"
#include "StarMesh.h"

namespace osgPMObjects::core
{

/// The best collapse known of a position.
struct Candidate
{
    std::uint32_t to = ~0u;
    std::uint32_t changes = 0, changesOfTo = 0; ///< of both stars when it was found
    std::uint32_t neighbours = 0;               ///< how many there were to choose from
    Urgency urgency;
};

/// A mesh on its way, in a frame where its diagonal is 1. What each position and each face has belongs to one part, so threads
/// that work on different parts do not meet.
struct CollapseState
{
    const SimplifySettings settings;
    AreaWeight weight;
    Mesh mesh; ///< wedges change with optimal placement; without positions
    std::vector<glm::dvec3> positions;
    Extent box;
    StarMesh stars;
    MirrorTwins twins;
    std::unique_ptr<Envelope> envelope; ///< null: none is asked for
    std::vector<ConnectedPart> parts;
    std::vector<std::uint32_t> partOf;  ///< by position
    std::vector<StarShape> shapes;      ///< by position
    std::vector<LevelError> errors;     ///< by position: of what has gone into it
    std::vector<std::uint32_t> changes; ///< by position: how often its star has changed
    std::vector<Candidate> candidates;  ///< by position

    CollapseState(const Mesh& original, const SimplifySettings& settings);

    bool movesPlaces() const { return settings.placement != Placement::subset; }
    ConnectedPart& part(std::uint32_t position) { return parts[partOf[position]]; }
    const ConnectedPart& part(std::uint32_t position) const { return parts[partOf[position]]; }
};

} // namespace osgPMObjects::core
