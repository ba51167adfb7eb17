// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <glm/vec3.hpp>

#include <osgPMObjects/core/mesh/Extent.h>
#include <osgPMObjects/core/mesh/Mesh.h>
#include <osgPMObjects/core/simplify/Simplify.h>

#include "../envelope/Envelope.h"
#include "../leaves/LeafCards.h"
#include "../parts/ConnectedParts.h"
#include "../quadric/Placement.h"
#include "../star/StarMesh.h"
#include "../symmetry/MirrorTwins.h"
#include "CollapseQueue.h"
#include "UnitFrame.h"

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

/// The last face of a material goes as if everything were so far off, as a share of the diagonal.
constexpr double kMaterialDistance = 0.05;

/// A mesh on its way. What each position and each face has belongs to one part, so threads
/// that work on different parts do not meet.
struct CollapseState
{
    const SimplifySettings settings;
    AreaWeight weight;
    std::unique_ptr<Mesh>
        movedMesh;    ///< with optimal placement: a copy without positions, whose wedges change
    const Mesh& mesh; ///< that, or the original
    UnitFrame frame;
    std::vector<glm::dvec3> positions; ///< in the frame
    Extent box;                        ///< in the frame
    StarMesh stars;
    MirrorTwins twins;
    std::unique_ptr<Envelope> envelope; ///< null: none is asked for
    std::vector<ConnectedPart> parts;
    std::vector<std::uint32_t> partOf; ///< by position: what it belonged to at first
    std::vector<std::vector<LeafCard>>
        foliage; ///< by material: parts that a LeafCollapser takes, no Collapser
    mutable std::vector<std::uint32_t> joinedTo; ///< by part: the part it has been joined to; itself
    std::vector<std::uint32_t> nearby; ///< by position: the nearest of another part; empty: parts do not join
    mutable std::vector<std::uint32_t> wentTo; ///< by position: where it went; itself
    std::vector<StarShape> shapes;             ///< by position
    std::vector<LevelError> errors;            ///< by position: of what has gone into it
    std::vector<std::uint32_t> changes;        ///< by position: how often its star has changed
    std::vector<Candidate> candidates;         ///< by position

    CollapseState(const Mesh& original, const SimplifySettings& settings);

    bool movesPlaces() const { return settings.placement != Placement::subset; }
    ConnectedPart& part(std::uint32_t position) { return parts[partNumber(position)]; }
    const ConnectedPart& part(std::uint32_t position) const { return parts[partNumber(position)]; }
    std::uint32_t partNumber(std::uint32_t position) const { return followed(joinedTo, partOf[position]); }
    /// What has become of the nearest position of another part; ~0: there is none, or it is of the same part now.
    std::uint32_t nearbyNow(std::uint32_t position) const;
    /// Makes one of two positions' parts.
    void joinParts(std::uint32_t from, std::uint32_t to);

private:
    /// The end of a path, which gets shorter on the way.
    static std::uint32_t followed(std::vector<std::uint32_t>& next, std::uint32_t i)
    {
        while (next[i] != i)
            i = next[i] = next[next[i]];
        return i;
    }
};

} // namespace osgPMObjects::core
