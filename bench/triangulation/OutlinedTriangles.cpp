// SPDX-License-Identifier: Apache-2.0
#include "OutlinedTriangles.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include <osg/Geometry>
#include <osg/PolygonMode>
#include <osg/PolygonOffset>

#include <osgOffscreen/PngFile>

namespace sheet
{

void endWith(const std::string& message)
{
    std::fprintf(stderr, "%s\n", message.c_str());
    std::exit(1);
}

void Soup::add(const osg::Vec3& a, const osg::Vec3& b, const osg::Vec3& c, const osg::Vec4& colour)
{
    for (const osg::Vec3& corner : {a, b, c})
    {
        corners->push_back(corner);
        colours->push_back(colour);
    }
}

void Soup::addLit(const osg::Vec3& a, const osg::Vec3& b, const osg::Vec3& c)
{
    osg::Vec3 normal = (b - a) ^ (c - a);
    normal.normalize();
    const float light = 0.35F + 0.6F * std::max(normal * osg::Vec3(-0.37F, -0.45F, 0.81F), 0.0F);
    add(a, b, c, {light, light, 0.95F * light, 1.0F});
}

osg::ref_ptr<osg::Group> outlined(const Soup& soup)
{
    const osg::ref_ptr<osg::Group> group = new osg::Group;
    for (const bool isFilled : {true, false})
    {
        const osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
        geometry->setVertexArray(soup.corners);
        const osg::ref_ptr<osg::Vec4Array> dark = new osg::Vec4Array(1);
        (*dark)[0].set(0.1F, 0.1F, 0.15F, 1.0F);
        if (isFilled)
            geometry->setColorArray(soup.colours, osg::Array::BIND_PER_VERTEX);
        else
            geometry->setColorArray(dark, osg::Array::BIND_OVERALL);
        geometry->addPrimitiveSet(
            new osg::DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(soup.corners->size())));
        osg::StateSet& state = *geometry->getOrCreateStateSet();
        state.setMode(GL_LIGHTING, osg::StateAttribute::OFF);
        if (isFilled)
            state.setAttributeAndModes(new osg::PolygonOffset(1.0F, 1.0F));
        else
            state.setAttributeAndModes(
                new osg::PolygonMode(osg::PolygonMode::FRONT_AND_BACK, osg::PolygonMode::LINE));
        group->addChild(geometry);
    }
    return group;
}

std::unique_ptr<osgOffscreen::OffscreenViewer> viewerOn(osg::Node* scene, int widthPx, int heightPx)
{
    auto made =
        osgOffscreen::OffscreenViewer::create({.widthPx = widthPx, .heightPx = heightPx, .samples = 4});
    if (!made) endWith(made.error().message());
    (*made)->viewer().setSceneData(scene);
    (*made)->camera().setClearColor({0.82F, 0.87F, 0.92F, 1.0F});
    return std::move(*made);
}

void write(const osg::Image& image, const std::filesystem::path& file,
           std::vector<std::filesystem::path>& files)
{
    files.push_back(file);
    if (!osgOffscreen::writePng(image, file)) endWith(file.string() + " cannot be written");
}

} // namespace sheet
