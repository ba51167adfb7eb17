// SPDX-License-Identifier: Apache-2.0
#include <osgDB/FileNameUtils>
#include <osgDB/FileUtils>

#include <osgTraversal/NodeReader>

namespace osgTraversal
{

osgDB::ReaderWriter::ReadResult NodeReader::readNode(const std::string& name, const Options* options) const
{
    if (!acceptsExtension(osgDB::getLowerCaseFileExtension(name))) return ReadResult::FILE_NOT_HANDLED;
    const std::string file = fileToOpen(name, options);
    return file.empty() ? ReadResult(ReadResult::FILE_NOT_FOUND) : open(file, options);
}

std::string NodeReader::fileToOpen(const std::string& name, const Options* options) const
{
    return osgDB::findDataFile(name, options);
}

} // namespace osgTraversal
