// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <osgRoads/core/surface/BuildRoadMesh.h>

#include "CrossSection.h"
#include "DecalRows.h"
#include "JunctionCover.h"
#include "MarkRows.h"
#include "OpenEnds.h"

namespace osgRoads::core
{

/// Adds the chunks of one lane section to a mesh.
class ChunkBuilder
{
public:
    ChunkBuilder(const PlacedNetwork& network, int road, const LaneSection& section, const OpenEnds& ends,
                 const RoadMeshSettings& settings, MarkRows& marks, DecalRows& decals, RoadMesh& mesh);

    void add(double from, double to);

private:
    /// A cross-section, where it lies in the scene.
    struct Row
    {
        double s = 0.0;
        std::vector<SectionPoint> points;
        std::vector<glm::dvec3> places;
    };

    Row rowAt(double s) const;
    void sample(double from, double to);
    bool mayBeCovered() const;
    bool isWithinReach() const;
    bool isOutsideOfTunnel(const Lane& lane, const Row& row) const;
    void addQuad(const std::array<std::uint32_t, 4>& corners);
    static double gapBetween(const Row& row, const Row& before, const Row& after);
    double gapAt(std::size_t row, std::size_t stride) const;
    double gapOfSteps(double enoughM) const;
    void addRow(const Row& row, double from, bool hasGround, const std::vector<MeshVertex>& strips);
    void addTriangles(std::uint32_t firstVertex, std::size_t rows, std::size_t stride, bool ofGround);
    void addLevels(RoadChunk& chunk, std::uint32_t firstVertex);
    std::vector<MeshVertex> stripsAt(double from, bool hasGround) const;
    bool isGap(std::size_t column, int side) const;
    std::vector<SurfaceQuad> quadsOf(std::size_t firstColumn, std::size_t columns) const;

    const PlacedNetwork& _network;
    int _road;
    const LaneSection& _section;
    const OpenEnds& _ends;
    const RoadMeshSettings& _settings;
    CrossSection _shape;
    JunctionCover _cover;
    MarkRows& _marks;
    DecalRows& _decals;
    RoadMesh& _mesh;
    bool _mayBeCovered = false; ///< by other roads, anywhere in this chunk
    bool _isInTunnel = false;   ///< this chunk
    std::vector<Row> _rows;     ///< of the finest level and one between each two of them
};

} // namespace osgRoads::core
