// SPDX-License-Identifier: Apache-2.0
#include <osgDB/FileNameUtils>
#include <osgDB/FileUtils>
#include <osgDB/Registry>

#include <osgMultiTriangulation/OpenMultiTriangulation>
#include <osgTerrainROAM/FirstLook>

namespace
{

/// osgDB's way to multi-triangulations: osgviewer hills.mt.
/// Errors: ReadResult::message() is the Error's line, with file, place and remedy.
class ReaderWriterMt : public osgDB::ReaderWriter
{
public:
    ReaderWriterMt() { supportsExtension("mt", "multi-triangulation, as terraintool mt-build writes it"); }

    const char* className() const override { return "osgMultiTriangulation reader"; }

    ReadResult readObject(const std::string& name, const Options* options) const override
    {
        return readNode(name, options);
    }

    ReadResult readNode(const std::string& name, const Options* options) const override
    {
        if (!acceptsExtension(osgDB::getLowerCaseFileExtension(name))) return ReadResult::FILE_NOT_HANDLED;
        const std::string file = osgDB::findDataFile(name, options);
        if (file.empty()) return ReadResult::FILE_NOT_FOUND;
        const auto opened = osgMultiTriangulation::openMultiTriangulation(file);
        if (!opened) return ReadResult(opened.error().message());
        opened->terrain->addEventCallback(new osgTerrainROAM::FirstLook);
        return ReadResult(opened->terrain.get(), ReadResult::FILE_LOADED);
    }
};

} // namespace

REGISTER_OSGPLUGIN(mt, ReaderWriterMt)
