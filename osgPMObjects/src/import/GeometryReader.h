// -*- c++ -*-
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/Geometry>
#include <osg/Matrixd>

#include <osgPMObjects/core/mesh/MeshBuilder.h>

#include <osgPMObjects/ImportNode>

namespace osgPMObjects
{

/// Which attributes of a mesh a geometry has: core::Material::Attribute bits.
std::uint32_t attributesOf(const osg::Geometry& geometry);

/// Where the faces of a geometry go.
struct GeometryPlace
{
    osg::Matrixd localToRoot;
    std::uint32_t material = 0;
    std::uint32_t part = 0;
};

/// Adds the surfaces of a geometry without deprecated data (osg::Geometry::fixDeprecatedData()) to a mesh.
void readGeometry(const osg::Geometry& geometry, const GeometryPlace& place, core::MeshBuilder& mesh,
                  ImportReport& report);

} // namespace osgPMObjects
