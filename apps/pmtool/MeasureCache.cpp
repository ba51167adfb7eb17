// SPDX-License-Identifier: Apache-2.0
#include "pmtool/MeasureCache.h"

#include <algorithm>

#include <osg/GLExtensions>
#include <osg/Geometry>
#include <osg/RenderInfo>
#include <osg/State>

#include <osgOffscreen/OffscreenViewer>

namespace pmtool
{

namespace
{

constexpr GLenum kVertexShaderInvocations = 0x82F0, kQueryResult = 0x8866;
constexpr std::uint32_t kMostVertices = 1024;

/// Counts vertex shader invocations while a geometry is drawn.
struct CountingCallback : osg::Drawable::DrawCallback
{
    void drawImplementation(osg::RenderInfo& renderInfo, const osg::Drawable* drawable) const override
    {
        osg::GLExtensions& gl = *renderInfo.getState()->get<osg::GLExtensions>();
        isSupported = osg::isGLExtensionOrVersionSupported(renderInfo.getState()->getContextID(),
                                                           "GL_ARB_pipeline_statistics_query", 4.6f);
        if (!isSupported) return;
        GLuint query = 0;
        gl.glGenQueries(1, &query);
        gl.glBeginQuery(kVertexShaderInvocations, query);
        drawable->drawImplementation(renderInfo);
        gl.glEndQuery(kVertexShaderInvocations);
        gl.glGetQueryObjectuiv(query, kQueryResult, &count);
        gl.glDeleteQueries(1, &query);
    }

    mutable bool isSupported = false;
    mutable GLuint count = 0;
};

/// Returns triangles of the vertices 0 … count − 1, and then the same again.
osg::ref_ptr<osg::Geometry> twice(std::uint32_t count)
{
    osg::ref_ptr<osg::Vec3Array> vertices = new osg::Vec3Array;
    for (std::uint32_t i = 0; i < count; ++i)
        vertices->push_back(osg::Vec3(static_cast<float>(i % 7), static_cast<float>(i % 5), -9.0f));
    osg::ref_ptr<osg::DrawElementsUInt> indices = new osg::DrawElementsUInt(GL_TRIANGLES);
    for (int pass = 0; pass < 2; ++pass)
        for (std::uint32_t i = 0; i < (count + 2) / 3 * 3; ++i)
            indices->push_back(std::min(i, count - 1));
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setUseDisplayList(false);
    geometry->setUseVertexBufferObjects(true);
    geometry->setCullingActive(false);
    geometry->setVertexArray(vertices);
    geometry->addPrimitiveSet(indices);
    return geometry;
}

/// Draws vertices twice; returns how many were transformed.
foundation::Result<std::uint32_t> transformsOf(osgOffscreen::OffscreenViewer& viewer, std::uint32_t count)
{
    const osg::ref_ptr<osg::Geometry> geometry = twice(count);
    const osg::ref_ptr<CountingCallback> counting = new CountingCallback;
    geometry->setDrawCallback(counting);
    viewer.viewer().setSceneData(geometry);
    viewer.picture();
    if (counting->isSupported && counting->count > 0) return counting->count;
    return foundation::Error{"OpenGL", "does not count vertex shader invocations",
                             "name the size of the cache: --fifo 16"};
}

} // namespace

foundation::Result<std::uint32_t> measureVertexCache()
{
    const auto viewer = osgOffscreen::OffscreenViewer::create({.widthPx = 16, .heightPx = 16});
    if (!viewer) return viewer.error();
    std::uint32_t held = 3, lost = kMostVertices + 1; // held: each is transformed once
    while (held + 1 < lost)
    {
        const std::uint32_t count = (held + lost) / 2;
        const auto transforms = transformsOf(**viewer, count);
        if (!transforms) return transforms.error();
        (*transforms <= count ? held : lost) = count;
    }
    return held;
}

} // namespace pmtool
