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

    /// The arrays that a material has, as exportNode() chooses them: a colour that is the same in all of the `isUsed` wedges is one for all.
    osg::ref_ptr<osg::Geometry> geometryOf(const core::Material& material,
                                           const std::vector<bool>& isUsed) const;

    const osg::ref_ptr<osg::Vec3Array>& vertices() const { return _vertices; }

private:
    osg::ref_ptr<osg::Array> coloursOf(const std::vector<bool>& isUsed) const;

    osg::ref_ptr<osg::Vec3Array> _vertices, _normals;
    osg::ref_ptr<osg::Vec4Array> _colours;
    osg::ref_ptr<osg::Vec2Array> _texCoords[core::Mesh::kTexCoordSets];
};

/// By group and wedge, whether faces of the group use the wedge at any level. Cost: that of playing all steps once.
std::vector<std::vector<bool>> wedgesByGroup(const core::ProgressiveMesh& progressive);

} // namespace osgPMObjects
