// SPDX-License-Identifier: Apache-2.0
#include "ReadContext.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace osgRoads::core
{

void ReadContext::mistake(int line, const std::string& what, const std::string& remedy)
{
    if (_mistakes.size() == ReadNetwork::kMostMistakes)
    {
        ++_notListed;
        return;
    }
    _mistakes.push_back(
        {ProblemKind::mistake, line, 1, subject.empty() ? what : subject + ": " + what, remedy});
}

void ReadContext::unsupported(pugi::xml_node node, const std::string& name)
{
    const auto [found, isNew] = _unsupportedIndex.emplace(name, _unsupported.size());
    if (!isNew)
        ++_unsupported[found->second].count;
    else
        _unsupported.push_back(
            {ProblemKind::unsupported, lineOf(node), 1, name + " is not supported", "it is passed over"});
}

void ReadContext::moveTo(ReadNetwork& result)
{
    result.problems = std::move(_mistakes);
    std::move(_unsupported.begin(), _unsupported.end(), std::back_inserter(result.problems));
    std::stable_sort(result.problems.begin(), result.problems.end(),
                     [](const Problem& a, const Problem& b) { return a.line < b.line; });
    result.mistakesNotListed = _notListed;
}

} // namespace osgRoads::core
