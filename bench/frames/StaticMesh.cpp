// SPDX-License-Identifier: Apache-2.0
#include "StaticMesh.h"

#include <algorithm>

#include <osg/NodeVisitor>

namespace framebench
{

using namespace osgTerrainROAM::core;

namespace
{

struct CountingDraw : public osg::Drawable::DrawCallback
{
    CountingDraw(DrawCount& into, std::uint64_t triangles) : _into(into), _triangles(triangles) {}

    void drawImplementation(osg::RenderInfo& info, const osg::Drawable* drawable) const override
    {
        _into.triangles += _triangles;
        drawable->drawImplementation(info);
    }

private:
    DrawCount& _into;
    std::uint64_t _triangles;
};

class CountingVisitor : public osg::NodeVisitor
{
public:
    explicit CountingVisitor(DrawCount& into) : osg::NodeVisitor(TRAVERSE_ALL_CHILDREN), _into(into) {}

    void apply(osg::Geometry& geometry) override
    {
        std::uint64_t triangles = 0;
        for (const auto& set : geometry.getPrimitiveSetList())
            triangles += set->getNumPrimitives();
        geometry.setDrawCallback(new CountingDraw(_into, triangles));
    }

private:
    DrawCount& _into;
};

struct GivenBox : public osg::Drawable::ComputeBoundingBoxCallback
{
    explicit GivenBox(const osg::BoundingBox& given) : _box(given) {}
    osg::BoundingBox computeBound(const osg::Drawable&) const override { return _box; }

private:
    osg::BoundingBox _box;
};

/// The arrays of the shader's two vertex attributes: position in whole steps, and grid point.
struct VertexArrays
{
    osg::ref_ptr<osg::Vec3iArray> position = new osg::Vec3iArray;
    osg::ref_ptr<osg::Vec2usArray> grid = new osg::Vec2usArray;

    VertexArrays() { position->setPreserveDataType(true); }

    void add(const MeshVertex& v)
    {
        position->push_back({v.position.x, v.position.y, v.position.z});
        grid->push_back({v.grid.x, v.grid.y});
    }

    osg::ref_ptr<osg::Geometry> geometry(osg::DrawElementsUInt* triangles, const osg::BoundingBox& box) const
    {
        osg::ref_ptr<osg::Geometry> made = new osg::Geometry;
        made->setUseDisplayList(false);
        made->setUseVertexBufferObjects(true);
        made->setVertexAttribArray(0, position, osg::Array::BIND_PER_VERTEX);
        made->setVertexAttribArray(1, grid, osg::Array::BIND_PER_VERTEX);
        made->addPrimitiveSet(triangles);
        made->setComputeBoundingBoxCallback(new GivenBox(box));
        return made;
    }
};

/// Makes the geometry of one patch. Odd and even cells are cut along different diagonals.
osg::ref_ptr<osg::Geometry> patchOf(const PlacedTile& tile, const VertexArrays& arrays, int left, int bottom,
                                    int cells)
{
    const auto at = [&](int c, int r) { return static_cast<GLuint>(r * tile.grid().side() + c); };
    osg::ref_ptr<osg::DrawElementsUInt> triangles = new osg::DrawElementsUInt(GL_TRIANGLES);
    triangles->reserve(static_cast<std::size_t>(cells) * cells * 6);
    osg::BoundingBoxd box;
    const double stepM = tile.frame().vertexStepM();
    for (int r = bottom; r < bottom + cells; ++r)
        for (int c = left; c < left + cells; ++c)
        {
            const GLuint sw = at(c, r), se = at(c + 1, r), ne = at(c + 1, r + 1), nw = at(c, r + 1);
            if ((c + r) % 2 == 0)
                for (const GLuint i : {sw, se, ne, sw, ne, nw})
                    triangles->push_back(i);
            else
                for (const GLuint i : {sw, se, nw, se, ne, nw})
                    triangles->push_back(i);
            for (const GLuint i : {sw, se, ne, nw})
            {
                const auto p = (*arrays.position)[i];
                box.expandBy(p.x() * stepM, p.y() * stepM, p.z() * stepM);
            }
        }
    return arrays.geometry(triangles, osg::BoundingBox(box._min, box._max));
}

} // namespace

void countDraws(osg::Node& node, DrawCount& count)
{
    CountingVisitor visitor(count);
    node.accept(visitor);
}

osg::ref_ptr<osg::Geode> staticMesh(const DrawnMesh& mesh)
{
    VertexArrays arrays;
    for (const MeshVertex& v : mesh.vertices)
        arrays.add(v);
    osg::ref_ptr<osg::DrawElementsUInt> triangles = new osg::DrawElementsUInt(GL_TRIANGLES);
    triangles->reserve(mesh.triangles.size() * 3);
    for (const LeafTriangle& t : mesh.triangles)
        triangles->insert(triangles->end(), std::begin(t.vertices), std::end(t.vertices));
    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->addDrawable(arrays.geometry(triangles, osg::BoundingBox(-1, -1, -1, 1, 1, 1)));
    geode->setCullingActive(false);
    geode->getDrawable(0)->setCullingActive(false);
    return geode;
}

osg::ref_ptr<osg::Geode> fullGrid(const PlacedTile& tile, int patchCells)
{
    VertexArrays arrays;
    for (int row = 0; row < tile.grid().side(); ++row)
        for (int column = 0; column < tile.grid().side(); ++column)
            arrays.add(meshVertex(tile.position(column, row), {column, row}, tile.frame().vertexStepM()));
    const int cells = tile.grid().side() - 1, step = std::min(patchCells, cells);
    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    for (int bottom = 0; bottom < cells; bottom += step)
        for (int left = 0; left < cells; left += step)
            geode->addDrawable(patchOf(tile, arrays, left, bottom, step));
    return geode;
}

} // namespace framebench
