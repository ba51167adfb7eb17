// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/Geometry>

#include <osgPMObjects/core/progressive/ProgressiveMesh.h>

namespace osgPMObjects
{

/// The wedges of a progressive mesh as vertices, all attributes in one vertex buffer.
class ShapeArrays
{
public:
    ShapeArrays(const core::ProgressiveMesh& progressive, const glm::dvec3& origin);

    /// Makes the arrays of a material as exportNode() does: a colour that all `isUsed` wedges share is one
    /// value for all.
    osg::ref_ptr<osg::Geometry> geometryOf(const core::Material& material,
                                           const std::vector<bool>& isUsed) const;

    const osg::ref_ptr<osg::Vec3Array>& vertices() const { return _vertices; }

private:
    osg::ref_ptr<osg::Array> coloursOf(const std::vector<bool>& isUsed) const;

    osg::ref_ptr<osg::Vec3Array> _vertices, _normals;
    osg::ref_ptr<osg::Vec4Array> _colours;
    osg::ref_ptr<osg::Vec2Array> _texCoords[core::Mesh::kTexCoordSets];
};

/// Finds, by group and wedge, whether faces of the group use the wedge at any level. Cost: that of applying
/// all steps once.
std::vector<std::vector<bool>> wedgesByGroup(const core::ProgressiveMesh& progressive);

} // namespace osgPMObjects
