// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <osgRoads/core/surface/BuildRoadMesh.h>

#include "CrossSection.h"
#include "JunctionCover.h"

namespace osgRoads::core
{

/// The surface between samples of a smooth curve departs by little more than at the samples: errors are
/// measured there, times this.
inline constexpr double kBetweenSamples = 1.15;

/// A cross-section, where it lies in the scene.
struct ChunkRow
{
    double s = 0.0;
    std::vector<SectionPoint> points;
    std::vector<glm::dvec3> places;
};

/// Takes the cross-sections of a chunk as close to each other as its surface needs.
class ChunkRows
{
public:
    ChunkRows(const PlacedNetwork& network, int road, const LaneSection& section, const CrossSection& shape,
              const JunctionCover& cover, const RoadMeshSettings& settings);

    /// Replaces the rows by those between two places, in metres along the road: those of the finest level,
    /// and one between each two of them.
    void sample(double from, double to);

    const std::vector<ChunkRow>& rows() const { return _rows; }
    /// Whether other roads may cover anything between the first and the last row.
    bool mayBeCovered() const { return _mayBeCovered; }

    ChunkRow rowAt(double s) const;
    /// Returns how far a row lies from the level that keeps every `stride`th one. Units: metres.
    double gapAt(std::size_t row, std::size_t stride) const;

private:
    double gapOfSteps(double enoughM) const;
    bool isNearOthers() const;
    std::vector<ChunkRow> withMiddles(double from, double to);

    const PlacedNetwork& _network;
    int _road;
    const LaneSection& _section;
    const CrossSection& _shape;
    const JunctionCover& _cover;
    const RoadMeshSettings& _settings;
    bool _mayBeCovered = false;
    std::vector<ChunkRow> _rows;
};

} // namespace osgRoads::core
