// SPDX-License-Identifier: Apache-2.0
#include <osg/Program>
#include <osgDB/InputStream>
#include <osgDB/ObjectWrapper>
#include <osgDB/OutputStream>

#include <osgPMObjects/ObjectShader>
#include <osgPMObjects/ProgressiveField>

#include "AddSerializers.h"
#include "SerializeLines.h"
#include "SerializeShared.h"
#include "SettingsLines.h"

namespace osgPMObjects
{

namespace
{

/// Replaces a program of this library that came from a file, whose shaders may be those of another version.
void renewShading(ProgressiveField& field)
{
    osg::StateSet& state = *field.getOrCreateStateSet();
    const osg::StateAttribute* const program = state.getAttribute(osg::StateAttribute::PROGRAM);
    if (program && program->getName() == makeObjectProgram()->getName()) addObjectShading(state);
}

bool hasContents(const ProgressiveField& field)
{
    return !field.kinds().empty();
}

bool writeContents(osgDB::OutputStream& out, const ProgressiveField& field)
{
    out.writeSize(field.kinds().size());
    out << out.BEGIN_BRACKET << std::endl;
    for (const FieldKind& kind : field.kinds())
    {
        out << out.PROPERTY("Shape");
        writeShape(out, *kind.shape);
        out << out.PROPERTY("Settings");
        writeLines(out, linesOf(kind));
    }
    std::vector<std::string> lines;
    for (const FieldInstance& instance : field.instances())
        lines.push_back(lineOf(instance));
    out << out.PROPERTY("Instances");
    writeLines(out, lines);
    out << out.END_BRACKET << std::endl;
    return true;
}

bool readKind(osgDB::InputStream& in, std::vector<FieldKind>& kinds)
{
    FieldKind kind;
    in >> in.PROPERTY("Shape");
    kind.shape = readShape(in, "ProgressiveField");
    if (!kind.shape) return false;
    in >> in.PROPERTY("Settings");
    const std::vector<std::string> lines = readLines(in);
    if (in.getException() || !passOn(in, readLines(lines, kind))) return false;
    kinds.push_back(std::move(kind));
    return true;
}

bool readContents(osgDB::InputStream& in, ProgressiveField& field)
{
    std::vector<FieldKind> kinds;
    const std::size_t count = in.readSize();
    in >> in.BEGIN_BRACKET;
    while (kinds.size() < count)
        if (in.getException() || !readKind(in, kinds)) return false;
    in >> in.PROPERTY("Instances");
    const std::vector<std::string> lines = readLines(in);
    in >> in.END_BRACKET;
    if (in.getException()) return false;
    std::vector<FieldInstance> instances;
    for (const std::string& line : lines)
    {
        const auto instance = instanceOf(line);
        if (!instance) return passOn(in, instance.error());
        instances.push_back(*instance);
    }
    return passOn(in, field.setContents(std::move(kinds), instances));
}

bool hasFieldSettings(const ProgressiveField&)
{
    return true;
}

bool writeFieldSettings(osgDB::OutputStream& out, const ProgressiveField& field)
{
    writeLines(out, linesOf(field.settings()));
    return true;
}

bool readFieldSettings(osgDB::InputStream& in, ProgressiveField& field)
{
    const std::vector<std::string> lines = readLines(in);
    if (in.getException()) return false;
    renewShading(field);
    ProgressiveFieldSettings settings;
    const foundation::Outcome read = readLines(lines, settings);
    return passOn(in, read ? field.setSettings(settings) : read);
}

} // namespace

/// A ProgressiveField in a scene file: its settings, its kinds with their shapes, which the file shares, and a line for each instance.
void addFieldSerializer(osgDB::ObjectWrapperManager& manager)
{
    addClass<ProgressiveField>(manager, "osgPMObjects::ProgressiveField",
                               "osg::Object osg::Node osgPMObjects::ProgressiveField",
                               {{"Settings", &hasFieldSettings, &readFieldSettings, &writeFieldSettings},
                                {"Contents", &hasContents, &readContents, &writeContents}});
}

} // namespace osgPMObjects
