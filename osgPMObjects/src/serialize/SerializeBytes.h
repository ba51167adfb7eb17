// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace osgDB
{
class InputStream;
class OutputStream;
} // namespace osgDB

namespace osgPMObjects
{

/// Bytes in a scene file, in pieces after their sizes: as they are in a binary one, as hexadecimal digits in a text.
void writeBytes(osgDB::OutputStream& out, const std::string& bytes);

/// Errors: the pieces are not as long as they are said to be, or no digits; then the stream has an exception, and what is
/// returned is of no use. Memory: no more than what the stream holds, whatever a damaged one says.
std::string readBytes(osgDB::InputStream& in);

} // namespace osgPMObjects
