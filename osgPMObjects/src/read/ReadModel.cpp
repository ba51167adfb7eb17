// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <initializer_list>
#include <optional>
#include <sstream>

#include <foundation/ReadableFile.h>
#include <foundation/WholeText.h>

#include <osg/Geometry>
#include <osg/NodeVisitor>
#include <osg/Notify>
#include <osgDB/FileNameUtils>
#include <osgDB/ReadFile>
#include <osgDB/Registry>

#include <osgPMObjects/MakeProgressive>
#include <osgPMObjects/MissingImages>
#include <osgPMObjects/PmNode>
#include <osgPMObjects/ReadModel>

#include "ContainedRun.h"
#include "CrowdedObj.h"
#include "ObjSmoothing.h"

namespace osgPMObjects
{

namespace
{

constexpr const char* kRepairModel = "repair the model, or convert it with another program";
constexpr const char* kRemedy = "check that OSG has a plugin for it (osgversion, osgconv --plugins)";

/// Keeps the first line of OSG's messages while it is installed.
class FirstWords : public osg::NotifyHandler
{
public:
    void notify(osg::NotifySeverity, const char* message) override
    {
        if (_line.empty()) _line = message;
    }

    std::string inBrackets() const
    {
        return _line.empty() ? "" : " (" + _line.substr(0, _line.find('\n')) + ")";
    }

private:
    std::string _line;
};

bool hasExtension(const std::filesystem::path& file, std::initializer_list<const char*> extensions)
{
    const std::string own = osgDB::getLowerCaseFileExtension(file.string());
    return std::any_of(extensions.begin(), extensions.end(),
                       [&](const char* extension) { return own == extension; });
}

bool isGltf(const std::filesystem::path& file)
{
    return hasExtension(file, {"gltf", "glb"});
}

/// Copies what the registry says to loaders, or makes empty options.
osg::ref_ptr<osgDB::Options> copyOfOptions()
{
    const osg::ref_ptr<osgDB::Options> usual = osgDB::Registry::instance()->getOptions();
    return usual ? usual->cloneOptions() : new osgDB::Options;
}

/// Reads a Wavefront .obj with OSG's loader. A crowded one gets no smooth normals, others those of their
/// smoothing groups.
osg::ref_ptr<osg::Node> readObj(const std::filesystem::path& file)
{
    constexpr std::uintmax_t kMostBytes = 1u << 30; // of a text that is read whole
    if (isCrowdedObj(file))
    {
        const osg::ref_ptr<osgDB::Options> options = copyOfOptions();
        options->setOptionString(options->getOptionString() + " noTriStripPolygons generateFacetNormals");
        return osgDB::readRefNodeFile(file.string(), options);
    }
    std::optional<std::string> smoothed;
    if (const auto text = foundation::readWholeText(file, kMostBytes)) smoothed = withGroupNormals(*text);
    osgDB::ReaderWriter* loader = osgDB::Registry::instance()->getReaderWriterForExtension("obj");
    if (!smoothed || !loader)
        return osgDB::readRefNodeFile(file.string(), osgDB::Registry::instance()->getOptions());
    const osg::ref_ptr<osgDB::Options> options = copyOfOptions();
    options->getDatabasePathList().push_front(file.parent_path().string()); // of materials and textures
    std::istringstream stream(*smoothed);
    return loader->readNode(stream, options).getNode();
}

/// Reads the finest level of a progressive mesh as plain geometry.
foundation::Result<osg::ref_ptr<osg::Node>> finestLevelOfPm(const std::filesystem::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    const auto node = readPmNode(stream, file.string());
    if (!node) return node.error();
    const osg::ref_ptr<osg::Group> root = new osg::Group;
    root->addChild(bakeLevel(*(*node)->shape(), 0));
    for (unsigned int i = 1; i < (*node)->getNumChildren(); ++i) // the first child is the surface
        root->addChild((*node)->getChild(i));
    root->setDescriptions((*node)->getDescriptions());
    return osg::ref_ptr<osg::Node>(root);
}

/// Prepares a graph for .osgb: finds one that is nested too deep to be written or read, and removes index
/// arrays, which .osgb would keep.
class Preparation : public osg::NodeVisitor
{
public:
    Preparation() : NodeVisitor(TRAVERSE_ALL_CHILDREN) { setNodeMaskOverride(~0u); }

