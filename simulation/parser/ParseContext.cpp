// SPDX-License-Identifier: Apache-2.0
#include "simulation/parser/ParseContext.h"

#include <cmath>

#include <foundation/NearestWord.h>

#include "simulation/parser/Coverage.h"
#include "simulation/parser/ElementReader.h"
#include "simulation/parser/Expression.h"
#include "simulation/parser/Keywords.h"
#include "simulation/scenario/ControllerKinds.h"

namespace simulation
{
namespace
{

constexpr std::size_t kMaximumProblems = 1000;

bool satisfies(const std::string& value, Rule rule, const std::string& bound)
{
    const std::optional<double> left = parseNumber(value);
    const std::optional<double> right = parseNumber(bound);
    if (!left || !right)
    {
        if (rule == Rule::equalTo) return value == bound;
        return rule == Rule::notEqualTo && value != bound;
    }
    return holds(*left, rule, *right);
}

bool isWhole(const std::string& type)
{
    return type == "integer" || type == "int" || type == "unsignedInt" || type == "unsignedShort";
}

/// A value must be one of its type. Numbers drawn for a whole one are rounded.
void checkType(ParseContext& context, pugi::xml_node node, ParameterDeclaration& declaration, bool isGiven)
{
    const std::string& type = declaration.type;
    const std::string& value = declaration.value;
    if (value.starts_with("$")) return; // an expression that could not be computed has been told
    const std::optional<double> number = parseNumber(value);
    if (isWhole(type) && isGiven && number) declaration.value = formatNumber(std::round(*number));
    const bool isBoolean = value == "true" || value == "false" || value == "0" || value == "1";
    const bool fits = isWhole(type)        ? number && (isGiven || std::round(*number) == *number)
                      : type == "double"   ? number.has_value()
                      : type == "boolean"  ? isBoolean
                      : type == "dateTime" ? parseDateTime(value).has_value()
                                           : true;
    if (!fits)
        context.invalid(node,
                        "the value \"" + value.substr(0, 40) + "\" of the parameter " + declaration.name +
                            " is no " + type,
                        type == "boolean" ? "write true or false" : "write one, or change parameterType");
}

} // namespace

ParseContext::ParseContext(const ParseOptions& optionsIn, const XmlSource& source, CatalogShelf& shelfIn)
    : options(optionsIn), shelf(shelfIn), _source(&source), _scopes(1)
{
}

void ParseContext::foreign(pugi::xml_node node, const std::string& what)
{
    if (!_reported.insert(node.internal_object()).second) return;
    const ElementCoverage* const coverage = coverageOf(node.name());
    if (coverage && coverage->support == Support::passive) return;
    if (coverage && coverage->support == Support::reported)
        return unsupported(node, what, std::string(coverage->instead));
    if (coverage)
        return add(
            {Problem::Kind::unknown,
             {place(node), what + " does not belong in " + node.parent().name(), "it is passed over"}});
    const auto like = likeElement(node.name());
    add({Problem::Kind::unknown,
         {place(node), what + " is no element of OpenSCENARIO",
          "it is passed over" + (like ? "; did you mean " + std::string(*like) + "?" : std::string())}});
}

void ParseContext::foreignChoice(pugi::xml_node node, const std::string& what)
{
    constexpr std::size_t kSlip = 2;
    const auto like = coverageOf(node.name()) ? std::nullopt : likeElement(node.name());
    if (!like || foundation::wordDistance(node.name(), *like) > kSlip) return foreign(node, what);
    if (_reported.insert(node.internal_object()).second)
        invalid(node, what + " is no element of OpenSCENARIO", "did you mean " + std::string(*like) + "?");
}

void ParseContext::unsupported(pugi::xml_node node, const std::string& what, const std::string& instead)
{
    add({Problem::Kind::unsupported, {place(node), what + " is not supported", "instead: " + instead}});
}

void ParseContext::approximated(pugi::xml_node node, const ElementCoverage& coverage)
{
    if (!options.tolerant || !_approximated.insert(coverage.name).second) return;
    add({Problem::Kind::approximated,
         {place(node), "the element " + std::string(coverage.name) + " is approximated",
          "instead: " + std::string(coverage.instead)}});
}

void ParseContext::controllerNotPlayed(pugi::xml_node node, const std::string& kind)
{
    if (!options.tolerant) return;
    add({Problem::Kind::approximated,
         {place(node), "the controller " + kind + " is not played",
          "instead: the actions of the scenario move the entity; controllers that are played: " +
              controllerNames()}});
}

void ParseContext::assumed(pugi::xml_node node, const std::string& what, const std::string& instead)
{
    add({Problem::Kind::assumed, {place(node), what, "instead: " + instead}});
}

void ParseContext::invalid(pugi::xml_node node, const std::string& what, const std::string& remedy)
{
    add({Problem::Kind::invalid, {place(node), what, remedy}});
}

void ParseContext::add(Problem problem)
{
    if (!isStopped() && problems.size() < kMaximumProblems) problems.push_back(std::move(problem));
}

void ParseContext::tellNote(const XmlSource& source)
{
    if (source.note().empty()) return;
    add({Problem::Kind::assumed,
         {source.name() + ":" + std::to_string(source.noteLine()), source.note(),
          "name the encoding in the first line, or save it as UTF-8"}});
}

std::string ParseContext::place(pugi::xml_node node) const
{
    return _source->name() + ":" + std::to_string(_source->lineOf(node));
}

std::optional<std::string> ParseContext::lookup(std::string_view name) const
{
    for (auto scope = _scopes.rbegin(); scope != _scopes.rend(); ++scope)
        if (const auto found = scope->find(name); found != scope->end()) return found->second;
    return std::nullopt;
}

std::vector<ParameterDeclaration> ParseContext::declareParameters(pugi::xml_node parent, const Scope& given)
{
    std::vector<ParameterDeclaration> declarations;
    for (pugi::xml_node node : parent.child("ParameterDeclarations").children("ParameterDeclaration"))
    {
        ElementReader reader(*this, node);
        reader.allowChildren({"ConstraintGroup"});
        std::string name = node.attribute("name").value(); // with or without $: not a value
        if (!reader.has("name")) reader.text("name");      // tells that it is missing
        if (!name.empty() && name.front() == '$') name.erase(0, 1);
        ParameterDeclaration declaration{line(node), std::move(name), reader.text("parameterType"), ""};
        const auto replaced = given.find(declaration.name);
        const std::string own = reader.text("value");
        declaration.value = replaced == given.end() ? own : replaced->second;
        checkType(*this, node, declaration, replaced != given.end());
        checkConstraints(node, declaration.value);
        if (_scopes.back().contains(declaration.name))
            invalid(node, "the parameter " + declaration.name + " stands twice", "rename one");
        _scopes.back()[declaration.name] = declaration.value;
        declarations.push_back(std::move(declaration));
    }
    return declarations;
}

/// A value must meet every constraint of at least one group.
void ParseContext::checkConstraints(pugi::xml_node declaration, const std::string& value)
{
    bool anyGroup = false, anyHolds = false;
    for (pugi::xml_node group : declaration.children("ConstraintGroup"))
    {
        anyGroup = true;
        bool all = true;
        touch(group);
        for (pugi::xml_node node : group.children("ValueConstraint"))
        {
            ElementReader reader(*this, node);
            const Rule rule = reader.choice("rule", kRules);
            all = satisfies(value, rule, reader.text("value")) && all;
        }
        anyHolds = anyHolds || all;
    }
    if (anyGroup && !anyHolds)
        invalid(declaration, "the value " + value + " breaks the parameter's constraints", "change it");
}

} // namespace simulation
