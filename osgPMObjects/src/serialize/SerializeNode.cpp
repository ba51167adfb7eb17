// SPDX-License-Identifier: Apache-2.0
#include <osgDB/InputStream>
#include <osgDB/ObjectWrapper>
#include <osgDB/OutputStream>

#include <osgPMObjects/ProgressiveNode>

#include "AddSerializers.h"
#include "SettingsLines.h"

namespace osgPMObjects
{

/// A node in a scene file: its shape, which the file shares, its settings, and the children beside its drawable. The drawable is made
/// anew: what it holds belongs to views. So it is written as a Node, not as a Group with all of its children.
struct NodeSerializer
{
    static bool always(const ProgressiveNode&) { return true; }

    static bool hasShape(const ProgressiveNode& node) { return node.shape() != nullptr; }
    static bool writeShape(osgDB::OutputStream& out, const ProgressiveNode& node)
    {
        out << out.BEGIN_BRACKET << std::endl << node.shape() << out.END_BRACKET << std::endl;
        return true;
    }
    static bool readShape(osgDB::InputStream& in, ProgressiveNode& node)
    {
        in >> in.BEGIN_BRACKET;
        const osg::ref_ptr<ProgressiveShape> shape = in.readObjectOfType<ProgressiveShape>();
        if (!in.getException() && (!shape || shape->groups().empty()))
            in.throwException(
                "progressive node: its shape is missing or has no levels; write the scene again");
        if (in.getException()) return false;
        in >> in.END_BRACKET;
        node.place(new ProgressiveDrawable(shape));
        node.addChild(node._place);
        return true;
    }

    static bool writeSettings(osgDB::OutputStream& out, const ProgressiveNode& node)
    {
        const std::vector<std::string> lines = linesOf({node.selection(), node.switching(), node.number(),
                                                        node.priority(), node.referencePixelsPerTangent()});
        out.writeSize(lines.size());
        out << out.BEGIN_BRACKET << std::endl;
        for (const std::string& line : lines)
            out << line << std::endl;
        out << out.END_BRACKET << std::endl;
        return true;
    }
    static bool readSettings(osgDB::InputStream& in, ProgressiveNode& node)
    {
        std::vector<std::string> lines;
        const std::size_t count = in.readSize();
        in >> in.BEGIN_BRACKET;
        while (lines.size() < count && !in.getException())
            in >> lines.emplace_back();
        in >> in.END_BRACKET;
        if (in.getException()) return false;
        const auto settings = settingsOf(lines);
        foundation::Outcome set = settings ? node.setSelection(settings->selection) : settings.error();
        if (set) set = node.setSwitching(settings->switching);
        if (!set) in.throwException(set.error().message());
        if (!set) return false;
        node.setNumber(settings->number);
        node.setPriority(settings->priority);
        node.setReferencePixelsPerTangent(settings->referencePixelsPerTangent);
        return true;
    }

    static bool hasOthers(const ProgressiveNode& node)
    {
        return node.getNumChildren() > (hasShape(node) ? 1u : 0u);
    }
    static bool writeOthers(osgDB::OutputStream& out, const ProgressiveNode& node)
    {
        out.writeSize(node.getNumChildren() - (hasShape(node) ? 1u : 0u));
        out << out.BEGIN_BRACKET << std::endl;
        for (unsigned int i = 0; i < node.getNumChildren(); ++i)
            if (node.getChild(i) != node._place) out << node.getChild(i);
        out << out.END_BRACKET << std::endl;
        return true;
    }
    static bool readOthers(osgDB::InputStream& in, ProgressiveNode& node)
    {
        const std::size_t count = in.readSize();
        in >> in.BEGIN_BRACKET;
        for (std::size_t i = 0; i < count && !in.getException(); ++i)
        {
            const osg::ref_ptr<osg::Node> other = in.readObjectOfType<osg::Node>();
            if (other) node.addChild(other);
        }
        in >> in.END_BRACKET;
        return in.getException() == nullptr;
    }
};

namespace
{

osg::Object* makeNode()
{
    return new ProgressiveNode;
}

} // namespace

void addNodeSerializer(osgDB::ObjectWrapperManager& manager)
{
    const char* const name = "osgPMObjects::ProgressiveNode";
    if (manager.getWrapperMap().count(name) > 0) return;
    using Serializer = osgDB::UserSerializer<ProgressiveNode>;
    const osg::ref_ptr<osgDB::ObjectWrapper> wrapper =
        new osgDB::ObjectWrapper(&makeNode, name, "osg::Object osg::Node osgPMObjects::ProgressiveNode");
    const auto add = [&](Serializer* serializer)
    { wrapper->addSerializer(serializer, osgDB::BaseSerializer::RW_USER); };
    add(new Serializer("Shape", &NodeSerializer::hasShape, &NodeSerializer::readShape,
                       &NodeSerializer::writeShape));
    add(new Serializer("Settings", &NodeSerializer::always, &NodeSerializer::readSettings,
                       &NodeSerializer::writeSettings));
    add(new Serializer("OtherChildren", &NodeSerializer::hasOthers, &NodeSerializer::readOthers,
                       &NodeSerializer::writeOthers));
    manager.addWrapper(wrapper);
}

} // namespace osgPMObjects
