// SPDX-License-Identifier: Apache-2.0
// Pictures of triangles with dark sides, for sheets.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <osg/Array>
#include <osg/Group>
#include <osg/Image>

#include <osgOffscreen/OffscreenViewer>

namespace sheet
{

/// Ends the program with a message.
[[noreturn]] void endWith(const std::string& message);

/// Triangles as corners one after the other, with a colour each.
struct Soup
{
    osg::ref_ptr<osg::Vec3Array> corners = new osg::Vec3Array;
    osg::ref_ptr<osg::Vec4Array> colours = new osg::Vec4Array;

    void add(const osg::Vec3& a, const osg::Vec3& b, const osg::Vec3& c, const osg::Vec4& colour);

    /// Adds a triangle in grey, the lighter the more it faces the light.
    void addLit(const osg::Vec3& a, const osg::Vec3& b, const osg::Vec3& c);
};

/// Triangles filled in their colours, with dark sides.
osg::ref_ptr<osg::Group> outlined(const Soup& soup);

/// A viewer of a scene before a light sky. Ends the program where there is no context.
std::unique_ptr<osgOffscreen::OffscreenViewer> viewerOn(osg::Node* scene, int widthPx, int heightPx);

/// Writes a PNG file and adds its name to `files`. Ends the program where it cannot be written.
void write(const osg::Image& image, const std::filesystem::path& file,
           std::vector<std::filesystem::path>& files);

} // namespace sheet
