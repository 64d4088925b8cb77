// SPDX-License-Identifier: MIT
#include "i18n/language.h"

#include <gtest/gtest.h>

#include "base/embedded.h"
#include "base/json.h"

namespace versorium {
namespace {

// The language is the process's own: each test leaves it as it was.
struct Speaking {
    explicit Speaking(const char* id) { EXPECT_TRUE(setLanguage(id)); }
    ~Speaking() { setLanguage("en"); }
};

TEST(Language, EnglishIsWhatTheSourcesSay) {
    EXPECT_EQ(languageNow().id, "en");
    const char* text = "Undo";
    EXPECT_EQ(tr(text), text);
    EXPECT_EQ(tr("Key frame {1} at {2} s", {"3", "1.5"}), "Key frame 3 at 1.5 s");
    EXPECT_EQ(trMessage("Key frame 3 at 1.5 s"), "Key frame 3 at 1.5 s");
}

TEST(Language, ThereIsNoOtherThanThoseListed) {
    EXPECT_EQ(languages()[0].id, "en");
    for (const Language& language : languages()) EXPECT_TRUE(setLanguage(language.id));
    EXPECT_FALSE(setLanguage("tlh"));
    EXPECT_FALSE(setLanguage(""));
    EXPECT_EQ(languageNow().id, languages().back().id) << "a refused one changes nothing";
    setLanguage("en");
}

TEST(Language, WordsOfOneAreSaidWhateverTheInterfaceSpeaks) {
    const Words spanish("es"), unknown("tlh");
    EXPECT_EQ(languageNow().id, "en");
    EXPECT_EQ(spanish.language().id, "es");
    EXPECT_EQ(spanish.tr("Undo"), "Deshacer");
    EXPECT_EQ(spanish.tr("period {1}", {"3"}), "período 3");
    EXPECT_EQ(spanish.message("line 7: a step has one ask at most"),
              "línea 7: un paso tiene como mucho un ask");
    EXPECT_EQ(spanish.number("-0.5"), "-0,5");
    EXPECT_EQ(unknown.language().id, "en");
    EXPECT_EQ(unknown.tr("Undo"), "Undo");
    EXPECT_EQ(tr("Undo"), std::string("Undo"));
}

TEST(Language, IsFoundByTheSystemsName) {
    for (const char* name : {"es", "es_MX.UTF-8", "es-419", "es@euro"})
        EXPECT_EQ(languageOf(name), "es") << name;
    for (const char* name : {"", "C", "POSIX", "en_GB.UTF-8", "de_DE", "est"})
        EXPECT_EQ(languageOf(name), "en") << name;
}

TEST(Language, EveryEntryOfEveryFileIsSaid) {
    for (const Language& language : languages()) {
        if (language.id == "en") continue;
        const Expected<Json> json = parseJson(embeddedText("i18n/" + language.id + ".json"));
        ASSERT_TRUE(json) << json.status().message();
        Speaking speaking(language.id.c_str());
        for (const auto& [english, other] : json->items())
            EXPECT_EQ(tr(english.c_str()), other.get<std::string>());
    }
}

TEST(Language, PlacesTakeTheirValuesWhereverTheyStand) {
    Speaking speaking("es");
    EXPECT_STREQ(tr("Undo"), "Deshacer");
    EXPECT_STREQ(tr("no entry has this text"), "no entry has this text");
    EXPECT_EQ(tr("Key frame {1} at {2} s", {"3", "1,5"}), "Fotograma clave 3 en 1,5 s");
    EXPECT_EQ(tr("{1} but {2}", {"a {2}", "b"}), "a {2} but b") << "values are no sentences";
    EXPECT_EQ(tr("{1} and {3}", {"a"}), "a and {3}") << "a place without a value stays";
}

TEST(Language, MessagesThatWerePutTogetherElsewhereAreSaid) {
    Speaking speaking("es");
    EXPECT_EQ(trMessage("This map has no roots"), "Esta aplicación no tiene raíces");
    EXPECT_EQ(trMessage("Key frame 3 at 1.5 s"), "Fotograma clave 3 en 1.5 s");
    EXPECT_EQ(trMessage("a.json: This map has no roots"),
              "a.json: Esta aplicación no tiene raíces");
    EXPECT_EQ(trMessage("none of these words"), "none of these words");
    EXPECT_EQ(trMessage(""), "");
    // But names are names.
    EXPECT_EQ(trMessage("no palette is called \"fire\"; there are: dusk, gold"),
              "ninguna paleta se llama «fire»; hay: dusk, gold");
    // However long and repetitive, as foreign files may make them, it takes a moment.
    std::string foreign;
    for (int k = 0; k < 3000; ++k) foreign += "a from b to c: ";
    EXPECT_FALSE(trMessage(foreign + "5 roots").empty());
    // What stands in a place is a message as well.
    EXPECT_EQ(trMessage("Exported: the clipboard"), "Exportado: el portapapeles");
}

TEST(Language, NumbersHaveItsDecimalSign) {
    EXPECT_EQ(shownNumber(-0.5), "-0.5");
    EXPECT_STREQ(numberSeparator(), ", ");
    Speaking speaking("es");
    EXPECT_EQ(shownNumber(-0.5), "-0,5");
    EXPECT_EQ(shownNumber(1234.56789, 6), "1234,57");
    EXPECT_EQ(shownNumber(3), "3");
    EXPECT_STREQ(numberSeparator(), "; ");
    EXPECT_EQ(formatNumber(-0.5), "-0.5") << "files stay as they are";
}

TEST(Language, NumbersAreReadWithAPointOrAComma) {
    for (const char* language : {"en", "es"}) {
        Speaking speaking(language);
        EXPECT_EQ(parseShownNumber("0.5"), 0.5);
        EXPECT_EQ(parseShownNumber("0,5"), 0.5);
        EXPECT_EQ(parseShownNumber(" -1,25e-3 "), -1.25e-3);
        EXPECT_EQ(parseShownNumber(shownNumber(0.1)), 0.1);
        for (const char* no : {"", " ", "a", "1,2,3", "1.000,5", "0,5x", "nan", "inf", "1e999"})
            EXPECT_FALSE(parseShownNumber(no)) << no;
    }
}

}  // namespace
}  // namespace versorium
