// SPDX-License-Identifier: MIT
// What a text is taken for: refused where it could be meant otherwise, and shown as it was read.
#include <gtest/gtest.h>

#include "trace/formula.h"

namespace versorium {
namespace {

// The message of a text that is refused, else its reading.
std::string answerTo(const std::string& text) {
    const Expected<Formula> formula = parseFormula(text);
    return formula ? "read as " + formula->shown : formula.status().message();
}

void expectAnswer(const std::string& text, const std::string& part) {
    EXPECT_NE(answerTo(text).find(part), std::string::npos) << text << ": " << answerTo(text);
}

TEST(FormulaReading, NamesThatCouldBeProductsAreRefusedWithTheProduct) {
    expectAnswer("2iz", "did you mean i*z?");
    expectAnswer("z^2 + cz", "did you mean c*z?");
    expectAnswer("iz^2 + c", "did you mean i*z?");
    expectAnswer("az + b", "did you mean a*z?");
    expectAnswer("z2 + c", "did you mean z^2?");
    expectAnswer("sinz + c", "did you mean sin(z)?");
    expectAnswer("lambdaz*(1 - z)", "did you mean lambda*z?");
    expectAnswer("2piz", "did you mean pi*z?");
    expectAnswer("a*b*z + ab", "did you mean a*b?");
    expectAnswer("rx - rx^2", "did you mean r*x?");
    expectAnswer("x' = 1 - ax^2 + y, y' = b*x", "did you mean a*x?");
    expectAnswer("x' = xy, y' = b*x", "did you mean x*y?");
    expectAnswer("q^2 + jq", "did you mean j*q?");
}

TEST(FormulaReading, CapitalsOfKnownNamesAreRefused) {
    expectAnswer("Z^2 + c", "did you mean z?");
    expectAnswer("z^2 + C", "did you mean c in place of C?");
    expectAnswer("z^2 + 0.4I", "did you mean i in place of I?");
    expectAnswer("z^2 + PI", "did you mean pi in place of PI?");
    expectAnswer("z*Z + c", "did you mean z in place of Z?");
    expectAnswer("a*z^2 + A", "did you mean a in place of A?");
    expectAnswer("Sin(z) + c", "did you mean sin(…)?");
    expectAnswer("z^2 + 0.5j", "did you mean i?");
}

TEST(FormulaReading, ADeclarationTakesTheDoubtAway) {
    for (const char* text : {"z^2 + cz; cz = 2", "z^2 + C; C = 1", "z2*z + c; z2 = 1",
                             "z^2 + j; j = 1", "x' = xy, y' = x; xy = 1"})
        EXPECT_TRUE(parseFormula(text).ok()) << text << ": " << answerTo(text);
}

TEST(FormulaReading, NamesOfParametersStayWhatTheyAre) {
    for (const char* text : {"lambda*z*(1 - z)", "A*z^2 + B", "z^2 + c1*z + c0", "mu*z + xi",
                             "z^power + c", "zeta*z", "x' = mu*x + y, y' = eps*x", "r*x*(1 - x)",
                             "z^n - a*z + conj(c)", "x' = y, y' = delta*x - 0.15*y", "k*z^2 + c"})
        EXPECT_TRUE(parseFormula(text).ok()) << text << ": " << answerTo(text);
}

TEST(FormulaReading, ADecimalCommaIsNamedAsOne) {
    for (const char* text : {"z^2 + 0,3", "z^2 - 0,4 + 0,6*i", "x' = 1 - 1,4*x^2 + y, y' = 0,3*x",
                             "z^2 + c; c = 0,3", "max(abs(z), 0,3) + c"})
        expectAnswer(text, "decimals are written with a point");
    EXPECT_TRUE(parseFormula("min(x,0.3)*r").ok());
    expectAnswer("z^2 + 0, 3", "the plane, which are of x and y, not of z");
    expectAnswer("1, 3", "of x and y");
}

TEST(FormulaReading, NumbersAreDecimal) {
    expectAnswer("0x10*z", "numbers are decimal");
    expectAnswer("0b11*z", "numbers are decimal");
    EXPECT_TRUE(parseFormula("0.5z + 1e-3").ok());
}

TEST(FormulaReading, HeadsOfBooksAreUnderstood) {
    const Formula plain = *parseFormula("z^2 + c");
    for (const char* text : {"f(z) = z^2 + c", "z_{n+1} = z_n^2 + c", "z_{n+1} = z_{n}^2 + c",
                             "z_n+1 = z_n^2 + c", "z -> z^2 + c", "z := z^2 + c", "g(z):=z^2+c"}) {
        const Expected<Formula> read = parseFormula(text);
        ASSERT_TRUE(read.ok()) << text << ": " << answerTo(text);
        EXPECT_EQ(read->tape.nodes.size(), plain.tape.nodes.size()) << text;
        EXPECT_EQ(read->unicritical, true) << text;
    }
    expectAnswer("z**2", "powers are written with ^");
    expectAnswer("z = z^2 + c", "write z' = …");
    expectAnswer("z_{n+1} = z_n^2 + z_{n-1}", "none but this");
    EXPECT_TRUE(parseFormula("x_{n+1} = 1 - a*x_n^2 + y_n, y_{n+1} = b*x_n").ok());
}

TEST(FormulaReading, IsShownAsABookHasIt) {
    EXPECT_EQ(answerTo("z^2 + 2i*z"), "read as z² + 2·i·z");
    EXPECT_EQ(answerTo("z^-12*(z - 1)/pi"), "read as z⁻¹²·(z - 1)/π");
    EXPECT_EQ(answerTo("z^n + z^2.5"), "read as z^n + z^2.5");
    EXPECT_EQ(answerTo("(z^2)^3"), "read as (z²)³");
    EXPECT_EQ(answerTo("x' = 1 - a*x^2 + y, y' = b*x"), "read as x′ = 1 - a·x² + y, y′ = b·x");
}

// The one judge, for the command line, files, Find and the clipboard.
TEST(FormulaReading, OneJudgeSaysWhatIsMeantAsAFormula) {
    for (const char* text :
         {"2z", "z-c", "1e-3z", ".5z", "z", "-z^2+c", "z^2 + c", "z-C", "2iz", "f(z)=z^2+c"})
        EXPECT_TRUE(looksLikeFormula(text)) << text;
    for (const char* text :
         {"quadratic", "burning-ship", "quaternion-julia", "star", "leaf", "planar-cubic-a1", "w"})
        EXPECT_FALSE(looksLikeFormula(text)) << text;
}

}  // namespace
}  // namespace versorium
