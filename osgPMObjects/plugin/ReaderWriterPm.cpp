// SPDX-License-Identifier: Apache-2.0
#include <fstream>

#include <foundation/WholeFile.h>

#include <osg/Notify>
#include <osgDB/FileNameUtils>
#include <osgDB/FileUtils>
#include <osgDB/Registry>

#include <osgPMObjects/MakeProgressive>
#include <osgPMObjects/PmNode>

namespace
{

/// The osgDB plugin for progressive meshes: osgviewer model.pm, osgconv model.ac model.pm. It makes a
/// progressive object of any other node that is written. Options, as words of the option string: "quantised"
/// for vertices in 16 and 8 bits; "measured" for the measured errors of levels, where the object is made here
/// (seconds for a large model).
/// Errors: the message of the result is that of the Error, with file, what is wrong and the remedy.
class ReaderWriterPm : public osgDB::ReaderWriter
{
public:
    ReaderWriterPm()
    {
        supportsExtension("pm", "progressive mesh");
        supportsOption("quantised", "write vertices in 16 and 8 bits");
        supportsOption("measured", "measure the errors of levels, and write them");
    }

    const char* className() const override { return "osgPMObjects reader and writer"; }

    ReadResult readObject(const std::string& name, const Options* options) const override
    {
        return readNode(name, options);
    }
    ReadResult readObject(std::istream& stream, const Options* options) const override
    {
        return readNode(stream, options);
    }

    ReadResult readNode(const std::string& name, const Options* options) const override
    {
        if (!acceptsExtension(osgDB::getLowerCaseFileExtension(name))) return ReadResult::FILE_NOT_HANDLED;
        const std::string file = osgDB::findDataFile(name, options);
        if (file.empty()) return ReadResult::FILE_NOT_FOUND;
        std::ifstream stream(file, std::ios::binary);
        return read(stream, file);
    }
    ReadResult readNode(std::istream& stream, const Options*) const override
    {
        return read(stream, "stream");
    }

    WriteResult writeObject(const osg::Object& object, const std::string& name,
                            const Options* options) const override
    {
        const auto* const node = dynamic_cast<const osg::Node*>(&object);
        return node ? writeNode(*node, name, options) : WriteResult(WriteResult::FILE_NOT_HANDLED);
    }

    WriteResult writeNode(const osg::Node& node, const std::string& name,
                          const Options* options) const override
    {
        if (!acceptsExtension(osgDB::getLowerCaseFileExtension(name))) return WriteResult::FILE_NOT_HANDLED;
        const auto bytes = bytesOf(node, name, options);
        if (!bytes) return WriteResult(bytes.error().message());
        const auto written = foundation::writeWholeFile(name, *bytes);
        return written ? WriteResult(WriteResult::FILE_SAVED) : WriteResult(written.error().message());
    }

    WriteResult writeNode(const osg::Node& node, std::ostream& stream, const Options* options) const override
    {
        const auto bytes = bytesOf(node, "stream", options);
        if (!bytes) return WriteResult(bytes.error().message());
        stream.write(bytes->data(), static_cast<std::streamsize>(bytes->size()));
        return stream ? WriteResult(WriteResult::FILE_SAVED) : WriteResult("the stream cannot be written");
    }

private:
    static ReadResult read(std::istream& stream, const std::string& place)
    {
        const auto node = osgPMObjects::readPmNode(stream, place);
        if (node)
            for (const std::string& note : (*node)->getDescriptions())
                OSG_WARN << place << ": " << note << std::endl;
        return node ? ReadResult(node->get(), ReadResult::FILE_LOADED) : ReadResult(node.error().message());
    }

    static bool isGiven(const char* option, const Options* options)
    {
        return options && options->getOptionString().find(option) != std::string::npos;
    }

    static foundation::Result<std::string> bytesOf(const osg::Node& node, const std::string& name,
                                                   const Options* options)
    {
        osgPMObjects::core::PmSettings settings;
        settings.quantised = isGiven("quantised", options);
        if (const auto* const progressive = progressiveBelow(node))
            return osgPMObjects::pmNodeBytes(*progressive, settings);
        osgPMObjects::MakeProgressiveSettings making;
        if (!isGiven("measured", options)) making.ladder = std::nullopt;
        const auto made = osgPMObjects::makeProgressive(const_cast<osg::Node&>(node), name, making);
        if (!made) return made.error();
        return osgPMObjects::pmNodeBytes(*made->node, settings);
    }

    /// Returns the node itself, or the only child of groups that do nothing else.
    static const osgPMObjects::ProgressiveNode* progressiveBelow(const osg::Node& node)
    {
        if (const auto* const progressive = dynamic_cast<const osgPMObjects::ProgressiveNode*>(&node))
            return progressive;
        const osg::Group* const group = node.asGroup();
        const bool isPlain = group && !node.asTransform() && !node.getStateSet();
        return isPlain && group->getNumChildren() == 1 ? progressiveBelow(*group->getChild(0)) : nullptr;
    }
};

} // namespace

REGISTER_OSGPLUGIN(pm, ReaderWriterPm)
