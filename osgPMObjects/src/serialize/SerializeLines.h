// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace osgDB
{
class InputStream;
class OutputStream;
} // namespace osgDB

namespace osgPMObjects
{

/// Writes lines without spaces to a scene file, after their number, in brackets.
void writeLines(osgDB::OutputStream& out, const std::vector<std::string>& lines);

/// Reads what writeLines() wrote. Errors: the stream ends before; then it has an exception.
std::vector<std::string> readLines(osgDB::InputStream& in);

} // namespace osgPMObjects
