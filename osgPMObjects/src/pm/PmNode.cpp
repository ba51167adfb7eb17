// SPDX-License-Identifier: Apache-2.0
#include <sstream>

#include <osg/Group>
#include <osgDB/Registry>

#include <osgPMObjects/PmNode>

#include "../settings/ErrorPlace.h"
#include "PmContents.h"
#include "StateImages.h"

namespace osgPMObjects
{

namespace
{

constexpr const char* kFormat = "osgb";

osg::ref_ptr<osgDB::ReaderWriter> format()
{
    return osgDB::Registry::instance()->getReaderWriterForExtension(kFormat);
}

/// Makes a group whose first child has one child for each state, and whose other children are `others`.
osg::ref_ptr<osg::Group> attachedGroup(const std::vector<osg::ref_ptr<osg::StateSet>>& states,
                                       const std::vector<osg::ref_ptr<osg::Node>>& others)
{
    const osg::ref_ptr<osg::Group> root = new osg::Group, holders = new osg::Group;
    for (const osg::ref_ptr<osg::StateSet>& state : states)
    {
        const osg::ref_ptr<osg::Node> holder = new osg::Node;
        holder->setStateSet(state);
        holders->addChild(holder);
    }
    root->addChild(holders);
    for (const osg::ref_ptr<osg::Node>& other : others)
        root->addChild(other);
    return root;
}

/// The content of a file besides its mesh.
struct Attached
{
    std::vector<osg::ref_ptr<osg::StateSet>> states;
    std::vector<osg::ref_ptr<osg::Node>> others;
};

foundation::Result<Attached> readAttached(const std::string& bytes, const std::string& place)
{
    if (bytes.empty()) return Attached{};
    const auto damaged = [&](const std::string& why) {
        return foundation::Error{place, "has states that cannot be read" + why, "build the file again"};
    };
    const osg::ref_ptr<osgDB::ReaderWriter> reader = format();
    if (!reader) return damaged(": OpenSceneGraph's plugin for .osgb is not installed");
    std::istringstream stream(bytes);
    osgDB::ReaderWriter::ReadResult read = reader->readNode(stream, nullptr);
    osg::Group* const root = read.getNode() ? read.getNode()->asGroup() : nullptr;
    osg::Group* const holders = root && root->getNumChildren() > 0 ? root->getChild(0)->asGroup() : nullptr;
    if (!holders) return damaged(read.message().empty() ? "" : ": " + read.message());
    Attached attached;
    for (unsigned int i = 0; i < holders->getNumChildren(); ++i)
        attached.states.push_back(holders->getChild(i)->getStateSet());
    for (unsigned int i = 1; i < root->getNumChildren(); ++i)
        attached.others.push_back(root->getChild(i));
    return attached;
}

/// Says what of a file is not shown; empty where that is nothing.
std::string noteOf(const PmContents& contents, std::size_t missingImages)
{
    const std::uint32_t steps = contents.mesh.stepCount;
    std::string note;
    if (contents.isCutOff)
        note = "the file is cut off: shown without the finest " + std::to_string(contents.missingSteps) +
               " of " + std::to_string(steps + contents.missingSteps) + " steps";
    if (missingImages == 0) return note;
    return note + (note.empty() ? "shown without " : " and without ") + std::to_string(missingImages) +
           (missingImages == 1 ? " image" : " images");
}

} // namespace

foundation::Outcome attachToPm(core::PmSettings& settings,
                               const std::vector<osg::ref_ptr<osg::StateSet>>& states,
                               const std::vector<osg::ref_ptr<osg::Node>>& others,
                               const std::filesystem::path& folder)
{
    const osg::ref_ptr<osgDB::ReaderWriter> writer = format();
    if (!writer)
        return foundation::Error{"states", "cannot be written: OpenSceneGraph's plugin for .osgb is missing",
                                 "install openscenegraph"};
    const osg::ref_ptr<osgDB::Options> options =
        new osgDB::Options("WriteImageHint=IncludeData Compressor=zlib");
    SeparatedStates own = separated(states, folder);
    std::ostringstream stream;
    const auto written = writer->writeNode(*attachedGroup(own.states, others), stream, options);
    if (!written.success())
        return foundation::Error{"states", "cannot be written: " + written.message(),
                                 "look at the model's states"};
    settings.attachment = stream.str();
    settings.images = std::move(own.images);
    return foundation::success();
}

foundation::Result<std::string> pmNodeBytes(const ProgressiveNode& node, core::PmSettings settings)
{
    const ProgressiveShape* const shape = node.shape();
    if (!shape)
        return foundation::Error{"ProgressiveNode.shape", "there is none", "give a node that is not empty"};
    if (const auto checked = at("PmSettings", core::checkSettings(settings)); !checked)
        return checked.error();
    std::vector<osg::ref_ptr<osg::Node>> others;
    for (unsigned int i = 1; i < node.getNumChildren(); ++i) // the first child is the surface
        others.push_back(const_cast<osg::Node*>(node.getChild(i)));
    if (const auto attached = attachToPm(settings, shape->states(), others); !attached)
        return attached.error();
    return core::pmBytes(shape->progressive(), settings);
}

foundation::Result<osg::ref_ptr<ProgressiveNode>> readPmNode(std::istream& stream, const std::string& place)
{
    auto contents = readPmContents(stream, place, CutFiles::accepted);
    if (!contents) return contents.error();
    auto attached = readAttached(contents->attachment, place);
    if (!attached) return attached.error();
    const foundation::Outcome fit = fitStates(attached->states, contents->mesh, place);
    if (!fit) return fit.error();
    const std::size_t missingImages = putBack(contents->images, attached->states);
    const std::string note = noteOf(*contents, missingImages);
    const osg::ref_ptr<ProgressiveNode> node =
        new ProgressiveNode(new ProgressiveShape(std::move(contents->mesh), std::move(attached->states)));
    for (const osg::ref_ptr<osg::Node>& other : attached->others)
        node->addChild(other);
    if (!note.empty()) node->addDescription(note);
    return node;
}

} // namespace osgPMObjects
