// SPDX-License-Identifier: Apache-2.0
#include <sstream>

#include <osgPMObjects/core/progressive/PmFile.h>

#include <osgPMObjects/ProgressiveShape>

#include "../pm/PmContents.h"
#include "AddSerializers.h"
#include "SerializeBytes.h"
#include "SerializeShared.h"

namespace osgPMObjects
{

/// A ProgressiveShape in a scene file: its states, as objects that the file shares, and the bytes of a `.pm`
/// file, whose sections have check sums. The shape is itself an object that the file shares.
struct ShapeSerializer
{
    static constexpr const char* kPlace = "progressive shape";

    static bool hasContents(const ProgressiveShape& shape)
    {
        return !shape.progressive().mesh.positions.empty();
    }

    /// Writes one letter for each state, y or n, which tells whether it exists; then the states that exist.
    static bool writeStates(osgDB::OutputStream& out, const ProgressiveShape& shape)
    {
        std::string exist = "s";
        for (const osg::ref_ptr<osg::StateSet>& state : shape.states())
            exist += state ? 'y' : 'n';
        out << exist << out.BEGIN_BRACKET << std::endl;
        for (const osg::ref_ptr<osg::StateSet>& state : shape.states())
            if (state) out << state.get();
        out << out.END_BRACKET << std::endl;
        return true;
    }
    static bool readStates(osgDB::InputStream& in, ProgressiveShape& shape)
    {
        std::string exist;
        in >> exist >> in.BEGIN_BRACKET;
        for (std::size_t i = 1; i < exist.size() && !in.getException(); ++i)
            shape._states.push_back(exist[i] == 'y' ? in.readObjectOfType<osg::StateSet>() : nullptr);
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
        auto contents = readPmContents(stream, kPlace, CutFiles::refused);
        std::vector<osg::ref_ptr<osg::StateSet>> states = std::move(shape._states);
        const foundation::Outcome fit =
            contents ? fitStates(states, contents->mesh, kPlace) : contents.error();
        if (!fit) in.throwException(fit.error().message());
        if (!fit) return false;
        shape.make(std::move(contents->mesh), std::move(states));
        return true;
    }
};

void addShapeSerializer()
{
    using S = ShapeSerializer;
    osgTraversal::addClass<ProgressiveShape>("osgPMObjects::ProgressiveShape",
                                             "osg::Object osgPMObjects::ProgressiveShape",
                                             {{"States", &S::hasContents, &S::readStates, &S::writeStates},
                                              {"Levels", &S::hasContents, &S::readLevels, &S::writeLevels}});
}

} // namespace osgPMObjects
