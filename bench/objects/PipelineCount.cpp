// SPDX-License-Identifier: Apache-2.0
#include "PipelineCount.h"

#include <functional>

#include <osg/GLExtensions>
#include <osg/RenderInfo>
#include <osg/State>

namespace objectbench
{

namespace
{

constexpr GLenum kQueryResult = 0x8866;

struct Callback : public osg::Camera::DrawCallback
{
    explicit Callback(std::function<void(osg::RenderInfo&)> call) : function(std::move(call)) {}
    void operator()(osg::RenderInfo& renderInfo) const override { function(renderInfo); }

    std::function<void(osg::RenderInfo&)> function;
};

} // namespace

PipelineCount::PipelineCount(osg::Camera& camera, GLenum counted) : _counted(counted)
{
    camera.setPreDrawCallback(new Callback([this](osg::RenderInfo& info) { begin(info); }));
    camera.setPostDrawCallback(new Callback([this](osg::RenderInfo& info) { end(info); }));
}

void PipelineCount::begin(osg::RenderInfo& renderInfo)
{
    if (!_isCounting) return;
    osg::GLExtensions& gl = *renderInfo.getState()->get<osg::GLExtensions>();
    if (_query == 0) gl.glGenQueries(1, &_query);
    gl.glBeginQuery(_counted, _query);
}

void PipelineCount::end(osg::RenderInfo& renderInfo)
{
    if (!_isCounting) return;
    osg::GLExtensions& gl = *renderInfo.getState()->get<osg::GLExtensions>();
    gl.glEndQuery(_counted);
    // The 64-bit function does nothing in OSMesa.
    gl.glGetQueryObjectuiv(_query, kQueryResult, &_result);
}

} // namespace objectbench
