// SPDX-License-Identifier: Apache-2.0
// docs/reference/view-file.md against the names that the reader's source allows: allow(node, {attributes},
// {elements}).
#include <cctype>

#include <gmock/gmock.h>

#include "SourceNames.h"

namespace
{

using reference::differences;
using reference::Names;
using reference::Page;

struct Allowed
{
    Names elements{"View"}, attributes;
};

Allowed allowed()
{
    Allowed allowed;
    const std::string source = reference::sourceText("osgSession/view/ViewFile.cpp");
    for (const auto& literals : reference::literalsOfCalls(source, "allow"))
        for (const std::string& name : literals)
            (std::isupper(static_cast<unsigned char>(name.front())) ? allowed.elements : allowed.attributes)
                .insert(name);
    return allowed;
}

TEST(ViewReference, DescribesEveryElementAndAttributeAndNoOther)
{
    const Page page = Page::read("view-file.md");
    const Allowed code = allowed();
    EXPECT_THAT(code.attributes, testing::Contains("fovXDeg"));
    EXPECT_EQ(differences(code.elements, page.column("Elements", 0)), "");
    EXPECT_EQ(differences(code.attributes, page.column("Attributes", 0)), "");
    EXPECT_NE(differences(code.attributes, page.without("rollDeg").column("Attributes", 0)), "");
    EXPECT_NE(differences(code.elements, page.with("Elements", "Invented").column("Elements", 0)), "");
}

} // namespace
