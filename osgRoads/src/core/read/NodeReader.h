// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <pugixml.hpp>

#include <osgRoads/core/geometry/Cubic.h>
#include <osgRoads/core/network/LaneType.h>

#include "ReadContext.h"

namespace osgRoads::core
{

/// Reads one element: its attributes as typed values, its children by name. A missing or wrong value becomes
/// a mistake of the context and a neutral value. When the element has been read, what nobody asked for is
/// reported as not supported.
class NodeReader
{
public:
    NodeReader(ReadContext& contextIn, pugi::xml_node nodeIn) : context(contextIn), node(nodeIn) {}
    NodeReader(const NodeReader&) = delete;
    NodeReader& operator=(const NodeReader&) = delete;

    int line() const { return context.lineOf(node); }
    bool has(const char* attribute);

    /// Returns the text of an attribute, or nothing.
    std::string text(const char* attribute);

    /// Returns the text of an attribute that must be there.
    std::string id(const char* attribute);

    /// Returns a finite number within ±1e12 that must be there.
    double number(const char* attribute);
    double numberOr(const char* attribute, double fallback);
    std::optional<double> optionalNumber(const char* attribute);
    int integer(const char* attribute, int fallback);
    bool flag(const char* attribute);

    template<class Value, std::size_t Count>
    Value choice(const char* attribute, const Keywords<Value, Count>& keywords, Value fallback)
    {
        if (!has(attribute)) return fallback;
        const std::string_view found = node.attribute(attribute).value();
        for (const auto& [word, value] : keywords)
            if (word == found) return value;
        unknownWord(attribute, found);
        return fallback;
    }

    /// Reads each child of that name with `read(NodeReader&)`.
    template<class Read>
    void each(const char* name, const Read& read)
    {
        _knownChildren.push_back(name);
        for (pugi::xml_node child = node.child(name); child; child = child.next_sibling(name))
        {
            NodeReader reader(context, child);
            read(reader);
            reader.reportRest();
        }
    }

    /// Takes note of children that are of no use to a simulation: they are no problem.
    void passOver(const char* name) { _knownChildren.push_back(name); }

    /// Reads children with a, b, c, d that begin at `startName`, in ascending order.
    CubicProfile profile(const char* name, const char* startName);

    /// Reads a, b, c, d and the start.
    Cubic cubic(const char* startName);

    void mistake(const std::string& what, const std::string& remedy)
    {
        context.mistake(line(), what, remedy);
    }

    /// Reports each attribute and child that nobody asked for.
    void reportRest();

    ReadContext& context;
    pugi::xml_node node;

private:
    void unknownWord(const char* attribute, std::string_view word);
    std::string named(const char* attribute) const;

    std::vector<const char*> _knownAttributes, _knownChildren;
};

/// Sorts elements by their start s, and tells when they were not sorted.
template<class Element>
void sortByStart(NodeReader& parent, const char* name, std::vector<Element>& elements)
{
    const auto isBefore = [](const Element& a, const Element& b) { return a.s < b.s; };
    if (std::is_sorted(elements.begin(), elements.end(), isBefore)) return;
    parent.mistake(std::string("the ") + name + " entries do not ascend", "sort them by their start");
    std::stable_sort(elements.begin(), elements.end(), isBefore);
}

/// Returns the value of '+', '-', or '0' for both directions.
char readOrientation(NodeReader& element);

} // namespace osgRoads::core
