// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/GLExtensions>
#include <osg/GLObjects>
#include <osg/ref_ptr>

namespace osgPMObjects
{

/// One graphics context's buffer object, which goes back through the context's own deletion list, from any thread.
/// Threads: the context's draw thread, but for release().
class ContextBuffer
{
public:
    explicit ContextBuffer(unsigned int contextId) : _contextId(contextId) {}
    ~ContextBuffer() { release(); }
    ContextBuffer(const ContextBuffer&) = delete;
    ContextBuffer& operator=(const ContextBuffer&) = delete;

    bool isMade() const { return _buffer != 0; }
    /// Makes it when it is asked for first.
    GLuint name(osg::GLExtensions& gl);
    void release();

private:
    unsigned int _contextId;
    osg::ref_ptr<osg::GLObjectManager> _deletion; ///< found in the draw thread: only there may OSG make one
    GLuint _buffer = 0;
};

/// How GL wants an offset into a buffer.
inline const void* bufferOffset(std::size_t bytes)
{
    return reinterpret_cast<const void*>(bytes); // NOLINT(performance-no-int-to-ptr)
}

} // namespace osgPMObjects
