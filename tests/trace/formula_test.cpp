// SPDX-License-Identifier: MIT
#include "trace/formula.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <cstring>

#include "base/random.h"
#include "maps/catalogue.h"
#include "trace/interpret.h"
#include "trace/program.h"

namespace versorium {
namespace {

using Long = std::complex<long double>;

Formula read(const std::string& text) {
    FormulaFault fault;
    Expected<Formula> formula = parseFormula(text, &fault);
    EXPECT_TRUE(formula.ok()) << withCaret(text, fault);
    return formula ? std::move(*formula) : Formula{};
}

// One step by the tape and by the program, which must agree to the bit.
std::vector<double> stepOf(const Formula& formula, std::vector<double> state,
                           const std::vector<double>& parameters) {
    std::vector<double> out(state.size());
    interpret(formula.tape, state.data(), parameters.data(), NothingBound{}, out.data());
    const Expected<TapeProgram> program = TapeProgram::make(formula.tape);
    EXPECT_TRUE(program.ok());
    runOnce(program->code(), state.data(), parameters.data());
    for (std::size_t k = 0; k < state.size(); ++k)
        EXPECT_TRUE(std::memcmp(&state[k], &out[k], sizeof(double)) == 0 ||
                    (std::isnan(state[k]) && std::isnan(out[k])))
            << formula.text << ": " << state[k] << " and " << out[k];
    return out;
}

std::complex<double> complexStep(const std::string& text, std::complex<double> z,
                                 const std::vector<double>& parameters = {}) {
    const auto out = stepOf(read(text), {z.real(), z.imag()}, parameters);
    return {out[0], out[1]};
}

// The value of a real formula without x, by giving it to a parameter's place.
double valueOf(const std::string& text) {
    return stepOf(read("x' = " + text + " + 0*a"), {0}, {1})[0];
}

// What a node computes, whatever its number: the order in which the operands of one operation are
// recorded is the compiler's.
std::string meaning(const Tape& tape, int index) {
    const Node& node = tape.nodes[static_cast<std::size_t>(index)];
    std::string text = std::to_string(static_cast<int>(node.op)) + "#" +
                       std::to_string(node.index) + "#" + std::to_string(node.constant) + "(";
    for (int operand : {node.a, node.b, node.c, node.d, node.e})
        if (operand >= 0) text += meaning(tape, operand) + ",";
    return text + ")";
}
std::vector<std::string> meaning(const Tape& tape) {
    std::vector<std::string> all;
    for (int output : tape.outputs) all.push_back(meaning(tape, output));
    return all;
}

TEST(Formula, LeavesTheVeryTapeOfABuiltInMap) {
    const auto same = [](const char* text, const char* map) {
        const Tape own = read(text).tape, builtIn = findMap(map)->trace();
        EXPECT_EQ(meaning(own), meaning(builtIn)) << text;
        EXPECT_EQ(own.nodes.size(), builtIn.nodes.size()) << text;
    };
    same("z^2 + c", "quadratic");
    same("z*(z^2 + a) + b", "cubic");
    same("(abs(z.re) + i*abs(im(z)))^2 + c", "burning-ship");
    same("z^power + c", "power");
    same("q^2 + c", "quaternion-quadratic");
    same("r*x*(1 - x)", "logistic");
}

TEST(Formula, ReadsOperatorsByTheirPrecedence) {
    EXPECT_EQ(valueOf("2 + 3*4"), 14);
    EXPECT_EQ(valueOf("2 - 3 - 4"), -5);
    EXPECT_EQ(valueOf("24/4/2"), 3);
    EXPECT_EQ(valueOf("-3^2"), -9);
    EXPECT_EQ(valueOf("(-3)^2"), 9);
    EXPECT_EQ(valueOf("2^3^2"), 512);
    EXPECT_EQ(valueOf("2^-2"), 0.25);
    EXPECT_EQ(valueOf("2*-3"), -6);
    EXPECT_EQ(valueOf("3 < 4 ? 1 : 2"), 1);
    EXPECT_EQ(valueOf("3 < 4 and not 2 < 1 ? 5 : 6"), 5);
    EXPECT_EQ(valueOf("1 < 0 or 2 < 1 and 1 < 2 ? 5 : 6"), 6);
    EXPECT_EQ(valueOf("if(2 >= 2, 7, 8)"), 7);
    EXPECT_EQ(valueOf("max(2, 3) + min(2, 3)*10"), 23);
    EXPECT_EQ(valueOf("floor(-1.5)"), -2);
    EXPECT_EQ(valueOf("1.5e2 + .5"), 150.5);
    EXPECT_NEAR(valueOf("cos(pi) + log(e)"), 0, 1e-15);
}

TEST(Formula, TakesANumberDirectlyBeforeANameAndNothingElse) {
    EXPECT_EQ(valueOf("2(3 + 4)"), 14);
    EXPECT_EQ(complexStep("2z^2 + 0.5i", {1, 1}), std::complex<double>(0, 4.5));
    EXPECT_EQ(complexStep("z² + z³", {0, 1}), std::complex<double>(-1, -1));
    EXPECT_EQ(complexStep("2·z − 1", {3, 1}), std::complex<double>(5, 2));
    for (const char* text : {"z(z + 1)", "z c", "(z + 1)(z - 1)", "1/2z", "z^2c", "2 z"})
        EXPECT_FALSE(parseFormula(text).ok()) << text;
}

TEST(Formula, InfersWhereItLivesAndWhatItsParametersAre) {
    const Formula complex = read("z^n - a*z + conj(c)");
    EXPECT_EQ(complex.space, FormulaSpace::complex);
    ASSERT_EQ(complex.parameters.size(), 3u);
    EXPECT_EQ(complex.parameters[0].name, "n");
    EXPECT_EQ(complex.parameters[0].kind, FormulaKind::real);
    EXPECT_EQ(complex.parameters[1].kind, FormulaKind::complex);

    const Formula plane = read("x' = 1 - a*x^2 + y, y' = b*x");
    EXPECT_EQ(plane.space, FormulaSpace::plane);
    ASSERT_EQ(plane.parameters.size(), 2u);
    EXPECT_EQ(plane.parameters[1].kind, FormulaKind::real);
    EXPECT_EQ(describe(read("1 - a*x^2 + y, b*x").tape), describe(plane.tape));

    EXPECT_EQ(read("q^2 + c").space, FormulaSpace::quaternion);
    EXPECT_EQ(read("q^2 + c").parameters[0].kind, FormulaKind::quaternion);
    EXPECT_EQ(read("r*x*(1 - x)").space, FormulaSpace::line);
    EXPECT_EQ(read("z -> q*z").parameters[0].name, "q");
}

TEST(Formula, TakesDeclarations) {
    const Formula formula = read("z^3 - a*z + c; a: real = 1/2 in [0, 4]; c = -0.75 + 0.1i");
    EXPECT_EQ(formula.parameters[0].kind, FormulaKind::real);
    EXPECT_EQ(formula.parameters[0].value[0], 0.5);
    EXPECT_EQ(formula.parameters[0].high, 4);
    EXPECT_EQ(formula.parameters[1].value[0], -0.75);
    EXPECT_EQ(formula.parameters[1].value[1], 0.1);
    EXPECT_EQ(formula.text, "z^3 - a*z + c; a: real = 0.5 in [0, 4]; c = -0.75 + 0.1*i");
    EXPECT_EQ(formula.body, "z^3 - a*z + c");
    const Formula quaternion = read("q^2 + c; c = 0.1 - 0.2j + 0.3k");
    EXPECT_EQ(quaternion.parameters[0].value, (std::array<double, 4>{0.1, 0, -0.2, 0.3}));
}

// Every fault points at the character where a reader would look.
TEST(Formula, PointsAtWhatIsWrong) {
    struct Case {
        const char* text;
        std::size_t position;
        const char* says;
    };
    const Case cases[] = {
        {"", 0, "the end"},
        {"z^2 +", 5, "a number, a name or \"(\" is expected, not the end"},
        {"z^2 + * c", 6, "not \"*\""},
        {"z^2 + c)", 7, "not \")\""},
        {"(z + 1", 6, "\")\" is expected"},
        {"foo(z)", 0, "no function \"foo\""},
        {"z(z + 1)", 1, "write z*(…)"},
        {"z c", 2, "operator"},
        {"a + b", 0, "speaks of z"},
        {"z**2", 1, "^"},
        {"1/2z", 3, "two things"},
        {"z^2c", 3, "two things"},
        {"z < 1", 0, "only real numbers"},
        {"abs(z) < 1", 7, "comparison"},
        {"if(z, 1, 2)", 3, "comparison"},
        {"min(z, 1)", 4, "a real number is expected"},
        {"min(1, z)", 7, "a real number is expected"},
        {"z + (1 < 2)", 7, "not a comparison"},
        {"1 < abs(z) < 2 ? z : 0", 11, "chain"},
        {"x' = y", 6, "y' = …"},
        {"x' = 1, x' = y", 8, "y' = …"},
        {"y' = x", 0, "needs an x'"},
        {"x' = i*x + y, y' = x", 5, "real numbers"},
        {"z = z^2", 2, "write z' ="},
        {"x^2", 3, "needs a parameter"},
        {"z^2 + c; d = 1", 9, "no parameter \"d\""},
        {"z^2 + c; c: sedenion", 12, "real, whole, complex"},
        {"z^2 + c; c: quaternion", 9, "no quaternion parameters"},
        {"z^2 + c; c = c", 13, "numbers alone"},
        {"z^2 + c; c = 1; c = 2", 16, "twice"},
        {"z^2 + c; i = 1", 9, "meaning of its own"},
        {"z^n; n: whole = 1.5", 16, "whole number"},
        {"z + a; a: real = i", 17, "real number"},
        {"z^2 + c in [2, 1]", 8, "operator"},
        {"z^2 + c; c in [2, 1]", 19, "lower end"},
        {"z^2 + 1e200*c", 6, "too large"},
        {"q^q", 2, "exponent"},
        {"z.w2", 2, "component"},
        {"z.y", 1, "components"},
        {"|z| + c", 0, "abs(z)"},
        {"zé", 1, "not \"é\""},
    };
    for (const Case& one : cases) {
        FormulaFault fault;
        const Expected<Formula> formula = parseFormula(one.text, &fault);
        ASSERT_FALSE(formula.ok()) << one.text;
        EXPECT_EQ(fault.position, one.position) << one.text << ": " << fault.message;
        EXPECT_NE(fault.message.find(one.says), std::string::npos)
            << one.text << ": " << fault.message;
    }
    EXPECT_EQ(withCaret("é + *", {4, "no"}), "no\n    é + *\n        ^");
}

TEST(Formula, IsBounded) {
    const auto refused = [](const std::string& text, const char* says) {
        const Expected<Formula> formula = parseFormula(text);
        ASSERT_FALSE(formula.ok());
        EXPECT_NE(formula.status().message().find(says), std::string::npos)
            << formula.status().message();
    };
    refused(std::string(1001, 'z'), "at most 1000 characters");
    refused(std::string(100, '(') + "z", "more than 64 deep");
    refused(std::string(100, '-') + "z", "more than 64 deep");
    std::string tower = "z";
    for (int k = 0; k < 70; ++k) tower += "^z";
    refused(tower, "more than 64 deep");
    refused(std::string(30, 'a') + "*z", "at most 24 characters");
    refused("z + " + std::string(50, '1'), "at most 40 characters");
    std::string many = "z";
    for (int k = 0; k < 20; ++k) many += " + c" + std::to_string(k);
    refused(many, "more than 32 numbers");
    std::string nested = "z";
    for (int k = 0; k < 60; ++k) nested = "asin(" + nested + ")";
    refused(nested, "more than 4000 operations");
    // Multiplied out this would be a million operations: its critical points are found otherwise.
    std::string powers = "z";
    for (int k = 1; powers.size() < 700; ++k) powers += "+(z-" + std::to_string(k) + "a)^30";
    EXPECT_EQ(read(powers).degree, 0);
    // As long as it may be, and no deeper than a sum.
    std::string sum = "z";
    while (sum.size() + 2 <= 1000) sum += "+z";
    EXPECT_EQ(complexStep(sum, {1, 0}).real(), (static_cast<double>(sum.size()) + 1) / 2);
}

// The program keeps every rounding of the tape, whatever it fuses and reorders.
TEST(Formula, SwapsAndCirclesAreKept) {
    const auto swapped = stepOf(read("x' = y, y' = x"), {3, 5}, {});
    EXPECT_EQ(swapped, (std::vector<double>{5, 3}));
    const auto turned = stepOf(read("x' = x + y, y' = x - y"), {3, 5}, {});
    EXPECT_EQ(turned, (std::vector<double>{8, -2}));
    const auto mixed = stepOf(read("x' = y + 1, y' = x*y + (x + y)"), {3, 5}, {});
    EXPECT_EQ(mixed, (std::vector<double>{6, 23}));
    const auto conjugate = stepOf(read("conj(q)*i"), {1, 2, 3, 4}, {});
    EXPECT_EQ(conjugate, (std::vector<double>{2, 1, -4, 3}));
}

// Elementary functions on their principal branches, against those of the system in long double.
TEST(Formula, FunctionsAreThoseOfTheTextbook) {
    struct Case {
        const char* text;
        Long (*function)(Long);
        double tolerance;
    };
    const Case cases[] = {
        {"exp(z)", [](Long z) { return std::exp(z); }, 4e-16},
        {"log(z)", [](Long z) { return std::log(z); }, 4e-16},
        {"sqrt(z)", [](Long z) { return std::sqrt(z); }, 4e-16},
        {"sin(z)", [](Long z) { return std::sin(z); }, 1e-15},
        {"cos(z)", [](Long z) { return std::cos(z); }, 1e-15},
        {"tan(z)", [](Long z) { return std::tan(z); }, 1e-14},
        {"sinh(z)", [](Long z) { return std::sinh(z); }, 1e-15},
        {"cosh(z)", [](Long z) { return std::cosh(z); }, 1e-15},
        {"tanh(z)", [](Long z) { return std::tanh(z); }, 1e-14},
        {"asin(z)", [](Long z) { return std::asin(z); }, 2e-15},
        {"acos(z)", [](Long z) { return std::acos(z); }, 2e-15},
        {"atan(z)", [](Long z) { return std::atan(z); }, 2e-15},
        {"asinh(z)", [](Long z) { return std::asinh(z); }, 2e-15},
        {"acosh(z)", [](Long z) { return std::acosh(z); }, 2e-15},
        {"atanh(z)", [](Long z) { return std::atanh(z); }, 2e-15},
        {"z^2.5", [](Long z) { return std::pow(z, Long(2.5L)); }, 4e-15},
        {"z^-3", [](Long z) { return Long(1) / (z * z * z); }, 2e-15},
        {"z^z", [](Long z) { return std::exp(z * std::log(z)); }, 2e-14},
        {"abs(z)*norm(z)*arg(z)",
         [](Long z) { return Long(std::abs(z) * std::norm(z) * std::arg(z)); }, 2e-15},
        {"re(z) - i*im(z) + conj(z)*i",
         [](Long z) { return std::conj(z) + std::conj(z) * Long(0, 1); }, 1e-15},
        {"(1 + i)/(z - 2i)", [](Long z) { return Long(1, 1) / (z - Long(0, 2)); }, 2e-15},
    };
    Random random(31);
    for (const Case& one : cases) {
        const Formula formula = read(one.text);
        for (int k = 0; k < 300; ++k) {
            const double reach = k % 3 == 0 ? 0.2 : 3;
            const double x = random.uniform(-reach, reach), y = random.uniform(-reach, reach);
            const Long expected = one.function(Long(x, y));
            const auto got = stepOf(formula, {x, y}, {});
            const long double error =
                std::abs(Long(got[0], got[1]) - expected) / std::max(1e-300L, std::abs(expected));
            // Relative to the modulus; a few roundings of the terms that the value is made of.
            const long double condition = 1 + 1 / std::abs(expected);
            EXPECT_LE(error, one.tolerance * condition)
                << one.text << " at " << x << ", " << y << ": " << got[0] << ", " << got[1];
        }
    }
}

TEST(Formula, CutsAreSeenFromAbove) {
    const double pi = std::acos(-1.0);
    EXPECT_EQ(complexStep("log(z)", {-1, -0.0}).imag(), pi);
    EXPECT_EQ(complexStep("sqrt(z)", {-4, -0.0}), std::complex<double>(0, 2));
    EXPECT_EQ(complexStep("sqrt(z)", {0, 0}), std::complex<double>(0, 0));
    EXPECT_EQ(complexStep("z^(1 + i)", {0, 0}), std::complex<double>(0, 0));
    EXPECT_EQ(complexStep("sqrt(re(z))", {-4, 0}), std::complex<double>(0, 2));
}

// A quaternion function is the complex one in the plane of its argument.
TEST(Formula, QuaternionFunctionsFollowTheComplexOnes) {
    for (const char* function : {"exp", "log", "sqrt", "sin", "cosh", "tan", "atan", "asin"}) {
        const auto z = complexStep(std::string(function) + "(z)", {0.4, 0.7});
        const auto q = stepOf(read(std::string(function) + "(q)"), {0.4, 0, 0.7, 0}, {});
        EXPECT_NEAR(q[0], z.real(), 1e-15) << function;
        EXPECT_NEAR(q[2], z.imag(), 1e-15) << function;
        EXPECT_EQ(q[1], 0) << function;
        EXPECT_EQ(q[3], 0) << function;
    }
    EXPECT_EQ(stepOf(read("i*q*j"), {1, 2, 3, 4}, {}), (std::vector<double>{4, -3, -2, 1}));
}

TEST(Formula, KnowsPolynomialsAndWhatMovesCriticalPoints) {
    const auto facts = [](const char* text, int degree, bool unicritical,
                          const std::vector<bool>& moves) {
        const Formula formula = read(text);
        EXPECT_EQ(formula.degree, degree) << text;
        EXPECT_EQ(formula.unicritical, unicritical) << text;
        EXPECT_EQ(formula.movesCritical, moves) << text;
    };
    facts("z^2 + c", 2, true, {false, false});
    facts("z^5 + a*c", 5, true, {false, false, false, false});
    facts("c*sin(z)", 0, false, {false, false});
    facts("c*z*(1 - z) + 2", 2, false, {false, false});
    facts("-(z^3 - a*z)/b + c", 3, false, {true, true, false, false, false, false});
    facts("c*sin(a*z)", 0, false, {false, false, true, true});
    facts("(z^2 + c)^2 + c", 4, false, {true, true});
}

// Random texts: formulas that are cut, mixed up and strewn with odd characters, and plain noise.
TEST(Formula, SurvivesAnyText) {
    const std::vector<std::string> pieces = {
        "z",    "q",   "x",    "y",     "c", "a",  "+",    "-",   "*",    "/",    "^",    "(",
        ")",    ",",   ";",    "'",     "=", "->", "2",    "0.5", "1e9",  "i",    "j",    "pi",
        "sin(", "if(", "min(", "conj(", " ", "<",  "==",   "and", "not",  "?",    ":",    ".re",
        "in",   "[",   "]",    "real",  "²", "π",  "\xff", "\n",  "abs(", "x' =", "y' =", "1e400"};
    const std::vector<std::string> whole = {
        "z^3 - a*z + conj(c); a: real = 0.5 in [0, 4]; c = -0.75 + 0.1i",
        "x' = 1 - a*x^2 + y, y' = b*x; a = 1.4; b = 0.3",
        "if(abs(z) < 1 and not re(z) >= 2, sin(z)/2, z^-2.5) + c", "q^2*i + exp(c).x*j",
        "z -> (|z| < 1 ? 2z : z³) + π"};
    Random random(77);
    int good = 0;
    for (int k = 0; k < 30000; ++k) {
        std::string text;
        const int length = static_cast<int>(random.uniform(0, 24));
        for (int i = 0; i < length; ++i)
            text += pieces[static_cast<std::size_t>(
                random.uniform(0, static_cast<double>(pieces.size())))];
        if (k % 3 == 0) {
            text = whole[static_cast<std::size_t>(k / 3) % whole.size()];
            for (int edits = k % 4; edits >= 0; --edits) {
                const auto place =
                    static_cast<std::size_t>(random.uniform(0, static_cast<double>(text.size())));
                const std::string& piece = pieces[static_cast<std::size_t>(
                    random.uniform(0, static_cast<double>(pieces.size())))];
                edits % 2 ? text.erase(place, 1) : text.insert(place, piece);
            }
        }
        if (k % 10 == 0)
            for (char& c : text) c = static_cast<char>(random.uniform(1, 255));
        FormulaFault fault;
        const Expected<Formula> formula = parseFormula(text, &fault);
        if (formula) {
            ++good;
        } else {
            EXPECT_LE(fault.position, text.size()) << text;
            EXPECT_FALSE(fault.message.empty());
        }
    }
    EXPECT_GT(good, 300);
}

std::string randomTerm(Random& random, int depth, bool truth = false) {
    const auto pick = [&](std::vector<std::string> all) {
        return all[static_cast<std::size_t>(random.uniform(0, static_cast<double>(all.size())))];
    };
    const auto term = [&] { return randomTerm(random, depth - 1); };
    if (truth) {
        const std::string simple = "abs(" + term() + ")" + pick({" < ", " >= ", " == "}) + "1.5";
        return depth < 1 || random.uniform(0, 1) < 0.6
                   ? simple
                   : pick({"not (", "("}) + simple + pick({" and ", " or "}) +
                         randomTerm(random, depth - 1, true) + ")";
    }
    if (depth < 1) return pick({"z", "z", "c", "a", "i", "0.5", "3", "pi", "z.re", "-z"});
    switch (static_cast<int>(random.uniform(0, 8))) {
        case 0:
            return term() + " + " + term();
        case 1:
            return term() + " - " + term();
        case 2:
            return "(" + term() + ")*" + pick({"", "-"}) + "(" + term() + ")";
        case 3:
            return "(" + term() + ")/(" + term() + ")";
        case 4:
            return "(" + term() + ")^" + pick({"2", "3", "-1", "0.5", "a", "2^2"});
        case 5:
            return pick({"sin", "exp", "sqrt", "conj", "abs", "log", "tanh", "im"}) + "(" + term() +
                   ")";
        case 6:
            return "-(" + term() + ")";
        default:
            return "if(" + randomTerm(random, depth - 1, true) + ", " + term() + ", " + term() +
                   ")";
    }
}

// The normal form of a formula reads back as the same formula, and is its own normal form.
TEST(Formula, NormalFormReadsBackAsTheSameTape) {
    Random random(78);
    int read = 0;
    for (int k = 0; k < 1500; ++k) {
        const std::string text = randomTerm(random, 1 + k % 4) + " + z";
        const Expected<Formula> formula = parseFormula(text);
        if (!formula) continue;
        ++read;
        const Expected<Formula> again = parseFormula(formula->text);
        ASSERT_TRUE(again.ok()) << text << " became " << formula->text << ": "
                                << again.status().message();
        EXPECT_EQ(again->text, formula->text) << text;
        EXPECT_EQ(describe(again->tape), describe(formula->tape)) << text;
        const std::size_t numbers = static_cast<std::size_t>(formula->tape.parameterSize);
        if (TapeProgram::make(formula->tape).ok())
            stepOf(*formula, {0.3, -0.4}, std::vector<double>(numbers, 0.7));
    }
    EXPECT_GT(read, 1000);
}

}  // namespace
}  // namespace versorium
