// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include <osg/Camera>

namespace objectbench
{

/// Counts the vertex shader's invocations of a camera's frames by a pipeline statistics query.
/// Source: ARB_pipeline_statistics_query, GL_VERTEX_SHADER_INVOCATIONS.
class VertexCount
{
public:
    explicit VertexCount(osg::Camera& camera);

    /// Counting costs time of its own.
    void setCounting(bool on) { _isCounting = on; }
    std::uint64_t invocations() const { return _invocations; } ///< of the last counted frame

private:
    void begin(osg::RenderInfo& renderInfo);
    void end(osg::RenderInfo& renderInfo);

    bool _isCounting = false;
    GLuint _query = 0;
    GLuint _invocations = 0;
};

} // namespace objectbench
