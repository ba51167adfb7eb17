// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include <osgPMObjects/core/progressive/ProgressiveLevel.h>
#include <osgTerrainROAM/core/blocks/BlockMesh.h>
#include <osgTerrainROAM/core/blocks/BlockRim.h>
#include <osgTerrainROAM/core/blocks/VipmBlocks.h>
#include <osgTerrainROAM/core/roam/PreparedTerrain.h>

namespace osgTerrainROAM::core
{

/// Blocks of view-independent progressive meshes: each block has the coarsest level whose error is allowed at
/// its distance. Their borders are locked, and the mesh conforms; or the blocks overlap, and no ray from
/// above passes between them (BlockRim). The levels depend on the eye alone, not on what came before; only
/// blocks whose level has changed are written.
/// Cost of a refinement: about 50 ns a block; for a block that changes, the edge collapses or vertex splits
/// between its levels, and writing it.
/// Source: *Methods of continuous level of detail for terrain* (Graphicon 2002), section 4.2.
class VipmMesh final : public BlockMesh
{
public:
    explicit VipmMesh(std::shared_ptr<const VipmBlocks> blocks);

    const RoamTile& tile() const override { return _blocks->tile(); }
    RefineResult refine(const viewlod::ViewState& view, const viewlod::Budget& budget) override;
    RefineResult refine(double errorM) override;
    void setMorphing(bool) override {}
    bool isBehind() const override { return tile().revision() != _blocks->revision(); }
    std::size_t memoryBytes() const override;

    /// The level of a block in the last refinement, by its place in VipmBlock::levels.
    std::size_t level(std::uint32_t block) const { return _levels[block]; }

protected:
    const BlockBox& box(std::uint32_t block) const override { return _boxes[block]; }

private:
    static constexpr std::size_t kUnwritten = ~std::size_t{0};

    /// The levels at a tolerance, and the triangles that they have.
    struct Choice
    {
        std::vector<std::size_t> levels;
        double tolerance = 0.0;
        std::uint32_t triangles = 0;
    };

    bool overlaps() const { return _blocks->borders() == VipmBorders::overlapping; }
    void bound();
    void followTile();
    Choice choose(const std::vector<double>& allowedPerTolerance, double tolerance) const;
    RefineResult show(const Choice& choice);
    void write(std::uint32_t block, std::size_t level);
    void writeVerticesOf(std::uint32_t block, const BlockRim* rim, std::uint32_t capacity);

    std::shared_ptr<const VipmBlocks> _blocks;
    std::vector<std::unique_ptr<osgPMObjects::core::ProgressiveLevel>> _players; ///< by block
    std::vector<std::size_t> _levels;                                            ///< by block
    std::vector<BlockBox> _boxes; ///< by block: around all that it draws
};

/// A tile prepared for blocks of progressive meshes.
class PreparedVipm : public PreparedTerrain
{
public:
    explicit PreparedVipm(std::shared_ptr<const RoamTile> tile, VipmBorders borders = VipmBorders::locked);

    const RoamTile& tile() const override { return _blocks->tile(); }
    std::unique_ptr<TerrainMesh> newMesh() const override;
    std::uint32_t fewestTriangles() const override;
    std::size_t memoryBytes() const override { return _blocks->memoryBytes(); }
    const std::shared_ptr<const VipmBlocks>& blocks() const { return _blocks; }

private:
    std::shared_ptr<const VipmBlocks> _blocks;
};

} // namespace osgTerrainROAM::core
