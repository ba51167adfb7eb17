// SPDX-License-Identifier: Apache-2.0
#include <osg/ContextData>

#include <osgTraversal/ContextBuffer>

namespace osgTraversal
{

namespace
{

/// The buffers of a context that its thread has to delete; OSG keeps one such list per context.
class BufferDeletion : public osg::GLObjectManager
{
public:
    explicit BufferDeletion(unsigned int contextId)
        : osg::GLObjectManager("osgTraversal::ContextBuffer", contextId)
    {
    }

    void deleteGLObject(GLuint buffer) override
    {
        if (const osg::GLExtensions* gl = osg::GLExtensions::Get(_contextID, true))
            gl->glDeleteBuffers(1, &buffer);
    }
};

} // namespace

GLuint ContextBuffer::name(osg::GLExtensions& gl)
{
    if (_buffer == 0)
    {
        if (!_deletion) _deletion = osg::get<BufferDeletion>(_contextId);
        gl.glGenBuffers(1, &_buffer);
    }
    return _buffer;
}

void ContextBuffer::release()
{
    if (_buffer != 0) _deletion->scheduleGLObjectForDeletion(_buffer);
    _buffer = 0;
}

} // namespace osgTraversal
