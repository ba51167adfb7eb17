// SPDX-License-Identifier: Apache-2.0
#include <sstream>

#include <osgDB/InputStream>
#include <osgDB/ObjectWrapper>
#include <osgDB/OutputStream>

#include <osgPMObjects/core/progressive/PmFile.h>

#include <osgPMObjects/ProgressiveShape>

#include "../pm/PmContents.h"
#include "AddSerializers.h"
#include "SerializeBytes.h"

namespace osgPMObjects
{

/// A shape in a scene file: its states as objects of the file, which shares them, and the bytes of a `.pm` file, whose sections have
/// check sums. As a whole it is an object of the file, too, which has it once.
struct ShapeSerializer
{
    static constexpr const char* kPlace = "progressive shape";

    static bool hasContents(const ProgressiveShape& shape)
    {
        return !shape.progressive().mesh.positions.empty();
    }

    /// A letter a state: whether it is there. Then those that are.
    static bool writeStates(osgDB::OutputStream& out, const ProgressiveShape& shape)
    {
        std::string areThere = "s";
        for (const osg::ref_ptr<osg::StateSet>& state : shape.states())
            areThere += state ? 'y' : 'n';
        out << areThere << out.BEGIN_BRACKET << std::endl;
        for (const osg::ref_ptr<osg::StateSet>& state : shape.states())
            if (state) out << state.get();
        out << out.END_BRACKET << std::endl;
        return true;
    }
    static bool readStates(osgDB::InputStream& in, ProgressiveShape& shape)
    {
        std::string areThere;
        in >> areThere >> in.BEGIN_BRACKET;
        for (std::size_t i = 1; i < areThere.size() && !in.getException(); ++i)
            shape._states.push_back(areThere[i] == 'y' ? in.readObjectOfType<osg::StateSet>() : nullptr);
        in >> in.END_BRACKET;
        return in.getException() == nullptr;
    }

    static bool writeLevels(osgDB::OutputStream& out, const ProgressiveShape& shape)
    {
        writeBytes(out, core::pmBytes(shape.progressive()));
        return true;
    }
    static bool readLevels(osgDB::InputStream& in, ProgressiveShape& shape)
    {
        const std::string bytes = readBytes(in);
        if (in.getException()) return false;
        std::istringstream stream(bytes);
        auto contents = readPmContents(stream, kPlace);
        std::vector<osg::ref_ptr<osg::StateSet>> states = std::move(shape._states);
        const foundation::Outcome fit =
            contents ? fitStates(states, contents->mesh, kPlace) : contents.error();
        if (!fit) in.throwException(fit.error().message());
        if (!fit) return false;
        shape.make(std::move(contents->mesh), std::move(states));
        return true;
    }
};

namespace
{

osg::Object* makeShape()
{
    return new ProgressiveShape;
}

} // namespace

void addShapeSerializer(osgDB::ObjectWrapperManager& manager)
{
    const char* const name = "osgPMObjects::ProgressiveShape";
    if (manager.getWrapperMap().count(name) > 0) return;
    const osg::ref_ptr<osgDB::ObjectWrapper> wrapper =
        new osgDB::ObjectWrapper(&makeShape, name, "osg::Object osgPMObjects::ProgressiveShape");
    using Serializer = osgDB::UserSerializer<ProgressiveShape>;
    wrapper->addSerializer(new Serializer("States", &ShapeSerializer::hasContents,
                                          &ShapeSerializer::readStates, &ShapeSerializer::writeStates),
                           osgDB::BaseSerializer::RW_USER);
    wrapper->addSerializer(new Serializer("Levels", &ShapeSerializer::hasContents,
                                          &ShapeSerializer::readLevels, &ShapeSerializer::writeLevels),
                           osgDB::BaseSerializer::RW_USER);
    manager.addWrapper(wrapper);
}

} // namespace osgPMObjects
