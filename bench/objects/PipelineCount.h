// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include <osg/Camera>

namespace objectbench
{

/// Counts work of the frames of a camera with a pipeline statistics query.
/// Source: ARB_pipeline_statistics_query.
class PipelineCount
{
public:
    static constexpr GLenum kVertexShaderInvocations = 0x82F0;

    PipelineCount(osg::Camera& camera, GLenum counted);

    /// Counting costs time of its own.
    void setCounting(bool on) { _isCounting = on; }
    std::uint64_t counted() const { return _result; } ///< of the last counted frame

private:
    void begin(osg::RenderInfo& renderInfo);
    void end(osg::RenderInfo& renderInfo);

    GLenum _counted;
    bool _isCounting = false;
    GLuint _query = 0;
    GLuint _result = 0;
};

} // namespace objectbench
