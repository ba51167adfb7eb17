// SPDX-License-Identifier: Apache-2.0
#include "pmtool/ModelFiles.h"

#include <cstdio>
#include <sstream>
#include <system_error>

#include <foundation/WholeFile.h>
#include <foundation/WritableFolder.h>

#include <osgDB/Registry>

#include <osgPMObjects/core/mesh/Wedge.h>

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

foundation::Outcome makeFolder(const std::filesystem::path& folder)
{
    if (const auto writable = foundation::checkFolderWritable(folder, "model.osgb"); !writable)
        return writable;
    std::error_code failed;
    std::filesystem::create_directories(folder, failed);
    if (!failed && std::filesystem::is_directory(folder, failed)) return foundation::success();
    return foundation::Error{folder.string(),
                             "cannot be made a folder" + (failed ? ": " + failed.message() : ""),
                             "name another folder"};
}

foundation::Outcome writeModel(const osgPMObjects::ImportedModel& model, const std::filesystem::path& file,
                               const osgPMObjects::StripMaker& strip)
{
    const std::string extension = file.extension().string();
    const osg::ref_ptr<osgDB::ReaderWriter> writer =
        extension.empty() ? nullptr
                          : osgDB::Registry::instance()->getReaderWriterForExtension(extension.substr(1));
    if (!writer)
        return foundation::Error{file.string(), "OpenSceneGraph writes no such format",
                                 "use .osgb, .osgt or .ive"};
    const osg::ref_ptr<osg::Group> root = osgPMObjects::exportNode(model.mesh, model.states, strip);
    if (model.remainder->getNumChildren() > 0) root->addChild(model.remainder);
    std::ostringstream stream;
    const osg::ref_ptr<osgDB::Options> options = new osgDB::Options("WriteImageHint=IncludeData");
    // A stream has no name, so the serializer is told the kind that it takes from a name's ending elsewhere.
    if (extension == ".osgt") options->setPluginStringData("fileType", "Ascii");
    if (const auto written = writer->writeNode(*root, stream, options); !written.success())
        return foundation::Error{file.string(), "was not written: " + written.message(),
                                 "use .osgb, .osgt or .ive"};
    return foundation::writeWholeFile(file, stream.str());
}

namespace
{

/// Puts one formatted line at the end.
template<class... Values>
void addLine(std::string& text, const char* format, Values... values)
{
    char line[128];
    const int length = std::snprintf(line, sizeof line, format, values...);
    text.append(line, static_cast<std::size_t>(length));
}

void addPositions(std::string& text, const osgPMObjects::core::Mesh& mesh)
{
    for (const glm::dvec3& p : mesh.positions)
        addLine(text, "v %.17g %.17g %.17g\n", p.x, p.y, p.z);
}

} // namespace

foundation::Outcome writePlain(const osgPMObjects::core::Mesh& mesh, const std::filesystem::path& file)
{
    std::string text;
    addPositions(text, mesh);
    for (const osgPMObjects::core::Face& face : mesh.faces)
        addLine(text, "f %u %u %u\n", mesh.positionOf(face, 0) + 1, mesh.positionOf(face, 1) + 1,
                mesh.positionOf(face, 2) + 1);
    return foundation::writeWholeFile(file, text);
}

foundation::Outcome writeTextured(const osgPMObjects::core::Mesh& mesh, const std::filesystem::path& file)
{
    std::string text;
    addPositions(text, mesh);
    for (std::uint32_t w = 0; w < mesh.wedgeCount(); ++w)
    {
        const glm::vec2 t = osgPMObjects::core::wedgeOf(mesh, w).texCoords[0];
        addLine(text, "vt %.9g %.9g\n", double(t.x), double(t.y));
    }
    std::uint32_t material = ~0u;
    for (const osgPMObjects::core::Face& face : mesh.faces)
    {
        if (face.material != material) addLine(text, "usemtl %u\n", face.material);
        material = face.material;
        addLine(text, "f %u/%u %u/%u %u/%u\n", mesh.positionOf(face, 0) + 1, face.wedges[0] + 1,
                mesh.positionOf(face, 1) + 1, face.wedges[1] + 1, mesh.positionOf(face, 2) + 1,
                face.wedges[2] + 1);
    }
    return foundation::writeWholeFile(file, text);
}

} // namespace pmtool
