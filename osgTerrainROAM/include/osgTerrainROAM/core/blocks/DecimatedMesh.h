// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include <osgTerrainROAM/core/blocks/BlockMesh.h>
#include <osgTerrainROAM/core/blocks/LevelChoice.h>
#include <osgTerrainROAM/core/roam/PreparedTerrain.h>

namespace osgTerrainROAM::core
{

/// Regular decimation (geometrical mip-mapping): each block is drawn at one level, which keeps every 2^k-th
/// row and column. Where the neighbour is coarser, fans leave out the vertices that it lacks, so the mesh
/// conforms whatever the levels are. Levels depend on the eye alone, not on what came before. Only blocks
/// whose shape has changed are written; with morphing these are most blocks, in every frame.
/// Cost of a refinement: about 50 ns a block, and 20 ns for each vertex and triangle written; where the
/// ceiling binds, 30 times the former.
/// Source: *Methods of continuous level of detail for terrain* (Graphicon 2002), section 3. Differs: errors
/// are exact instead of those of removed vertices alone; morphing of blocks bounds the error of the drawn
/// surface.
class DecimatedMesh final : public BlockMesh
{
public:
    explicit DecimatedMesh(std::shared_ptr<const BlockErrors> errors);

    const RoamTile& tile() const override { return _errors->tile(); }
    RefineResult refine(const viewlod::ViewState& view, const viewlod::Budget& budget) override;
    RefineResult refine(double errorM) override;
    void setMorphing(bool on) override { _isMorphing = on; }
    bool isBehind() const override { return tile().revision() != _errors->revision(); }
    std::size_t memoryBytes() const override;

    /// The levels of the last refinement.
    const BlockLevels& levels() const { return _levels; }
    const BlockErrors& errors() const { return *_errors; }

protected:
    const BlockBox& box(std::uint32_t block) const override { return _errors->box(block); }

private:
    /// What a block's vertices depend on: the level and those of its borders, with their shares.
    struct State
    {
        BlockShape shape;
        double level = -1.0;
        double borders[kSides] = {};

        friend bool operator==(const State&, const State&) = default;
    };

    void followTile();
    RefineResult show(LevelsInCeiling levels);
    State stateOf(std::uint32_t block) const;
    void write(std::uint32_t block, const State& state);
    glm::dvec3 drawnAt(const State& state, GridPoint origin, GridPoint local) const;

    std::shared_ptr<const BlockErrors> _errors;
    BlockLevels _levels;
    std::vector<State> _states; ///< by block; of level -1: not written
    bool _isMorphing = false;
};

/// A tile prepared for regular decimation.
class PreparedDecimation : public PreparedTerrain
{
public:
    explicit PreparedDecimation(std::shared_ptr<const RoamTile> tile);

    const RoamTile& tile() const override { return _errors->tile(); }
    std::unique_ptr<TerrainMesh> newMesh() const override;
    std::uint32_t fewestTriangles() const override { return 2 * _errors->grid().count(); }
    std::size_t memoryBytes() const override { return _errors->memoryBytes(); }
    const std::shared_ptr<const BlockErrors>& errors() const { return _errors; }

private:
    std::shared_ptr<const BlockErrors> _errors;
};

} // namespace osgTerrainROAM::core
