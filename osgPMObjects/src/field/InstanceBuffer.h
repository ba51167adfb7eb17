// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <span>

#include <osg/State>

#include <osgPMObjects/core/field/FieldDrawList.h>

#include <osgTraversal/ContextBuffer>

namespace osgPMObjects
{

/// The instances of the picture that a view group's camera draws, in each graphics context: written anew for
/// every picture, as the eye, from which places are given, has moved by then.
/// Threads: the contexts' draw threads.
class InstanceBuffer
{
public:
    /// Makes the instances of a picture the buffer's, unless they are already, and binds it. `serial`: of the
    /// picture, above 0.
    void use(osg::State& state, std::uint64_t serial, std::span<const core::InstanceAttributes> instances);

    /// Lets the attributes of ObjectShader come from the instances from `first` on. `isSwitching`: what they
    /// show, too.
    static void pointTo(osg::GLExtensions& gl, std::uint32_t first, bool isSwitching);
    static void end(osg::GLExtensions& gl);

    void releaseGLObjects(osg::State* state);

private:
    struct Copy
    {
        explicit Copy(unsigned int contextId) : buffer(contextId) {}
        osgTraversal::ContextBuffer buffer;
        std::uint64_t serial = 0;
    };

    std::mutex _mutex; ///< guards the map; each copy belongs to its draw thread
    std::map<unsigned int, std::unique_ptr<Copy>> _copies;
};

} // namespace osgPMObjects
