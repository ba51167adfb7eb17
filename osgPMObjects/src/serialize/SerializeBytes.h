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

/// Writes bytes to a scene file in pieces, each after its size: unchanged in a binary file, as hexadecimal
/// digits in a text.
void writeBytes(osgDB::OutputStream& out, const std::string& bytes);

/// Reads what writeBytes() wrote. Errors: a piece is shorter than its size says, or has characters that are
/// no digits; then the stream has an exception, and the result must not be used. Memory: at most that of the
/// stream, also for a damaged one.
std::string readBytes(osgDB::InputStream& in);

} // namespace osgPMObjects
