// SPDX-License-Identifier: Apache-2.0
#include <osgDB/FileNameUtils>
#include <osgDB/FileUtils>
#include <osgDB/Registry>

#include <osgTerrainROAM/BisectionDrawable>

namespace
{

/// osgDB's way to ROAM over any mesh: osgviewer sphere.bisection.
/// Errors: ReadResult::message() is the Error's line, with file, place and remedy.
class ReaderWriterBisection : public osgDB::ReaderWriter
{
public:
    ReaderWriterBisection() { supportsExtension("bisection", "ROAM over a coarse mesh of any form"); }

    const char* className() const override { return "osgTerrainROAM bisection reader"; }

    ReadResult readObject(const std::string& name, const Options* options) const override
    {
        return readNode(name, options);
    }

    ReadResult readNode(const std::string& name, const Options* options) const override
    {
        if (!acceptsExtension(osgDB::getLowerCaseFileExtension(name))) return ReadResult::FILE_NOT_HANDLED;
        const std::string file = osgDB::findDataFile(name, options);
        if (file.empty()) return ReadResult::FILE_NOT_FOUND;
        const auto node = osgTerrainROAM::openBisectionNode(file);
        if (!node) return ReadResult(node.error().message());
        return ReadResult(node->get(), ReadResult::FILE_LOADED);
    }
};

} // namespace

REGISTER_OSGPLUGIN(bisection, ReaderWriterBisection)
