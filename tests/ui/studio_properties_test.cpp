// SPDX-License-Identifier: MIT
#include "ui/session/studio_properties.h"

#include <gtest/gtest.h>

#include <set>

#include "i18n/language.h"
#include "ui/controls/controls.h"
#include "ui/headless_gui.h"
#include "ui/panels/value_widgets.h"
#include "ui/session/values.h"

namespace versorium {
namespace {

Json otherValue(const StudioProperty& property, const Json& now) {
    if (property.kind == ValueKind::toggle) return !now.get<bool>();
    if (property.kind == ValueKind::word)
        for (const std::string& word : property.words)
            if (now != word) return word;
    return now == property.high ? property.low : property.high;
}

TEST(StudioProperties, AreDescribedInEveryLanguageAndKnowTheirOldNames) {
    std::set<std::string> paths;
    for (const StudioProperty& property : studioProperties()) {
        EXPECT_TRUE(paths.insert(property.path).second) << property.path;
        EXPECT_FALSE(property.label.empty()) << property.path;
        EXPECT_FALSE(property.help.empty()) << property.path;
        ASSERT_TRUE(setLanguage("es"));
        EXPECT_NE(tr(property.help), std::string(property.help)) << property.path;
        setLanguage("en");
        if (!property.alias.empty()) {
            EXPECT_EQ(pathOfOldName(std::string(property.alias)), property.path);
        }
    }
    EXPECT_TRUE(namesValue("random seed", "random.seed"));
    EXPECT_EQ(studioPropertyNamed("no such value"), nullptr);
}

TEST(StudioProperties, TakeAnotherValueAndRefuseWhatLiesOutside) {
    SilentHost host;
    StudioContext context(host);
    for (const StudioProperty& property : studioProperties()) {
        const Json now = property.get(context), other = otherValue(property, now);
        ASSERT_TRUE(property.set(context, other, property.path).ok()) << property.path;
        EXPECT_EQ(property.get(context), other) << property.path;
        if (property.low < property.high) {
            const Status status = property.set(context, property.high + 1, property.path);
            EXPECT_FALSE(status.ok()) << property.path;
            EXPECT_NE(status.message().find(property.path), std::string::npos) << status.message();
        }
        if (property.kind == ValueKind::word) {
            EXPECT_FALSE(property.set(context, "no such word", property.path).ok());
        }
        ASSERT_TRUE(property.set(context, now, property.path).ok()) << property.path;
    }
    setLanguage("en");
}

// The widget of the inspector and the control that a screen reader reaches are one entry.
TEST(StudioProperties, HaveOneControlForHandAndScreenReader) {
    SilentHost host;
    StudioContext context(host);
    context.newMap("shape-modulus-complex-rational");
    std::size_t found = 0;
    for (const Control& control : controlsOf(context)) {
        const StudioProperty* property = studioPropertyNamed(control.id);
        if (!property) continue;
        ++found;
        const std::optional<Control> drawn = controlOf(context, control.id);
        ASSERT_TRUE(drawn) << control.id;
        EXPECT_EQ(drawn->value, control.value) << control.id;
        EXPECT_EQ(drawn->least, control.least) << control.id;
        EXPECT_EQ(drawn->most, control.most) << control.id;
        EXPECT_EQ(drawn->options, control.options) << control.id;
    }
    EXPECT_GE(found, 20u);
    EXPECT_TRUE(setControl(context, "random seed", "7")) << "a name of older versions";
    EXPECT_EQ(context.versor.draw.seed, 7);
    EXPECT_FALSE(setControl(context, "random.seed", "-1"));
}

}  // namespace
}  // namespace versorium
