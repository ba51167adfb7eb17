// SPDX-License-Identifier: Apache-2.0
#include "simulation/parser/CoverageWalk.h"

#include "simulation/parser/Coverage.h"

namespace simulation
{
namespace
{

bool isEmpty(pugi::xml_node node)
{
    return !node.first_attribute() &&
           !node.find_child([](pugi::xml_node child) { return child.type() == pugi::node_element; });
}

/// Whether a parser has asked for the element or for one below it: elements that only hold others are not
/// asked for.
bool isTouched(const ParseContext& context, pugi::xml_node node)
{
    if (context.isTouched(node)) return true;
    for (pugi::xml_node child : node.children())
        if (isTouched(context, child)) return true;
    return false;
}

void reportAttributes(ParseContext& context, pugi::xml_node node)
{
    for (pugi::xml_attribute attribute : node.attributes())
    {
        const std::string_view name = attribute.name();
        const bool isForXml = name.starts_with("xml") || name.find(':') != std::string_view::npos;
        if (isForXml || context.isRead(attribute)) continue;
        context.add(
            {Problem::Kind::unsupported,
             {context.place(node),
              std::string("the attribute ") + attribute.name() + " of " + node.name() + " is not read",
              "it is passed over"}});
    }
}

} // namespace

void reportUnread(ParseContext& context, pugi::xml_node element)
{
    if (element.type() != pugi::node_element || context.isReported(element) || context.isStopped()) return;
    ++context.elements[element.name()];
    const ElementCoverage* coverage = coverageOf(element.name());
    if (coverage && coverage->support == Support::passive) return;
    const bool isPlayed = coverage && coverage->support != Support::reported;
    if (!isPlayed || (!isEmpty(element) && !isTouched(context, element)))
    {
        context.foreign(element, std::string("the element ") + element.name());
        return;
    }
    if (coverage->support == Support::approximated) context.approximated(element, *coverage);
    if (context.isTouched(element)) reportAttributes(context, element);
    for (pugi::xml_node child : element.children())
        reportUnread(context, child);
}

} // namespace simulation
