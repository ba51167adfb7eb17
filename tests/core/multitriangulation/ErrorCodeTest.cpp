// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <osgMultiTriangulation/core/structure/ErrorCode.h>

namespace osgMultiTriangulation::core
{

namespace
{

TEST(ErrorCode, neverLowersAnErrorAndRaisesItByLittle)
{
    for (float error = 2e-5f; error < 60000.0f; error *= 1.0003f)
    {
        const float coded = errorOfCode(codeOfError(error));
        ASSERT_GE(coded, error);
        ASSERT_LE(coded, error * 1.0005f);
        ASSERT_EQ(codeOfError(coded), codeOfError(error)) << "coding twice changes it";
    }
}

TEST(ErrorCode, keepsWholeMetresAndZero)
{
    for (int metres = 0; metres <= 2048; ++metres)
        EXPECT_EQ(errorOfCode(codeOfError(static_cast<float>(metres))), static_cast<float>(metres));
    EXPECT_GT(errorOfCode(codeOfError(1e-9f)), 0.0f);
    EXPECT_EQ(codeOfError(1e9f), 0xffff);
}

} // namespace

} // namespace osgMultiTriangulation::core
