// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/Array>
#include <osg/Group>
#include <osg/Vec3>
#include <osg/Vec4>

namespace measurement
{

/// Triangles as corners one after the other, with a colour each.
struct Soup
{
    osg::ref_ptr<osg::Vec3Array> corners = new osg::Vec3Array;
    osg::ref_ptr<osg::Vec4Array> colours = new osg::Vec4Array;

    void add(const osg::Vec3& a, const osg::Vec3& b, const osg::Vec3& c, const osg::Vec4& colour);

    /// Adds a triangle in grey, the lighter the more it faces the light.
    void addLit(const osg::Vec3& a, const osg::Vec3& b, const osg::Vec3& c);
};

/// Triangles filled in their colours, with dark sides or without.
osg::ref_ptr<osg::Group> drawnTriangles(const Soup& soup, bool hasSides = true);

} // namespace measurement
