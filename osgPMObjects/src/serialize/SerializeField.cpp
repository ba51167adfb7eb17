// SPDX-License-Identifier: Apache-2.0
#include <osg/Program>

#include <osgPMObjects/ObjectShader>
#include <osgPMObjects/ProgressiveField>

#include "AddSerializers.h"
#include "SerializeShared.h"
#include "SettingsFields.h"

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

constexpr const char* kInstanceName = "instance";

/// An instance as one line, "instance=…".
std::string lineOf(const FieldInstance& instance)
{
    osgTraversal::LineWriter writer;
    writer(kInstanceName, instance);
    return writer.lines.front();
}

foundation::Result<FieldInstance> instanceOf(const std::string& line)
{
    FieldInstance instance;
    osgTraversal::LineReader reader({line});
    reader(kInstanceName, instance);
    if (const std::string complaint = reader.complaint(); !complaint.empty())
        return foundation::Error{"instance in a scene file", complaint,
                                 "correct the line, or write the scene again"};
    return instance;
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
        osgTraversal::writeLines(out, osgTraversal::linesOf(kind));
    }
    std::vector<std::string> lines;
    for (const FieldInstance& instance : field.instances())
        lines.push_back(lineOf(instance));
    out << out.PROPERTY("Instances");
    osgTraversal::writeLines(out, lines);
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
    const bool isGood = osgTraversal::readSettings<FieldKind>(in,
                                                              [&](FieldKind read)
                                                              {
                                                                  read.shape = kind.shape;
                                                                  kind = std::move(read);
                                                                  return foundation::success();
                                                              });
    if (!isGood) return false;
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
    const std::vector<std::string> lines = osgTraversal::readLines(in);
    in >> in.END_BRACKET;
    if (in.getException()) return false;
    std::vector<FieldInstance> instances;
    for (const std::string& line : lines)
    {
        const auto instance = instanceOf(line);
        if (!instance) return osgTraversal::passOn(in, instance.error());
        instances.push_back(*instance);
    }
    return osgTraversal::passOn(in, field.setContents(std::move(kinds), std::move(instances)));
}

bool writeFieldSettings(osgDB::OutputStream& out, const ProgressiveField& field)
{
    osgTraversal::writeLines(out, osgTraversal::linesOf(field.settings()));
    return true;
}

bool readFieldSettings(osgDB::InputStream& in, ProgressiveField& field)
{
    renewShading(field);
    return osgTraversal::readSettings<ProgressiveFieldSettings>(
        in, [&](const ProgressiveFieldSettings& settings) { return field.setSettings(settings); });
}

} // namespace

/// A ProgressiveField in a scene file: its settings, its kinds with their shapes, which the file shares, and
/// a line for each instance.
void addFieldSerializer()
{
    osgTraversal::addClass<ProgressiveField>("osgPMObjects::ProgressiveField",
                                             "osg::Object osg::Node osgPMObjects::ProgressiveField",
                                             {{"Settings", &osgTraversal::isAlwaysThere<ProgressiveField>,
                                               &readFieldSettings, &writeFieldSettings},
                                              {"Contents", &hasContents, &readContents, &writeContents}});
}

} // namespace osgPMObjects
