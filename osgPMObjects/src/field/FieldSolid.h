// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include <osg/NodeVisitor>

#include <osgPMObjects/core/field/Field.h>

#include "FieldMesh.h"

namespace osgPMObjects
{

/// A field's sphere as OSG keeps it, in floats, and as much larger as they round.
osg::BoundingSphere roundedUp(const core::BoundingSphere& sphere);

/// A field as intersections see it: nodes for its cells, below them transforms for the instances, below these
/// the finest level of their kind. So whatever an intersector does with nodes, it does with cells and
/// instances: one that misses a cell's sphere looks at none of its instances, and one that misses an
/// instance's at none of its faces. Nodes stay where they are once made, for paths of hits point to them:
/// those of cells with the first intersection, those of a cell's instances when the first reaches its sphere.
/// Memory, once asked for: some 0.3 KB a cell and 0.5 KB an instance of the cells that were reached; per
/// shape that of finestFaces().
/// Threads: any.
class FieldSolid
{
public:
    /// What it is made of. `meshes`: by kind.
    struct Source
    {
        std::shared_ptr<const core::Field> field;
        std::vector<osg::ref_ptr<FieldMesh>> meshes;
    };

    explicit FieldSolid(Source source) : _source(std::make_shared<const Source>(std::move(source))) {}

    void accept(osg::NodeVisitor& visitor);

    /// The instance that a path leads to, by the number that it was given with.
    static std::optional<std::uint32_t> instanceOf(const osg::NodePath& path);

private:
    std::shared_ptr<const Source> _source;
    std::once_flag _made;
    std::vector<osg::ref_ptr<osg::Node>> _cells;
};

} // namespace osgPMObjects
