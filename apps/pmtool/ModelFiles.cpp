// SPDX-License-Identifier: Apache-2.0
#include "pmtool/ModelFiles.h"

#include <cstdio>
#include <sstream>
#include <system_error>

#include <osgDB/Registry>

#include <viewlod/WholeFile.h>

#include <osgPMObjects/ExportNode>

namespace pmtool
{

std::string OutputNames::nameFor(const std::string& file)
{
    std::string name = std::filesystem::path(file).filename().string();
    name.resize(std::min(name.size(), name.find('.', 1)));
    const int count = ++_used[name];
    return count == 1 ? name : name + '-' + std::to_string(count);
}

viewlod::Outcome makeFolder(const std::filesystem::path& folder)
{
    std::error_code failed;
    std::filesystem::create_directories(folder, failed);
    if (!failed && std::filesystem::is_directory(folder, failed)) return viewlod::success();
    return viewlod::Error{folder.string(),
                          "cannot be made a folder" + (failed ? ": " + failed.message() : ""),
                          "name another folder"};
}

viewlod::Outcome writeModel(const osgPMObjects::ImportedModel& model, const std::filesystem::path& file)
{
    const std::string extension = file.extension().string();
    const osg::ref_ptr<osgDB::ReaderWriter> writer =
        extension.empty() ? nullptr
                          : osgDB::Registry::instance()->getReaderWriterForExtension(extension.substr(1));
    if (!writer)
        return viewlod::Error{file.string(), "OpenSceneGraph writes no such format",
                              "use .osgb, .osgt or .ive"};
    const osg::ref_ptr<osg::Group> root = osgPMObjects::exportNode(model.mesh, model.states);
    if (model.remainder->getNumChildren() > 0) root->addChild(model.remainder);
    std::string hint = "WriteImageHint=IncludeData";
    if (extension == ".osgt") hint += " Ascii";
    std::ostringstream stream;
    const osg::ref_ptr<osgDB::Options> options = new osgDB::Options(hint);
    if (const auto written = writer->writeNode(*root, stream, options); !written.success())
        return viewlod::Error{file.string(), "was not written: " + written.message(),
                              "use .osgb, .osgt or .ive"};
    return viewlod::writeWholeFile(file, stream.str());
}

viewlod::Outcome writePlain(const osgPMObjects::core::Mesh& mesh, const std::filesystem::path& file)
{
    std::string text;
    char line[96];
    for (const glm::dvec3& p : mesh.positions)
    {
        std::snprintf(line, sizeof line, "v %.17g %.17g %.17g\n", p.x, p.y, p.z);
        text += line;
    }
    for (const osgPMObjects::core::Face& face : mesh.faces)
    {
        std::snprintf(line, sizeof line, "f %u %u %u\n", mesh.positionOf(face, 0) + 1,
                      mesh.positionOf(face, 1) + 1, mesh.positionOf(face, 2) + 1);
        text += line;
    }
    return viewlod::writeWholeFile(file, text);
}

} // namespace pmtool
