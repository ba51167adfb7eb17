// SPDX-License-Identifier: Apache-2.0
#include "ModelFile.h"

#include <algorithm>
#include <string>
#include <system_error>
#include <utility>

#include <osg/Notify>
#include <osgDB/FileNameUtils>
#include <osgDB/ReadFile>

#include <osgPMObjects/MissingImages>
#include <osgPMObjects/ReadModel>

namespace trainer
{

namespace
{

/// Keeps the first line of the messages of OpenSceneGraph while it is installed.
class FirstWords : public osg::NotifyHandler
{
public:
    void notify(osg::NotifySeverity, const char* message) override
    {
        if (_line.empty()) _line = message;
    }

    std::string line() const { return _line.substr(0, _line.find('\n')); }

private:
    std::string _line;
};

std::vector<std::string> notesOf(const osgPMObjects::MissingImages& missing,
                                 const std::filesystem::path& file)
{
    std::vector<std::string> notes;
    for (const std::string& name : missing.names())
        notes.push_back(foundation::Error{file.string(), osgPMObjects::missingImageNote(name),
                                          "put it beside the model; it is shown without"}
                            .message());
    return notes;
}

/// Adds what our own plugins say of a file in the descriptions of its node: what is wrong with it or left
/// out.
void addDescriptions(const osg::Node& node, const std::filesystem::path& file,
                     std::vector<std::string>& notes)
{
    const std::string suffix = osgDB::getLowerCaseFileExtension(file.string());
    if (suffix != "xodr" && suffix != "gltf" && suffix != "glb" && suffix != "pm") return;
    for (const std::string& said : node.getDescriptions())
    {
        const bool isThere =
            std::any_of(notes.begin(), notes.end(),
                        [&](const std::string& note) { return note.find(said) != std::string::npos; });
        if (!isThere) notes.push_back(said.starts_with(file.string()) ? said : file.string() + ": " + said);
    }
}

} // namespace

foundation::Result<ModelFromFile> readModel(const std::filesystem::path& file, const std::string& remedy)
{
    std::error_code ignored; // a name too long is a file that is not there
    if (!std::filesystem::exists(file, ignored))
        return foundation::Error{file.string(), "there is no such file", "check its path"};
    const osg::ref_ptr<osg::NotifyHandler> before = osg::getNotifyHandler();
    const osg::ref_ptr<FirstWords> words = new FirstWords;
    osg::setNotifyHandler(words);
    const osgPMObjects::MissingImages missing;
    osg::ref_ptr<osg::Node> node = osgDB::readRefNodeFile(file.string());
    osg::setNotifyHandler(before);
    if (node)
    {
        std::vector<std::string> notes = notesOf(missing, file);
        addDescriptions(*node, file, notes);
        return ModelFromFile{node, std::move(notes)};
    }
    const std::string reason = words->line().empty() ? "" : " (" + words->line() + ")";
    return foundation::Error{file.string(), "cannot be read by OpenSceneGraph" + reason, remedy};
}

} // namespace trainer
