// SPDX-License-Identifier: MIT
#include "base/json.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace versorium {
namespace {

std::string faultOf(std::string_view text) {
    const Expected<Json> parsed = parseJson(text);
    return parsed.ok() ? "" : parsed.status().message();
}

TEST(Json, RefusesWhatIsHostile) {
    EXPECT_NE(faultOf(R"({"a": 1, "b": {"c": 1, "c": 2}})").find("b.c: the key stands twice"),
              std::string::npos);
    EXPECT_NE(faultOf(std::string(1000000, '[')).find("levels deep"), std::string::npos);
    EXPECT_NE(faultOf(R"({"a": 1e999})"), "");
    EXPECT_NE(faultOf(R"({"a": NaN})").find("line 1, column"), std::string::npos);
    EXPECT_NE(faultOf(""), "");
    // Keys are looked for one by one: without a limit this one would take minutes.
    std::string keys = "{";
    for (int i = 0; i < 300000; ++i) keys += "\"k" + std::to_string(i) + "\": 0,";
    EXPECT_NE(faultOf(keys).find("keys in one object"), std::string::npos);
    EXPECT_NE(faultOf("{} x"), "");
}

TEST(Json, PrintsWhatItReads) {
    const std::string text =
        "{\n  \"a\": [1, 2.5, -1e-07],\n  \"b\": {\n    \"c\": \"\\\"\"\n  }\n}\n";
    const Expected<Json> parsed = parseJson(text);
    ASSERT_TRUE(parsed.ok());
    EXPECT_EQ(printJson(*parsed), text);
}

TEST(FormatNumber, ReadsBackExactly) {
    for (double value : {0.1, 1.0 / 3.0, 1e300, 5e-324, -0.0, 123456789.125})
        EXPECT_EQ(std::strtod(formatNumber(value).c_str(), nullptr), value);
    EXPECT_EQ(formatNumber(0.1), "0.1");
    EXPECT_EQ(formatNumber(std::numeric_limits<double>::quiet_NaN()), "nan");
}

TEST(ObjectReader, NamesThePathOfAFault) {
    const Json json = *parseJson(R"({"n": 5, "list": [1, 2], "extra": true})");
    int n = 0;
    std::vector<double> list;
    ObjectReader reader(json, "scene");
    reader.integer("n", n, 0, 10).numbers("list", list, 2, 2);
    EXPECT_EQ(n, 5);
    EXPECT_EQ(list.size(), 2u);
    EXPECT_EQ(reader.finish().message(), "scene.extra: unknown key; known here: list, n");

    ObjectReader strict(json, "scene");
    strict.integer("n", n, 0, 4);
    EXPECT_EQ(strict.finish().message(), "scene.n: 5 is out of range: 0 to 4");
}

}  // namespace
}  // namespace versorium