    void apply(osg::Node& node) override
    {
        isTooDeep = isTooDeep || getNodePath().size() > kDeepest;
        if (!isTooDeep) traverse(node);
    }

    void apply(osg::Geometry& geometry) override
    {
        if (geometry.containsDeprecatedData()) geometry.fixDeprecatedData();
    }

    static constexpr std::size_t kDeepest = 1000;
    bool isTooDeep = false;
};

osg::ref_ptr<osgDB::ReaderWriter> osgb()
{
    return osgDB::Registry::instance()->getReaderWriterForExtension("osgb");
}

foundation::Result<std::string> readAndWrite(const std::filesystem::path& file)
{
    const auto node = readModelNodeHere(file);
    if (!node) return node.error();
    Preparation preparation;
    (*node)->accept(preparation);
    if (preparation.isTooDeep)
        return foundation::Error{file.string(),
                                 "nodes are nested deeper than " + std::to_string(Preparation::kDeepest),
                                 "look for a group that contains itself, or flatten the graph"};
    std::ostringstream stream;
    const osg::ref_ptr<osgDB::Options> options = new osgDB::Options("WriteImageHint=IncludeData");
    if (const auto written = osgb()->writeNode(**node, stream, options); !written.success())
        return foundation::Error{file.string(), "cannot be handed over: " + written.message(), kRemedy};
    return stream.str();
}

} // namespace

foundation::Result<osg::ref_ptr<osg::Node>> readModelNodeHere(const std::filesystem::path& file)
{
    if (const auto readable = foundation::checkReadable(file); !readable) return readable.error();
    if (isGltf(file))
    {
        const auto model = core::readGltf(file);
        if (!model) return model.error();
        return osg::ref_ptr<osg::Node>(nodeOf(*model));
    }
    if (hasExtension(file, {"pm"})) return finestLevelOfPm(file);
    const MissingImages missing;
    const osg::ref_ptr<osg::NotifyHandler> before = osg::getNotifyHandler();
    const osg::ref_ptr<FirstWords> words = new FirstWords;
    osg::setNotifyHandler(words);
    const osg::ref_ptr<osg::Node> node =
        hasExtension(file, {"obj"})
            ? readObj(file)
            : osgDB::readRefNodeFile(file.string(), osgDB::Registry::instance()->getOptions());
    osg::setNotifyHandler(before);
    if (node)
        for (const std::string& name : missing.names())
            node->addDescription(missingImageNote(name));
    if (node) return node;
    const bool hasPlugin = osgDB::Registry::instance()->getReaderWriterForExtension(
                               osgDB::getLowerCaseFileExtension(file.string())) != nullptr;
    return foundation::Error{file.string(), "cannot be read by OpenSceneGraph" + words->inBrackets(),
                             hasPlugin ? kRepairModel : kRemedy};
}

std::string missingImageNote(const std::string& name)
{
    return "the texture " + name + " is missing";
}

foundation::Outcome checkSettings(const ReadLimits& limits)
{
    if (!std::isfinite(limits.seconds) || limits.seconds <= 0.0)
        return foundation::Error{"ReadLimits.seconds", "it cannot be " + std::to_string(limits.seconds),
                                 "give a time above 0"};
    if (limits.memoryMiB == 0)
        return foundation::Error{"ReadLimits.memoryMiB", "it cannot be 0", "give at least 1"};
    return foundation::success();
}

foundation::Result<osg::ref_ptr<osg::Node>> readModelNode(const std::filesystem::path& file,
                                                          const ReadLimits& limits)
{
    if (const auto checked = checkSettings(limits); !checked) return checked.error();
    if (const auto readable = foundation::checkReadable(file); !readable) return readable.error();
    if (!osgb())
        return foundation::Error{"OpenSceneGraph", "has no plugin for .osgb",
                                 "install the package openscenegraph"};
    const auto bytes = runContained([&] { return readAndWrite(file); }, file.string(),
                                    isGltf(file) ? "the glTF loader" : "the loader", limits);
    if (!bytes) return bytes.error();
    std::istringstream stream(*bytes);
    osgDB::ReaderWriter::ReadResult read = osgb()->readNode(stream);
    if (!read.validNode())
        return foundation::Error{file.string(), "was not handed over whole: " + read.message(), kRemedy};
    return osg::ref_ptr<osg::Node>(read.getNode());
}

} // namespace osgPMObjects
