// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <unordered_map>

#include <foundation/XmlSource.h>

#include <osgRoads/core/read/ReadNetwork.h>

namespace osgRoads::core
{

/// Collects the problems of one reading. What is not supported is told once, with its count.
class ReadContext
{
public:
    explicit ReadContext(const foundation::XmlSource& source) : _source(source) {}

    int lineOf(pugi::xml_node node) const { return _source.lineOf(node); }

    /// `what` follows the subject: "road 7: …".
    void mistake(int line, const std::string& what, const std::string& remedy);

    /// `name`: the element, or element@attribute.
    void unsupported(pugi::xml_node node, const std::string& name);

    /// Moves the problems to the result, by line.
    void moveTo(ReadNetwork& result);

    std::string subject; ///< what is being read: "road 7", or empty

private:
    const foundation::XmlSource& _source;
    std::vector<Problem> _mistakes, _unsupported;
    std::unordered_map<std::string, std::size_t> _unsupportedIndex;
    std::size_t _notListed = 0;
};

} // namespace osgRoads::core
