// SPDX-License-Identifier: Apache-2.0
#include "GroundDrawable.h"

#include <osg/Geometry>
#include <osg/KdTree>
#include <osgDB/Registry>

#include "../view/TileBounds.h"

namespace osgTerrainROAM
{

namespace
{

/// The two triangles of a cell, cut as the bintree's finest level is; one where a corner is void, none where
/// more are.
void addCell(const ElevationSamples& samples, int column, int row, std::vector<GLuint>& indices)
{
    const auto at = [&](int corner)
    { return static_cast<GLuint>((row + corner / 2) * samples.columns + column + corner % 2); };
    int missing = -1, voids = 0;
    for (int corner = 0; corner < 4; ++corner)
        if (samples.voidAt(column + corner % 2, row + corner / 2))
        {
            missing = corner;
            ++voids;
        }
    if (voids > 1) return;
    static constexpr int kAround[4] = {0, 1, 3, 2}; // counter-clockwise
    if (voids == 1)
    {
        for (const int corner : kAround)
            if (corner != missing) indices.push_back(at(corner));
        return;
    }
    const bool rises = (column + row) % 2 == 0; // the diagonal, from the south-west
    for (const int corner : rises ? std::array{0, 1, 3, 0, 3, 2} : std::array{0, 1, 2, 1, 3, 2})
        indices.push_back(at(corner));
}

ClippedTriangles trianglesOf(const core::PlacedTile& tile, const ElevationSamples& samples)
{
    ClippedTriangles triangles;
    triangles.vertices.reserve(samples.heights.size());
    triangles.indices.reserve(6 * samples.heights.size());
    for (int row = 0; row < samples.rows; ++row)
        for (int column = 0; column < samples.columns; ++column)
        {
            const glm::vec3 p(tile.position(column, row));
            triangles.vertices.emplace_back(p.x, p.y, p.z);
        }
    for (int row = 0; row + 1 < samples.rows; ++row)
        for (int column = 0; column + 1 < samples.columns; ++column)
            addCell(samples, column, row, triangles.indices);
    return triangles;
}

} // namespace

GroundDrawable::GroundDrawable(const TileGround& ground) : _tile(ground.tile), _samples(ground.samples)
{
    setUseDisplayList(false);
    setSupportsDisplayList(false);
    if (osgDB::Registry::instance()->getBuildKdTreesHint() == osgDB::Options::BUILD_KDTREES) buildKdTree();
}

osg::BoundingBox GroundDrawable::computeBoundingBox() const
{
    return tileBounds(_tile->tile);
}

const ClippedTriangles& GroundDrawable::triangles() const
{
    std::call_once(_made, [this] { _triangles = trianglesOf(_tile->tile, *_samples); });
    return _triangles;
}

void GroundDrawable::buildKdTree()
{
    const ClippedTriangles& made = triangles();
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setVertexArray(
        new osg::Vec3Array(static_cast<unsigned int>(made.vertices.size()), made.vertices.data()));
    geometry->addPrimitiveSet(new osg::DrawElementsUInt(
        GL_TRIANGLES, static_cast<unsigned int>(made.indices.size()), made.indices.data()));
    osg::ref_ptr<osg::KdTree> tree = new osg::KdTree;
    osg::KdTree::BuildOptions options;
    if (tree->build(options, geometry.get())) setShape(tree);
}

} // namespace osgTerrainROAM
